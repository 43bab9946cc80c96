import type { Texture } from 'three';
import type { Box } from '../arrange/charts';
import type { Motion, Point } from '../arrange/motion';
import { bindToggle, element } from '../base/dom';
import { type Palette, readPalette } from '../colors/palette';
import type { VertexBounds } from '../mesh/vertex-bounds';
import type { Appearance } from '../model/appearance';
import type { Drawing, FlatDrawing } from '../model/drawing';
import { faultyFaces } from '../model/faulty-faces';
import { foundChart } from '../model/found-chart';
import type { Measure } from '../model/measures';
import type { Flattened, Outcome, Packed, Source, Unwrapped } from '../model/model';
import type { Bending } from './bending';
import { type Boundary, boundaryOf, boundMarks, NO_BOUND_MARKS } from './boundary';
import { type ChartStates, NO_STATES } from './chart-flags';
import type { ImageEvents } from './image-choice';
import { LayoutView } from './layout-view';
import { type Marked, showMarksLegend } from './marks-legend';
import { MeshView } from './mesh-view';
import type { Shading } from './shading';
import { ShadingControl } from './shading-control';
import type { Pixel } from './sight';
import { gridPicture } from './uv-grid';
import { uvPicture } from './uv-picture';

export type ViewName = 'mesh' | 'layout';

/** Both views and the buttons that belong to them. */
export class Views {
  readonly mesh: MeshView;
  private readonly layout: LayoutView;
  private shownSource: Source | null = null;
  private shownKind = kindOf(null);
  private states = NO_STATES;
  /** Of the mesh that was opened last; null if it is not known. */
  private look: { source: Source; appearance: Appearance } | null = null;
  private readonly shading: ShadingControl;
  /** Pictures that shadings show; each is one for both views. */
  private grid: Texture | null = null;
  private image: { bitmap: ImageBitmap; picture: Texture } | null = null;
  private imageEvents: ImageEvents | null = null;
  private palette: Palette | null = null;
  private bounds: VertexBounds = [];
  private isMarked = false;
  /** Of the disk on screen, if it is a result. */
  private shownBoundary: Boundary | null = null;

  /** Throws NoWebGl if the browser offers no WebGL 2. */
  constructor() {
    const reducedMotion = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.mesh = new MeshView(element('mesh-canvas', HTMLCanvasElement), reducedMotion);
    this.layout = new LayoutView(element('layout-canvas', HTMLCanvasElement));
    const both = [this.mesh, this.layout];
    this.shading = new ShadingControl({
      changed: (shading) => {
        const picture = this.pictureOf(shading);
        for (const view of both) view.setShading(shading, picture);
      },
      choose: (chosen) => {
        for (const { surface } of both) surface.choose(chosen);
      },
      imagePicked: (file) => this.imageEvents?.imagePicked(file),
      imageReached: () => this.imageEvents?.imageReached(),
    });
    for (const { canvas } of both) this.bindKey(canvas);
    bindToggle('wireframe', (isOn) => this.mesh.setWireframe(isOn));
    const { orbit } = this.mesh;
    element('other-side', HTMLButtonElement).addEventListener('click', () => orbit.turnRound());
    element('reset', HTMLButtonElement).addEventListener('click', () => orbit.reset());
    element('fit', HTMLButtonElement).addEventListener('click', () => this.layout.plane.fit());
  }

  private bindKey(canvas: HTMLCanvasElement): void {
    canvas.addEventListener('keydown', (event) => {
      if (event.key.toUpperCase() !== 'Z' || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      this.shading.toggle();
    });
  }

  /** Resolves when both can be drawn. */
  get ready(): Promise<unknown> {
    return Promise.all([this.mesh.ready, this.layout.ready]);
  }

  updateTheme(): void {
    const palette = readPalette();
    this.palette = palette;
    this.mesh.setPalette(palette);
    this.layout.setPalette(palette);
    this.drawBounds();
  }

  /** Shows a mesh that is not flattened (yet). */
  showMesh(drawing: Drawing): void {
    this.mesh.show(drawing);
    this.showBoundary(null);
  }

  /** Shows no layout. */
  clearLayout(): void {
    this.shownSource = null;
    this.layout.clear();
    this.shading.clear();
    showMarksLegend(null);
    if (this.shownBoundary) this.showBoundary(null);
  }

  get boundary(): Boundary | null {
    return this.shownBoundary;
  }

  /** Marks the vertices that have a bound of their own. */
  markBounds(bounds: VertexBounds): void {
    this.bounds = bounds;
    this.drawBounds();
  }

  private showBoundary(boundary: Boundary | null): void {
    this.shownBoundary = boundary;
    this.drawBounds();
  }

  private drawBounds(): void {
    const { palette, shownBoundary } = this;
    if (!palette) return;
    const isMarked = shownBoundary !== null && this.bounds.length > 0;
    // Nothing is drawn again for nothing.
    if (!isMarked && !this.isMarked) return;
    this.isMarked = isMarked;
    const { mesh, layout, tints } = isMarked
      ? boundMarks(shownBoundary, this.bounds, palette)
      : NO_BOUND_MARKS;
    this.mesh.surface.markBounds(mesh, tints);
    this.layout.surface.markBounds(layout, tints);
  }

  /** Where a vertex of the boundary appears in the layout. */
  layoutPixel({ layout }: Boundary, i: number): Pixel {
    return this.layout.plane.pixelOf(layout[3 * i], layout[3 * i + 1]);
  }

  /** How a mesh looks in its file; null while that is not known. Images of the last one are freed. */
  showAppearance(source: Source, appearance: Appearance | null): void {
    const before = this.look?.appearance;
    if (!before && !appearance) return;
    this.look = appearance && { source, appearance };
    this.mesh.setAppearance(appearance);
    this.layout.setAppearance(this.lookOf(this.shownSource));
    this.shading.offerMaterials(appearance !== null, appearance?.isVaried ?? false);
    for (const image of before?.images ?? []) image.close();
  }

  private lookOf(source: Source | null): Appearance | null {
    return this.look?.source === source ? this.look.appearance : null;
  }

  /** What happens in the list of shadings. */
  onImage(events: ImageEvents): void {
    this.imageEvents = events;
  }

  /** The most texels along a side of an image. */
  get mostTexels(): number {
    return this.mesh.surface.stage.mostTexels;
  }

  /** Shows an image in the unit square of uv; the last one is freed. */
  showImage(name: string, bitmap: ImageBitmap): void {
    const before = this.image;
    this.image = { bitmap, picture: uvPicture(bitmap) };
    this.shading.offerImage(name);
    before?.picture.dispose();
    before?.bitmap.close();
  }

  private pictureOf(shading: Shading): Texture | null {
    if (shading === 'image') return this.image?.picture ?? null;
    if (shading !== 'grid') return null;
    this.grid ??= gridPicture();
    return this.grid;
  }

  /** Highlights one chart; null: none. */
  lightChart(chart: number | null): void {
    for (const { surface } of [this.mesh, this.layout]) surface.light(chart);
  }

  /** What both views draw. */
  get surfaces() {
    return { mesh: this.mesh.surface, layout: this.layout.surface };
  }

  goToCharts(charts: number[]): void {
    this.mesh.goTo(charts);
    this.layout.goTo(charts);
  }

  /** Shows which charts are selected, hidden and pointed at. */
  showStates({ selected, hidden, hovered, invalid, stacked }: ChartStates): void {
    const { states } = this;
    const isSame =
      selected === states.selected && hidden === states.hidden && stacked === states.stacked;
    if (isSame && hovered === states.hovered && invalid === states.invalid) return;
    this.states = { selected, hidden, hovered, invalid, stacked };
    this.mesh.surface.showStates(this.states);
    this.layout.showStates(this.states);
  }

  /** Shows the heat map of a measure. */
  showMeasure(measure: Measure): void {
    this.shading.showMeasure(measure);
  }

  /** Shows the heat map of a measure, and lights the worst of the surface. */
  showWorst(measure: Measure): void {
    this.shading.showWorst(measure);
  }

  /** Shows charts of the layout as if they were moved in uv; without charts, all where they are. */
  moveCharts(charts: ReadonlySet<number>, motion: Motion): void {
    this.layout.move(charts, motion);
  }

  /** Shows a chart of the layout as a pin bends it that is dragged `by` in uv; moving no charts ends it. */
  bendChart(bending: Bending, by: Point): void {
    this.layout.bend(bending, by);
  }

  /** Marks pins of the layout, and the vertex that a click would hit; in uv. */
  showPins(pins: readonly Point[], aimed: Point | null): void {
    this.layout.showPins(pins, aimed);
  }

  /** The next layout to be shown has the charts where they were moved to. */
  placeCharts(): void {
    this.layout.place();
  }

  /** The point of uv at a pixel of the layout. */
  uvAt(at: Pixel): Point {
    return this.layout.plane.uvAt(at);
  }

  /** The box in uv of some charts. */
  boxOf(charts: Iterable<number>): Box {
    return this.layout.boxOf(charts);
  }

  /** Css pixels per unit of uv. */
  get pixelsPerUv(): number {
    return this.layout.plane.pixelsPerUv;
  }

  /** Drags of the layout pan only when `mayPan`. */
  setPanning(mayPan: () => boolean): void {
    this.layout.plane.setPanning(mayPan);
  }

  /** Copies of both views. */
  async pictures(): Promise<{
    mesh: HTMLCanvasElement;
    layout: HTMLCanvasElement;
    pixelRatio: number;
  }> {
    const [mesh, layout] = await Promise.all([
      this.mesh.surface.stage.picture(),
      this.layout.surface.stage.picture(),
    ]);
    return { mesh, layout, pixelRatio: layout.width / this.layout.canvas.clientWidth };
  }

  canvasOf(view: ViewName): HTMLCanvasElement {
    return this[view].canvas;
  }

  chartAt(view: ViewName, at: Pixel): number | null {
    return this[view].chartAt(at);
  }

  /** `moved` is called when a view shows another part, or from another side. */
  onMoved(view: ViewName, moved: () => void): void {
    if (view === 'mesh') this.mesh.orbit.onTurn(moved);
    else this.layout.plane.onMove(moved);
  }

  showOutcome(outcome: Outcome, drawing: FlatDrawing): void {
    const isNew = outcome.source !== this.shownSource;
    this.shownSource = outcome.source;
    if (isNew && this.look) this.layout.setAppearance(this.lookOf(outcome.source));
    const kind = kindOf(outcome);
    if (kind !== this.shownKind) this.layout.plane.fit();
    this.shownKind = kind;
    this.layout.setTexels(texelsOf(outcome));
    const marked = markedIn(outcome);
    this.showFlat(drawing, marked, isNew);
    if (outcome.mode === 'flatten') this.showBoundary(boundaryOf(drawing));
  }

  /** Shows another layout of the current mesh; `marked` is null if nothing is marked. */
  showFlat(drawing: FlatDrawing, marked: Marked | null, isNew = false): void {
    this.lightChart(null);
    // The point of view was chosen when the mesh was opened.
    this.mesh.show(drawing);
    this.layout.show(drawing, isNew);
    this.showBoundary(null);
    this.shading.show(drawing);
    showMarksLegend(marked);
  }
}

const NOTHING_MARKED: Marked = {
  bounds: [],
  boundaryCrossings: 0,
  delaunay: null,
  angularDistortion: null,
};

const markedInDisk = (outcome: Flattened): Marked => ({
  ...foundChart(outcome),
  ownBounds: outcome.settings.bounds?.length,
});

/** The part of the plane that is shown differs between a disk, an atlas and the UVs of a file. */
function kindOf(outcome: Outcome | null): 'disk' | 'atlas' | 'file' {
  if (!outcome || outcome.mode === 'flatten') return 'disk';
  return outcome.mode === 'pack' && outcome.settings.keepPlaces ? 'file' : 'atlas';
}

/** Along a side of a tile; null: there are no tiles. */
function texelsOf({ mode, result }: Outcome): number | null {
  if (mode === 'flatten') return null;
  return mode === 'pack' ? result.report.resolution : result.report.atlas.resolution;
}

function markedIn(outcome: Outcome): Marked | null {
  if (outcome.mode === 'pack') return markedInFile(outcome);
  return outcome.mode === 'flatten' ? markedInDisk(outcome) : markedInAtlas(outcome);
}

/** Packed islands lie on each other, and are mirrored, as before. */
const markedInFile = (packed: Packed): Marked | null =>
  packed.settings.keepPlaces ? { ...NOTHING_MARKED, faults: faultyFaces(packed) } : null;

/** What is marked in an atlas; nothing if it is valid. */
function markedInAtlas({ result: { report } }: Unwrapped): Marked | null {
  if (report.valid) return null;
  const invalidCharts = report.charts.filter(({ valid }) => !valid).length;
  return { ...NOTHING_MARKED, invalidCharts };
}
