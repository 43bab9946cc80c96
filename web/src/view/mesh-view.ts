import { PerspectiveCamera, Scene, Spherical, type Texture, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Palette } from '../colors/palette';
import { type Direction, frontOf } from '../drawing/front';
import { facingOf } from '../mesh/mesh';
import type { Appearance } from '../model/appearance';
import { type Drawing, type FirstView, type FlatDrawing, FRAME } from '../model/drawing';
import { ChartEdges } from './chart-edges';
import { ChartFlags, type ChartStates } from './chart-flags';
import { ChartPicker } from './chart-picker';
import { define, defineShading } from './define';
import { fitInView } from './fit-in-view';
import { type Chosen, choose, showMeasure } from './heat-uniforms';
import { LookTextures } from './look-textures';
import { DOT, OWN_BOUND, PointMarks } from './point-marks';
import { type SeamMarks, SeamOverlay } from './seam-overlay';
import { isMeasure, type Shading } from './shading';
import { type Pixel, Sight } from './sight';
import { MARKS, SlicedSurface } from './sliced-surface';
import { Stage } from './stage';
import { createSurfaceMaterial, NONE_LIT, paintSurface, SurfacePaint } from './surface-material';

const FIELD_OF_VIEW = 32;
/** Fraction of the view's width or height that a fitted mesh fills. */
const FILLED = 0.88;
/** Radians per key press, and zoom factor. */
const TURN = Math.PI / 24;
const ZOOM = 1.15;
/** Seen from above, y is still slightly up. */
const ABOVE = 1e-3;

/** A view of points (xyz each); `direction`: from them to the eye. */
interface Look {
  points: Float32Array;
  direction: Direction;
}

/** The mesh in 3D. */
export class MeshView {
  private readonly stage: Stage;
  /** Resolves when pictures can be drawn without waiting for shaders. */
  readonly ready: Promise<void>;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private readonly material = createSurfaceMaterial();
  private readonly surface: SlicedSurface;
  private readonly picker: ChartPicker;
  private readonly flags: ChartFlags;
  private readonly textures: LookTextures;
  private readonly edges = new ChartEdges(1.75, true);
  private readonly dots = new PointMarks({ ...DOT, depthTest: true });
  private readonly bounds = new PointMarks({ ...OWN_BOUND, depthTest: true });
  private readonly seams = new SeamOverlay();
  /** `FRAME` of each shown chart. */
  private frames: Float32Array = new Float32Array();
  private first: FirstView = {
    front: [0, 0, 1],
    outline: new Float32Array(),
    hull: new Float32Array(),
  };
  /** The direction it was last viewed from, and the points that had to fit in the view. */
  private from: Look = { direction: [0, 0, 1], points: new Float32Array() };
  /** Until the user turns or zooms, the mesh stays fitted however the pane changes. */
  private isFitted = true;
  private isFlat = false;
  private isAtlas = false;
  private palette: Palette | null = null;
  private flatPaint: SurfacePaint = SurfacePaint.Checker;
  private shading: Shading = 'plain';
  private wireOpacity = 0.5;
  private showsWireframe = false;

  constructor(
    readonly canvas: HTMLCanvasElement,
    reducedMotion: boolean,
  ) {
    this.stage = new Stage(
      canvas,
      () => this.draw(),
      () => this.resized(),
      () => this.surface.isBlank,
    );
    this.picker = new ChartPicker(this.stage.renderer, true);
    this.flags = new ChartFlags([this.material, this.picker.material]);
    this.textures = new LookTextures(this.stage.renderer, this.material);
    this.surface = new SlicedSurface(this.stage.renderer, this.material, [
      'position',
      'normal',
      'uv',
      ...MARKS,
    ]);
    this.scene.add(
      this.surface.object,
      ...this.edges.objects,
      this.dots.object,
      this.bounds.object,
      this.seams.object,
    );
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !reducedMotion;
    this.controls.dampingFactor = 0.12;
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 30;
    this.controls.addEventListener('change', () => this.stage.invalidate());
    this.controls.addEventListener('start', () => {
      this.isFitted = false;
    });
    canvas.addEventListener('keydown', (event) => this.onKey(event));
    const first = [this.surface.object, this.edges.boundary.object];
    this.ready = this.stage.start(this.scene, this.camera, first);
  }

  /**
   * Shows a mesh, with a checkerboard or its charts if it is flattened. Keeps the point of view
   * unless the mesh was just opened.
   */
  show(drawing: Drawing | FlatDrawing): void {
    const { mesh } = drawing;
    const flat = 'marks' in drawing ? drawing : null;
    const { position, normal, uv } = mesh;
    this.surface.show({ position, normal, ...(uv && { uv }), ...flat?.marks }, () => {
      this.edges.show(mesh.edges, flat?.edgeCharts ?? new Uint32Array());
      this.dots.show(mesh.dots);
      this.isAtlas = Boolean(flat?.chartColors);
      this.flatPaint = this.isAtlas ? SurfacePaint.Charts : SurfacePaint.Checker;
      this.isFlat = flat !== null;
      if (mesh.cells) {
        this.material.uniforms.uvOrigin.value.set(...mesh.cells.origin);
        this.material.uniforms.uvCell.value = mesh.cells.cell;
      }
      this.setUniforms();
    });
    this.frames = mesh.frames;
    this.stage.invalidate();
    if (!mesh.first) return;
    this.first = mesh.first;
    this.reset();
  }

  picture(): Promise<HTMLCanvasElement> {
    return this.stage.picture();
  }

  /** The most texels along a side of a picture. */
  get mostTexels(): number {
    return this.stage.renderer.capabilities.maxTextureSize;
  }

  /** What the camera sees now. */
  get sight(): Sight {
    return new Sight(this.camera, this.stage.width, this.stage.height);
  }

  /** `turned` is called when the point of view has changed. */
  onTurn(turned: () => void): void {
    this.controls.addEventListener('change', turned);
  }

  /** `points` has xyz per vertex, in the unit sphere. */
  markSeams(points: Float32Array, marks: SeamMarks): void {
    if (this.seams.show(points, marks)) this.stage.invalidate();
  }

  /** xyz and rgb per vertex. */
  markBounds(points: Float32Array, tints: Float32Array): void {
    this.bounds.show(points, tints);
    this.stage.invalidate();
  }

  private colorBoundary(): void {
    if (!this.palette) return;
    // What is dark on charts is not seen on every picture.
    const isOnPicture = this.shading === 'image' || this.paintOfMesh === SurfacePaint.Materials;
    const isDark = this.isAtlas && !isOnPicture;
    this.edges.boundary.setColor(isDark ? this.palette.seam : this.palette.boundary);
  }

  setPalette(palette: Palette): void {
    this.stage.renderer.setClearColor(palette.background);
    paintSurface(this.material, palette);
    this.palette = palette;
    this.edges.setColors(palette.boundary, palette.flipped);
    this.dots.setColor(palette.tightened);
    this.seams.setPalette(palette);
    this.wireOpacity = palette.wireOpacity;
    this.paint();
  }

  setWireframe(shows: boolean): void {
    this.showsWireframe = shows;
    define(this.material, 'WIRE', shows);
    this.paint();
  }

  /** `picture`: what a shading needs that shows one. */
  setShading(shading: Shading, picture: Texture | null): void {
    this.shading = shading;
    defineShading(this.material, shading, picture);
    if (isMeasure(shading)) showMeasure(this.material, shading);
    this.paint();
  }

  /** How the mesh looks in its file; null if that is not known. */
  setAppearance(appearance: Appearance | null): void {
    this.textures.show(appearance);
    this.paint();
  }

  /** Lights some triangles of the heat map only; null: all. */
  choose(chosen: Chosen | null): void {
    choose(this.material, chosen);
    this.stage.invalidate();
  }

  /** The chart at a pixel; null if there is none. */
  chartAt(at: Pixel): number | null {
    if (!this.isFlat) return null;
    return this.picker.chartAt(at, this.surface.object, this.camera, this.stage);
  }

  showStates(states: ChartStates): void {
    this.flags.show(states);
    this.edges.showStates(states);
    this.stage.invalidate();
  }

  /** Highlights one chart; null: none. */
  light(chart: number | null): void {
    this.material.uniforms.lit.value = chart ?? NONE_LIT;
    this.stage.invalidate();
  }

  /** Turns the view to some charts. */
  goTo(charts: number[]): void {
    const frame = unionOf(this.frames, charts);
    if (!(frame[FRAME.low] <= frame[FRAME.high])) return;
    const now = this.camera.position.clone().sub(this.controls.target).normalize();
    const area = frame.subarray(FRAME.area, FRAME.area + 3);
    const direction = frontOf(facingOf(area, frame[FRAME.total]), now.toArray());
    this.look({ points: cornersOf(frame), direction });
    this.isFitted = false;
  }

  reset(): void {
    this.fit({ points: this.first.outline, direction: this.first.front });
  }

  /** Looks from the opposite side. */
  turnRound(): void {
    const { x, y, z } = this.camera.position.clone().sub(this.controls.target).normalize();
    this.lookFrom([-x, y, -z]);
  }

  private lookFrom(direction: Direction): void {
    this.fit({ points: this.first.hull, direction });
  }

  private fit(from: Look): void {
    this.from = from;
    this.look(from);
    this.isFitted = true;
  }

  private look({ points, direction }: Look): void {
    this.stopDamping();
    const front = new Vector3(...direction);
    const up = Math.tan((this.camera.fov * Math.PI) / 360) * FILLED;
    const { target, distance } = fitInView(points, front, up * this.camera.aspect, up);
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(front, distance);
    this.controls.update();
    this.stage.invalidate();
  }

  /** Ends a motion that is still dying down: without damping, one update uses up all of it. */
  private stopDamping(): void {
    const { enableDamping } = this.controls;
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = enableDamping;
  }

  private paint(): void {
    this.setUniforms();
    this.stage.invalidate();
  }

  private get paintOfLayout(): SurfacePaint {
    if (isMeasure(this.shading)) return SurfacePaint.Heat;
    if (this.shading === 'grid' || this.shading === 'image') return SurfacePaint.Picture;
    return this.paintOfMesh || this.flatPaint;
  }

  private get paintOfMesh(): SurfacePaint {
    return this.shading === 'materials' && !this.textures.isEmpty
      ? SurfacePaint.Materials
      : SurfacePaint.Clay;
  }

  private setUniforms(): void {
    this.material.uniforms.paint.value = this.isFlat ? this.paintOfLayout : this.paintOfMesh;
    this.material.uniforms.wire.value = this.showsWireframe ? this.wireOpacity : 0;
    this.colorBoundary();
  }

  private resized(): void {
    this.camera.aspect = this.stage.width / this.stage.height;
    this.camera.updateProjectionMatrix();
    this.material.uniforms.pixelRatio.value = this.stage.pixelRatio;
    for (const marks of [this.dots, this.bounds]) marks.setPixelRatio(this.stage.pixelRatio);
    this.edges.setResolution(this.stage.width, this.stage.height);
    this.seams.setSize(this.stage.width, this.stage.height, this.stage.pixelRatio);
    if (this.isFitted) this.fit(this.from);
  }

  private draw(): void {
    if (this.surface && !this.surface.advance()) {
      // The current picture stays until all of the next surface has arrived.
      this.stage.invalidate();
      return;
    }
    // With damping, update() continues the motion and asks for the next frame through its change
    // event.
    this.controls?.update();
    this.stage?.renderer.render(this.scene, this.camera);
  }

  private onKey(event: KeyboardEvent): void {
    const turn = (theta: number, phi: number) => this.turn(theta, phi, 1);
    const actions: Record<string, () => void> = {
      ArrowLeft: () => turn(-TURN, 0),
      ArrowRight: () => turn(TURN, 0),
      ArrowUp: () => turn(0, -TURN),
      ArrowDown: () => turn(0, TURN),
      '+': () => this.turn(0, 0, 1 / ZOOM),
      '=': () => this.turn(0, 0, 1 / ZOOM),
      '-': () => this.turn(0, 0, ZOOM),
      Home: () => this.reset(),
      '0': () => this.reset(),
      '1': () => this.lookFrom([0, 0, 1]),
      '3': () => this.lookFrom([1, 0, 0]),
      '7': () => this.lookFrom([0, 1, ABOVE]),
      '9': () => this.turnRound(),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }

  private turn(theta: number, phi: number, zoom: number): void {
    this.isFitted = false;
    const offset = this.camera.position.clone().sub(this.controls.target);
    const spherical = new Spherical().setFromVector3(offset);
    spherical.theta += theta;
    spherical.phi += phi;
    spherical.radius *= zoom;
    offset.setFromSpherical(spherical.makeSafe());
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.stage.invalidate();
  }
}

/** The `FRAME` of some charts together. */
function unionOf(frames: Float32Array, charts: number[]): Float32Array {
  const union = new Float32Array(FRAME.size);
  union.fill(Infinity, FRAME.low, FRAME.low + 3);
  union.fill(-Infinity, FRAME.high, FRAME.high + 3);
  for (const chart of charts) {
    const frame = frames.subarray(FRAME.size * chart, FRAME.size * (chart + 1));
    for (let d = 0; d < 3; ++d) {
      union[FRAME.low + d] = Math.min(union[FRAME.low + d], frame[FRAME.low + d]);
      union[FRAME.high + d] = Math.max(union[FRAME.high + d], frame[FRAME.high + d]);
      union[FRAME.area + d] += frame[FRAME.area + d];
    }
    union[FRAME.total] += frame[FRAME.total];
  }
  return union;
}

/** The corners of a chart's box, xyz each. */
function cornersOf(frame: Float32Array): Float32Array {
  return Float32Array.from({ length: 24 }, (_, i) => {
    const [corner, d] = [Math.floor(i / 3), i % 3];
    return frame[((corner >> d) & 1 ? FRAME.high : FRAME.low) + d];
  });
}
