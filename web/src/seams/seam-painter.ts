import { NearbyPaths } from '../surface/nearby-paths';
import type { SurfaceGraph } from '../surface/surface-graph';
import type { MeshView } from '../view/mesh-view';
import { NO_MARKS, type SeamMarks } from '../view/seam-overlay';
import type { Pixel } from '../view/sight';
import { Strokes } from '../view/strokes';
import type { SeamModel } from './seam-model';
import { CutStroke, JoinStroke, type SeamStroke } from './seam-strokes';
import { placeAt, type Targets } from './seam-targets';
import type { Tool } from './seam-tools';

/** What a stroke changes, and how. */
export interface Brush {
  model: SeamModel;
  tool: Tool;
  targets: Targets;
}

export interface PainterEvents {
  /** What a drag that begins with this paints with; null: it paints nothing. */
  begins(event: PointerEvent): Brush | null;
  /** It is a stroke, and no click. */
  begun(): void;
  /** What it would do so far. */
  shown(marks: SeamMarks, hint: string): void;
  finished(text: string, hasChanged: boolean): void;
}

/** Seams that follow drags over the mesh. */
export class SeamPainter {
  private readonly strokes: Strokes;
  private stroke: SeamStroke | null = null;
  private paths: { graph: SurfaceGraph; paths: NearbyPaths } | null = null;

  constructor(
    private readonly view: MeshView,
    private readonly events: PainterEvents,
  ) {
    this.strokes = new Strokes(view.canvas, {
      begins: (at, event) => this.begin(at, event),
      begun: () => this.events.begun(),
      moved: (along) => this.move(along),
      ended: () => this.end(),
      cancelled: () => this.drop(),
    });
  }

  get isDrawing(): boolean {
    return this.strokes.isDrawing;
  }

  /** Returns whether there was a stroke. */
  cancel(): boolean {
    return this.strokes.cancel();
  }

  /** Beside the mesh a drag turns the view. */
  private begin(at: Pixel, event: PointerEvent): boolean {
    const brush = this.events.begins(event);
    if (!brush) return false;
    const { model, tool, targets } = brush;
    const place = placeAt(model.surface, this.view.sight, at, targets.places);
    if (place < 0) return false;
    this.stroke =
      tool === 'cut'
        ? new CutStroke(model, targets, this.pathsOf(model.graph), place)
        : new JoinStroke(model, targets);
    if (tool === 'join') this.stroke.follow([at], this.view.sight);
    return true;
  }

  private pathsOf(graph: SurfaceGraph): NearbyPaths {
    if (this.paths?.graph !== graph) this.paths = { graph, paths: new NearbyPaths(graph) };
    return this.paths.paths;
  }

  private move(along: Pixel[]): void {
    const { stroke } = this;
    if (!stroke) return;
    stroke.follow(along, this.view.sight);
    this.events.shown(stroke.marks, stroke.hint);
  }

  private end(): void {
    const { stroke } = this;
    if (!stroke) return;
    this.drop();
    const count = stroke.finish();
    this.events.finished(stroke.text(count), count > 0);
  }

  private drop(): void {
    this.stroke = null;
    this.events.shown(NO_MARKS, '');
  }
}
