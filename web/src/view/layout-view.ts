import { OrthographicCamera, type Texture } from 'three';
import { type Box, boxInFrames } from '../arrange/charts';
import { type Motion, type Point, STILL } from '../arrange/motion';
import type { Palette } from '../colors/palette';
import type { Appearance } from '../model/appearance';
import type { FlatDrawing } from '../model/drawing';
import type { Bending } from './bending';
import { type ChartStates, NO_STATES, unseen } from './chart-flags';
import { EdgeLines } from './edge-lines';
import { createLayoutMaterial, paintLayout } from './layout-material';
import { PictureSheet } from './picture-sheet';
import { PinLayer } from './pin-layer';
import { PointMarks, RING } from './point-marks';
import { isMeasure, type Shading } from './shading';
import type { Pixel } from './sight';
import type { Stage } from './stage';
import { SurfaceScene } from './surface-scene';
import { TexelGrid } from './texel-grid';
import { TileLabels } from './tile-labels';
import { UvPlane } from './uv-plane';

/** Css pixels; thin for atlases, whose charts may be many and small. */
const OUTLINE = 2.25;
const THIN_OUTLINE = 1.25;

/** The uv layout in the plane. */
export class LayoutView {
  /** Resolves when pictures can be drawn without waiting for shaders. */
  readonly ready: Promise<void>;
  readonly surface: SurfaceScene;
  readonly plane: UvPlane;
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
  private readonly material = createLayoutMaterial();
  private readonly sheet = new PictureSheet(this.material);
  private readonly grid = new TexelGrid(this.material);
  private readonly frame: EdgeLines;
  private readonly resisting: EdgeLines;
  private readonly rings: PointMarks;
  private readonly pins: PinLayer;
  private readonly labels = new TileLabels();
  private asked: ChartStates = NO_STATES;
  /** The same, with what lies on others hidden. */
  private states: ChartStates = NO_STATES;
  private moving: ReadonlySet<number> = new Set();
  /** Whether the next layout has the charts where they were moved to. */
  private isPlaced = false;
  /** `FLAT_FRAME` of each shown chart. */
  private frames: Float32Array = new Float32Array();

  constructor(readonly canvas: HTMLCanvasElement) {
    this.surface = new SurfaceScene(
      canvas,
      {
        material: this.material,
        attributes: ['position'],
        camera: this.camera,
        depthTest: false,
        outline: OUTLINE,
      },
      { prepare: () => this.prepare(), resized: (stage) => this.resized(stage) },
    );
    this.plane = new UvPlane(this.camera, canvas, () => this.surface.invalidate());
    this.frame = new EdgeLines(1.5, false);
    this.resisting = new EdgeLines(2.5, false);
    this.rings = new PointMarks({ ...RING, depthTest: false });
    this.pins = new PinLayer(this.surface.triangles, this.material, this.surface.edges);
    this.surface.scene.add(
      this.sheet.object,
      this.grid.object,
      this.frame.object,
      this.resisting.object,
      this.rings.object,
      ...this.pins.objects,
    );
    // Nothing is drawn until there is a layout.
    this.surface.scene.visible = false;
    this.ready = this.surface.start([this.grid.object]);
  }

  /** Shows a layout. Keeps the point of view unless `isNew`. */
  show(drawing: FlatDrawing, isNew: boolean): void {
    const { layout, marks } = drawing;
    this.surface.triangles.show({ position: layout.position, ...marks }, () =>
      this.showParts(drawing),
    );
    this.frames = layout.frames;
    this.plane.show(layout, isNew);
    this.surface.invalidate();
  }

  /** Shows no layout, until there is another one. */
  clear(): void {
    this.surface.triangles.stop();
    this.grid.setResolution(null);
    if (!this.surface.scene.visible) return;
    this.surface.scene.visible = false;
    this.labels.show(0);
    this.surface.invalidate();
  }

  /** Shows everything besides the triangles. */
  private showParts(drawing: FlatDrawing): void {
    const { layout } = drawing;
    const { uniforms } = this.material;
    this.surface.scene.visible = true;
    this.pins.setPlane(layout.middle, layout.unit);
    if (this.isPlaced) this.move(new Set(), STILL);
    this.surface.showMarks(layout, drawing);
    const { isAtlas } = this.surface;
    uniforms.showsCharts.value = isAtlas;
    // Islands of a file may be mirrored on purpose; what is marked there has colours of its own.
    uniforms.marksFlipped.value = !layout.isOfFile;
    uniforms.uvMiddle.value.set(...layout.middle);
    uniforms.uvUnit.value = layout.unit;
    this.surface.edges.boundary.setWidth(isAtlas ? THIN_OUTLINE : OUTLINE);
    this.resisting.show(layout.resisting);
    this.rings.show(layout.rings);
    this.frame.show(layout.tileSides);
    this.labels.show(layout.tiles);
    this.sheet.show(layout.tiles);
    this.grid.show(layout.tiles);
  }

  setPalette(palette: Palette): void {
    this.surface.setPalette(palette);
    paintLayout(this.material, palette);
    this.frame.setColor(palette.frame);
    this.grid.setColor(palette.frame);
    this.resisting.setColor(palette.flipped);
    this.pins.setPalette(palette);
    this.rings.setColor(palette.flipped);
    this.surface.invalidate();
  }

  /** How the laid out mesh looks in its file; null if that is not known. */
  setAppearance(appearance: Appearance | null): void {
    this.surface.setAppearance(appearance);
    this.paint();
  }

  /** `picture`: what a shading needs that shows one. */
  setShading(shading: Shading, picture: Texture | null): void {
    this.surface.setShading(shading, picture);
    this.paint();
    this.plane.setImage(shading === 'image');
  }

  private paint(): void {
    const { uniforms } = this.material;
    const { shading, showsMaterials } = this.surface;
    uniforms.showsMaterials.value = showsMaterials;
    uniforms.showsImage.value = shading === 'image';
    uniforms.showsHeat.value = isMeasure(shading);
    uniforms.showsGrid.value = shading === 'grid';
    this.sheet.object.visible = shading === 'image';
    this.grid.setSurroundings(shading === 'image', shading === 'grid');
    this.surface.invalidate();
  }

  /** Along a side of a tile; null: the layout is no atlas. */
  setTexels(resolution: number | null): void {
    this.grid.setResolution(resolution);
    this.surface.invalidate();
  }

  /** The chart at a pixel; null if there is none. */
  chartAt(at: Pixel): number | null {
    return this.surface.scene.visible ? this.surface.chartAt(at) : null;
  }

  /** Shows charts as if they were moved in uv; without charts, all where they are. */
  move(charts: ReadonlySet<number>, motion: Motion): void {
    const inPlane = this.plane.motionOf(motion);
    const { a, b, x, y } = inPlane;
    this.material.uniforms.motion.value.set(a, b, x, y);
    this.lift(charts);
    this.pins.bend(null, [0, 0]);
    this.surface.edges.move(charts, inPlane);
  }

  /** Shows a chart as a pin bends it that is dragged `by` in uv. `move` ends it. */
  bend(bending: Bending, by: Point): void {
    this.material.uniforms.motion.value.set(1, 0, 0, 0);
    if (!this.moving.has(bending.chart)) this.lift(new Set([bending.chart]));
    this.pins.bend(bending, by, this.moving);
    this.surface.invalidate();
  }

  /** Draws charts above the others. */
  private lift(charts: ReadonlySet<number>): void {
    this.isPlaced = false;
    if (charts !== this.moving) this.surface.showStates(this.states, charts);
    this.moving = charts;
    this.surface.invalidate();
  }

  /** Marks pins, and the vertex that a click would hit; in uv. */
  showPins(pins: readonly Point[], aimed: Point | null): void {
    if (this.pins.show(pins, aimed)) this.surface.invalidate();
  }

  /** The next layout to be shown has the charts where they were moved to. */
  place(): void {
    this.isPlaced = true;
  }

  /** The box in uv of some charts. */
  boxOf(charts: Iterable<number>): Box {
    return this.plane.boxInUv(boxInFrames(this.frames, charts));
  }

  showStates(states: ChartStates): void {
    const { selected, hidden, stacked } = this.asked;
    const isSame =
      selected === states.selected && hidden === states.hidden && stacked === states.stacked;
    this.asked = states;
    this.states = { ...states, hidden: isSame ? this.states.hidden : unseen(states) };
    this.surface.showStates(this.states, this.moving);
  }

  /** Moves the view to some charts. */
  goTo(charts: number[]): void {
    const box = boxInFrames(this.frames, charts);
    if (box.low[0] <= box.high[0]) this.plane.goTo(box);
  }

  private resized({ width, height, pixelRatio }: Stage): void {
    for (const marks of [this.rings, this.pins]) marks.setPixelRatio(pixelRatio);
    for (const lines of [this.frame, this.resisting]) lines.setResolution(width, height);
    this.plane.resize(width, height);
  }

  private prepare(): void {
    this.plane.aim();
    this.grid.update(this.plane.pixelsPerUv);
    this.labels.move(this.plane.tilePlacement);
  }
}
