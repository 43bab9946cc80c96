import {
  type Object3D,
  type OrthographicCamera,
  type PerspectiveCamera,
  Scene,
  type ShaderMaterial,
  type Texture,
} from 'three';
import type { Palette } from '../colors/palette';
import type { Appearance } from '../model/appearance';
import type { FlatDrawing, LayoutDrawing, MeshDrawing } from '../model/drawing';
import { ChartEdges } from './chart-edges';
import { ChartFlags, type ChartStates } from './chart-flags';
import { ChartPicker } from './chart-picker';
import { defineShading } from './define';
import { type Chosen, choose, showMeasure } from './heat-uniforms';
import { LookTextures } from './look-textures';
import { DOT, OWN_BOUND, PointMarks } from './point-marks';
import { isMeasure, type Shading } from './shading';
import type { Pixel } from './sight';
import { MARKS, SlicedSurface } from './sliced-surface';
import { Stage } from './stage';
import { NONE_LIT } from './surface-material';

export interface SurfaceOptions {
  material: ShaderMaterial;
  /** The attributes of the triangles besides their marks. */
  attributes: ('position' | 'normal' | 'uv')[];
  camera: PerspectiveCamera | OrthographicCamera;
  /** Whether what is nearer hides what lies behind it. */
  depthTest: boolean;
  /** Width of the boundary, in css pixels. */
  outline: number;
}

export interface SurfaceEvents {
  /** Called before each picture. */
  prepare(): void;
  resized(stage: Stage): void;
}

/**
 * What both views show on their canvas: triangles, the boundary edges of charts, and marked vertices.
 * Objects with the same `renderOrder` are drawn in the order in which they were made, so what lies above
 * these is made later.
 */
export class SurfaceScene {
  readonly scene = new Scene();
  readonly stage: Stage;
  readonly triangles: SlicedSurface;
  readonly edges: ChartEdges;
  private readonly flags: ChartFlags;
  private readonly textures: LookTextures;
  private readonly picker: ChartPicker;
  private readonly dots: PointMarks;
  private readonly bounds: PointMarks;
  private shownShading: Shading = 'plain';
  private palette: Palette | null = null;
  private hasCharts = false;

  /** Throws NoWebGl if the browser offers no WebGL 2. */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly options: SurfaceOptions,
    private readonly events: SurfaceEvents,
  ) {
    const { material, attributes, depthTest, outline } = options;
    this.stage = new Stage(
      canvas,
      () => this.draw(),
      () => this.resized(),
      () => this.triangles.isBlank,
    );
    const { renderer } = this.stage;
    this.picker = new ChartPicker(renderer, depthTest);
    this.flags = new ChartFlags([material, this.picker.material]);
    this.textures = new LookTextures(renderer, material);
    this.triangles = new SlicedSurface(renderer, material, [...attributes, ...MARKS]);
    this.edges = new ChartEdges(outline, depthTest);
    this.dots = new PointMarks({ ...DOT, depthTest });
    this.bounds = new PointMarks({ ...OWN_BOUND, depthTest });
    this.scene.add(
      this.triangles.object,
      ...this.edges.objects,
      this.dots.object,
      this.bounds.object,
    );
  }

  /** Resolves when pictures can be drawn without waiting for shaders; `others`: shown in each of them. */
  start(others: Object3D[] = []): Promise<void> {
    const first = [...others, this.triangles.object, this.edges.boundary.object];
    return this.stage.start(this.scene, this.options.camera, first);
  }

  /** Shows what goes with the triangles that have arrived; `flat`: null before they are flattened. */
  showMarks({ edges, dots }: MeshDrawing | LayoutDrawing, flat: FlatDrawing | null): void {
    this.edges.show(edges, flat?.edgeCharts ?? new Uint32Array());
    this.dots.show(dots);
    this.hasCharts = Boolean(flat?.chartColors);
    this.colorBoundary();
  }

  get isAtlas(): boolean {
    return this.hasCharts;
  }

  /** xyz and rgb per vertex that has a bound of its own. */
  markBounds(points: Float32Array, tints: Float32Array): void {
    this.bounds.show(points, tints);
    this.invalidate();
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.stage.renderer.setClearColor(palette.background);
    this.edges.setColors(palette.boundary, palette.flipped);
    this.dots.setColor(palette.tightened);
    this.colorBoundary();
  }

  get shading(): Shading {
    return this.shownShading;
  }

  /** `picture`: what a shading needs that shows one. */
  setShading(shading: Shading, picture: Texture | null): void {
    const { material } = this.options;
    this.shownShading = shading;
    defineShading(material, shading, picture);
    if (isMeasure(shading)) showMeasure(material, shading);
    this.colorBoundary();
  }

  /** How the mesh looks in its file; null if that is not known. */
  setAppearance(appearance: Appearance | null): void {
    this.textures.show(appearance);
    this.colorBoundary();
  }

  get showsMaterials(): boolean {
    return this.shownShading === 'materials' && !this.textures.isEmpty;
  }

  /** Lights some triangles of the heat map only; null: all. */
  choose(chosen: Chosen | null): void {
    choose(this.options.material, chosen);
    this.invalidate();
  }

  /** Highlights one chart; null: none. */
  light(chart: number | null): void {
    this.options.material.uniforms.lit.value = chart ?? NONE_LIT;
    this.invalidate();
  }

  /** `moving`: drawn above the others. */
  showStates(states: ChartStates, moving?: Iterable<number>): void {
    this.flags.show(states, moving);
    this.edges.showStates(states);
    this.invalidate();
  }

  /** The chart at a pixel; null if there is none. */
  chartAt(at: Pixel): number | null {
    return this.picker.chartAt(at, this.triangles.object, this.options.camera, this.stage);
  }

  /** How far between the near and the far plane the surface is at a pixel; null if it is not there. */
  depthAt(at: Pixel): number | null {
    return this.picker.depthAt(at, this.triangles.object, this.options.camera, this.stage);
  }

  invalidate(): void {
    this.stage.invalidate();
  }

  private colorBoundary(): void {
    if (!this.palette) return;
    // What is dark on charts is not seen on every picture.
    const isOnPicture = this.showsMaterials || this.shading === 'image';
    const isDark = this.isAtlas && !isOnPicture;
    this.edges.boundary.setColor(isDark ? this.palette.seam : this.palette.boundary);
  }

  private resized(): void {
    const { stage } = this;
    this.options.material.uniforms.pixelRatio.value = stage.pixelRatio;
    for (const marks of [this.dots, this.bounds]) marks.setPixelRatio(stage.pixelRatio);
    this.edges.setResolution(stage.width, stage.height);
    this.events.resized(stage);
  }

  private draw(): void {
    if (!this.triangles.advance()) {
      // The current picture stays until all of the next surface has arrived.
      this.invalidate();
      return;
    }
    this.events.prepare();
    this.stage.renderer.render(this.scene, this.options.camera);
  }
}
