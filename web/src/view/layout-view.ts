import { OrthographicCamera, Scene, type Texture } from 'three';
import { type Box, boxInFrames, middleOf } from '../arrange/charts';
import { inPlane, type Motion, type Point, STILL } from '../arrange/motion';
import type { Palette } from '../colors/palette';
import type { Appearance } from '../model/appearance';
import type { FlatDrawing, LayoutDrawing } from '../model/drawing';
import type { Bending } from './bending';
import { ChartEdges } from './chart-edges';
import { ChartFlags, type ChartStates, NO_STATES, unseen } from './chart-flags';
import { ChartPicker } from './chart-picker';
import { defineShading } from './define';
import { EdgeLines } from './edge-lines';
import { FitRoom } from './fit-room';
import { type Chosen, choose, showMeasure } from './heat-uniforms';
import { createLayoutMaterial, paintLayout } from './layout-material';
import { LookTextures } from './look-textures';
import { PanZoom } from './pan-zoom';
import { PictureSheet } from './picture-sheet';
import { PinLayer } from './pin-layer';
import { DOT, OWN_BOUND, PointMarks, RING } from './point-marks';
import { isMeasure, type Shading } from './shading';
import type { Pixel } from './sight';
import { MARKS, SlicedSurface } from './sliced-surface';
import { Stage } from './stage';
import { NONE_LIT } from './surface-material';
import { TexelGrid } from './texel-grid';
import { TileLabels } from './tile-labels';

/** Css pixels; thin for atlases, whose charts may be many and small. */
const OUTLINE = 2.25;
const THIN_OUTLINE = 1.25;

/** The uv layout in the plane. */
export class LayoutView {
  private readonly stage: Stage;
  /** Resolves when pictures can be drawn without waiting for shaders. */
  readonly ready: Promise<void>;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
  private readonly material = createLayoutMaterial();
  private readonly sheet = new PictureSheet(this.material);
  private readonly grid = new TexelGrid(this.material);
  private readonly surface: SlicedSurface;
  private readonly picker: ChartPicker;
  private readonly flags: ChartFlags;
  private readonly textures: LookTextures;
  private shading: Shading = 'plain';
  private readonly edges = new ChartEdges(OUTLINE, false);
  private readonly frame = new EdgeLines(1.5, false);
  private readonly resisting = new EdgeLines(2.5, false);
  private readonly pins: PinLayer;
  private readonly dots = new PointMarks({ ...DOT, depthTest: false });
  private readonly bounds = new PointMarks({ ...OWN_BOUND, depthTest: false });
  private readonly rings = new PointMarks({ ...RING, depthTest: false });
  private readonly panZoom: PanZoom;
  /** Size of the shown layout, which is centred on 0 and whose longer side is 1. */
  private size: [number, number] = [1, 1];
  /** 0: it is in one piece. */
  private tiles = 0;
  /** In uv: the point at 0 of the plane, and the length of the plane's unit. */
  private middle: [number, number] = [0, 0];
  private unit = 1;
  private readonly labels = new TileLabels();
  private readonly room: FitRoom;
  private moved: () => void = () => undefined;
  private mayPan: () => boolean = () => true;
  private asked: ChartStates = NO_STATES;
  /** The same, with what lies on others hidden. */
  private states: ChartStates = NO_STATES;
  private moving: ReadonlySet<number> = new Set();
  /** Whether the next layout has the charts where they were moved to. */
  private isPlaced = false;
  /** Until the user pans or zooms, the layout stays fitted however it or the pane changes. */
  private isFitted = true;
  private isAtlas = false;
  private palette: Palette | null = null;
  /** `FLAT_FRAME` of each shown chart. */
  private frames: Float32Array = new Float32Array();

  constructor(readonly canvas: HTMLCanvasElement) {
    this.room = new FitRoom(canvas, () => {
      if (this.isFitted) this.fit();
    });
    this.panZoom = new PanZoom(canvas, {
      isFree: () => this.mayPan(),
      moved: () => {
        this.isFitted = false;
        this.moved();
        this.stage.invalidate();
      },
      fit: () => this.fit(),
    });
    this.stage = new Stage(
      canvas,
      () => this.draw(),
      () => this.resized(),
      () => this.surface.isBlank,
    );
    this.picker = new ChartPicker(this.stage.renderer, false);
    this.flags = new ChartFlags([this.material, this.picker.material]);
    this.textures = new LookTextures(this.stage.renderer, this.material);
    this.surface = new SlicedSurface(this.stage.renderer, this.material, ['position', ...MARKS]);
    this.pins = new PinLayer(this.surface, this.material, this.edges);
    this.scene.add(
      this.sheet.object,
      this.grid.object,
      this.frame.object,
      this.surface.object,
      ...this.edges.objects,
      this.resisting.object,
      this.dots.object,
      this.bounds.object,
      this.rings.object,
      ...this.pins.objects,
    );
    // Nothing is drawn until there is a layout.
    this.scene.visible = false;
    const first = [this.grid.object, this.surface.object, this.edges.boundary.object];
    this.ready = this.stage.start(this.scene, this.camera, first);
  }

  /** Shows a layout. Keeps the point of view unless `isNew`. */
  show({ layout, marks, chartColors, edgeCharts }: FlatDrawing, isNew: boolean): void {
    this.surface.show({ position: layout.position, ...marks }, () =>
      this.showParts(layout, edgeCharts, chartColors !== null),
    );
    this.unit = layout.unit;
    this.middle = layout.middle;
    this.size = layout.size;
    this.tiles = layout.tiles;
    this.frames = layout.frames;
    if (isNew || this.isFitted) this.fit();
    else this.stage.invalidate();
  }

  /** Shows no layout, until there is another one. */
  clear(): void {
    this.surface.stop();
    this.grid.setResolution(null);
    if (!this.scene.visible) return;
    this.scene.visible = false;
    this.labels.show(0);
    this.stage.invalidate();
  }

  /** Shows everything besides the triangles. */
  private showParts(layout: LayoutDrawing, edgeCharts: Uint32Array, isAtlas: boolean): void {
    this.scene.visible = true;
    this.isAtlas = isAtlas;
    this.pins.setPlane(layout.middle, layout.unit);
    if (this.isPlaced) this.move(new Set(), STILL);
    this.colorBoundary();
    this.material.uniforms.showsCharts.value = isAtlas;
    this.material.uniforms.uvMiddle.value.set(...layout.middle);
    this.material.uniforms.uvUnit.value = layout.unit;
    this.edges.boundary.setWidth(isAtlas ? THIN_OUTLINE : OUTLINE);
    this.edges.show(layout.edges, edgeCharts);
    this.resisting.show(layout.resisting);
    this.dots.show(layout.dots);
    this.rings.show(layout.rings);
    this.frame.show(layout.tileSides);
    this.labels.show(layout.tiles);
    this.sheet.show(layout.tiles);
    this.grid.show(layout.tiles);
  }

  private colorBoundary(): void {
    if (!this.palette) return;
    // What is dark on charts is not seen on every picture.
    const { showsMaterials, showsImage } = this.material.uniforms;
    const isDark = this.isAtlas && !showsMaterials.value && !showsImage.value;
    this.edges.boundary.setColor(isDark ? this.palette.seam : this.palette.boundary);
  }

  setPalette(palette: Palette): void {
    this.stage.renderer.setClearColor(palette.background);
    paintLayout(this.material, palette);
    this.frame.setColor(palette.frame);
    this.grid.setColor(palette.frame);
    this.palette = palette;
    this.colorBoundary();
    this.edges.setColors(palette.boundary, palette.flipped);
    this.resisting.setColor(palette.flipped);
    this.pins.setPalette(palette);
    this.dots.setColor(palette.tightened);
    this.rings.setColor(palette.flipped);
    this.stage.invalidate();
  }

  /** How the laid out mesh looks in its file; null if that is not known. */
  setAppearance(appearance: Appearance | null): void {
    this.textures.show(appearance);
    this.paint();
  }

  /** `picture`: what a shading needs that shows one. */
  setShading(shading: Shading, picture: Texture | null): void {
    this.shading = shading;
    defineShading(this.material, shading, picture);
    this.paint();
    if (this.isFitted) this.fit();
  }

  private paint(): void {
    const { uniforms } = this.material;
    const { shading } = this;
    uniforms.showsMaterials.value = shading === 'materials' && !this.textures.isEmpty;
    uniforms.showsImage.value = shading === 'image';
    this.sheet.object.visible = shading === 'image';
    this.grid.setSurroundings(shading === 'image', shading === 'grid');
    this.colorBoundary();
    uniforms.showsHeat.value = isMeasure(shading);
    uniforms.showsGrid.value = shading === 'grid';
    if (isMeasure(shading)) showMeasure(this.material, shading);
    this.stage.invalidate();
  }

  /** Along a side of a tile; null: the layout is no atlas. */
  setTexels(resolution: number | null): void {
    this.grid.setResolution(resolution);
    this.stage.invalidate();
  }

  /** Lights some triangles of the heat map only; null: all. */
  choose(chosen: Chosen | null): void {
    choose(this.material, chosen);
    this.stage.invalidate();
  }

  /** `moved` is called when another part of the layout is shown. */
  onMove(moved: () => void): void {
    this.moved = moved;
  }

  /** xyz in the plane and rgb per vertex. */
  markBounds(points: Float32Array, tints: Float32Array): void {
    this.bounds.show(points, tints);
    this.stage.invalidate();
  }

  /** Where a point of the plane appears. */
  pixelOf(x: number, y: number): Pixel {
    const { x: midX, y: midY, scale } = this.panZoom;
    const { width, height } = this.stage;
    return { x: width / 2 + (x - midX) * scale, y: height / 2 - (y - midY) * scale };
  }

  picture(): Promise<HTMLCanvasElement> {
    return this.stage.picture();
  }

  /** The chart at a pixel; null if there is none. */
  chartAt(at: Pixel): number | null {
    if (!this.scene.visible) return null;
    return this.picker.chartAt(at, this.surface.object, this.camera, this.stage);
  }

  /** Shows charts as if they were moved in uv; without charts, all where they are. */
  move(charts: ReadonlySet<number>, motion: Motion): void {
    const { a, b, x, y } = inPlane(motion, this.middle, this.unit);
    this.material.uniforms.motion.value.set(a, b, x, y);
    this.lift(charts);
    this.pins.bend(null, [0, 0]);
    this.edges.move(charts, { a, b, x, y });
  }

  /** Shows a chart as a pin bends it that is dragged `by` in uv. `move` ends it. */
  bend(bending: Bending, by: Point): void {
    this.material.uniforms.motion.value.set(1, 0, 0, 0);
    if (!this.moving.has(bending.chart)) this.lift(new Set([bending.chart]));
    this.pins.bend(bending, by, this.moving);
    this.stage.invalidate();
  }

  /** Draws charts above the others. */
  private lift(charts: ReadonlySet<number>): void {
    this.isPlaced = false;
    if (charts !== this.moving) this.flags.show(this.states, charts);
    this.moving = charts;
    this.stage.invalidate();
  }

  /** Marks pins, and the vertex that a click would hit; in uv. */
  showPins(pins: readonly Point[], aimed: Point | null): void {
    if (this.pins.show(pins, aimed)) this.stage.invalidate();
  }

  /** The next layout to be shown has the charts where they were moved to. */
  place(): void {
    this.isPlaced = true;
  }

  /** The point of uv at a pixel. */
  uvAt({ x, y }: Pixel): Point {
    const { x: midX, y: midY, scale } = this.panZoom;
    const [right, up] = [x - this.stage.width / 2, this.stage.height / 2 - y];
    const [u, v] = this.middle;
    return [u + this.unit * (midX + right / scale), v + this.unit * (midY + up / scale)];
  }

  /** Css pixels per unit of uv. */
  get pixelsPerUv(): number {
    return this.panZoom.scale / this.unit;
  }

  /** The box in uv of some charts. */
  boxOf(charts: Iterable<number>): Box {
    const [u, v] = this.middle;
    const inUv = ([x, y]: Point): Point => [u + this.unit * x, v + this.unit * y];
    const { low, high } = boxInFrames(this.frames, charts);
    return { low: inUv(low), high: inUv(high) };
  }

  /** Drags pan only when `mayPan`. */
  setPanning(mayPan: () => boolean): void {
    this.mayPan = mayPan;
  }

  showStates(states: ChartStates): void {
    const { selected, hidden, stacked } = this.asked;
    const isSame =
      selected === states.selected && hidden === states.hidden && stacked === states.stacked;
    this.asked = states;
    this.states = { ...states, hidden: isSame ? this.states.hidden : unseen(states) };
    this.flags.show(this.states, this.moving);
    this.edges.showStates(this.states);
    this.stage.invalidate();
  }

  /** Highlights one chart; null: none. */
  light(chart: number | null): void {
    this.material.uniforms.lit.value = chart ?? NONE_LIT;
    this.stage.invalidate();
  }

  /** Moves the view to some charts. */
  goTo(charts: number[]): void {
    const { low, high } = boxInFrames(this.frames, charts);
    if (!(low[0] <= high[0])) return;
    this.look(...middleOf({ low, high }), [high[0] - low[0], high[1] - low[1]]);
    this.isFitted = false;
  }

  fit(): void {
    const { unit, tiles } = this;
    const [u, v] = this.middle;
    // A layout in one piece need not fill the square that its image does.
    if (this.shading === 'image' && tiles === 0)
      this.look((0.5 - u) / unit, (0.5 - v) / unit, [1 / unit, 1 / unit]);
    else this.look(0, 0, this.size);
    this.isFitted = true;
  }

  private look(x: number, y: number, size: [number, number]): void {
    const { width, height } = this.stage;
    const { side, top, bottom } = this.room.margins(this.stage, this.tiles > 0);
    const across = (width - 2 * side) / (size[0] || 1);
    const down = (height - top - bottom) / (size[1] || 1);
    const scale = Math.min(across, down);
    this.panZoom.set(x, y + (top - bottom) / 2 / scale, scale);
    this.stage.invalidate();
  }

  private resized(): void {
    this.material.uniforms.pixelRatio.value = this.stage.pixelRatio;
    for (const marks of [this.dots, this.bounds, this.rings, this.pins])
      marks.setPixelRatio(this.stage.pixelRatio);
    for (const lines of [this.frame, this.edges, this.resisting])
      lines.setResolution(this.stage.width, this.stage.height);
    if (this.isFitted) this.fit();
  }

  private draw(): void {
    if (this.surface && !this.surface.advance()) {
      // The current picture stays until all of the next layout has arrived.
      this.stage.invalidate();
      return;
    }
    const { x, y, scale } = this.panZoom;
    const [halfWidth, halfHeight] = [this.stage.width / scale / 2, this.stage.height / scale / 2];
    this.camera.left = x - halfWidth;
    this.camera.right = x + halfWidth;
    this.camera.bottom = y - halfHeight;
    this.camera.top = y + halfHeight;
    this.camera.updateProjectionMatrix();
    this.grid.update(this.pixelsPerUv);
    this.stage.renderer.render(this.scene, this.camera);
    const { width, height } = this.stage;
    const [u0, v0] = this.middle;
    const side = scale / this.unit;
    this.labels.move({
      x: (u) => width / 2 + (u - u0) * side - x * scale,
      y: (v) => height / 2 - (v - v0) * side + y * scale,
      side,
      width,
      height,
    });
  }
}
