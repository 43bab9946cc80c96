import type { SeamEditor } from '../seams/seam-editor';
import type { SeamModel } from '../seams/seam-model';
import type { LineMarks } from '../selection/line-marks';
import { EDGE_REACH, type OutlinePicker } from '../selection/outline-picker';
import { edgeBetween } from '../surface/surface-graph';
import { type Pixel, pixelOn } from '../view/sight';
import type { Views } from '../view/views';

/** The outlines of an atlas, and the vertex of the mesh that each of its vertices is. */
export interface Outlines {
  picker: OutlinePicker;
  vertexMap: Uint32Array;
}

export interface LayoutJoinEvents {
  /** Null if there is no atlas, or its edges are to be used otherwise. */
  outlines(): Outlines | null;
  hidden(): ReadonlySet<number>;
}

/** Lets clicks in the layout remove seams, too, while the tool Join is chosen. */
export class LayoutJoin {
  private readonly canvas: HTMLCanvasElement;
  private pressed: number | null = null;
  private isShown = false;
  /** Which edge of the surface each edge of the outlines is. */
  private edges: { outlines: Outlines; model: SeamModel; of: Int32Array } | null = null;

  /** `stage` contains the canvas of the layout. */
  constructor(
    stage: HTMLElement,
    private readonly views: Views,
    private readonly editor: SeamEditor,
    private readonly marks: LineMarks,
    private readonly events: LayoutJoinEvents,
  ) {
    this.canvas = views.canvasOf('layout');
    // Before the listeners of the canvas that pan and select.
    const before = { capture: true };
    stage.addEventListener('pointerdown', (event) => this.onDown(event), before);
    stage.addEventListener('pointermove', (event) => this.onMove(event), before);
    stage.addEventListener('pointerup', (event) => this.onUp(event), before);
    stage.addEventListener('pointercancel', () => this.end(), before);
    stage.addEventListener('keydown', (event) => this.onKey(event), before);
    for (const type of ['pointerleave', 'wheel'] as const)
      this.canvas.addEventListener(type, () => this.end());
  }

  private onDown(event: PointerEvent): void {
    if (event.target !== this.canvas || event.button !== 0 || !event.isPrimary) return;
    if (this.seamAt(pixelOn(this.canvas, event), event.shiftKey).length === 0) return;
    event.stopImmediatePropagation();
    this.canvas.focus();
    this.canvas.setPointerCapture(event.pointerId);
    this.pressed = event.pointerId;
  }

  private onUp(event: PointerEvent): void {
    if (this.pressed === null || this.pressed !== event.pointerId) return;
    event.stopImmediatePropagation();
    this.end();
    this.join(pixelOn(this.canvas, event), event.shiftKey);
  }

  private onMove(event: PointerEvent): void {
    if (this.pressed !== null) event.stopImmediatePropagation();
    else if (event.buttons === 0 && event.target === this.canvas)
      this.preview(pixelOn(this.canvas, event), event.shiftKey);
  }

  /** Enter clicks in the middle. */
  private onKey(event: KeyboardEvent): void {
    const isClick = event.key === 'Enter' || event.key === ' ';
    if (!isClick || event.target !== this.canvas || event.ctrlKey || event.metaKey) return;
    const middle = { x: this.canvas.clientWidth / 2, y: this.canvas.clientHeight / 2 };
    if (!this.join(middle, event.shiftKey)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }

  /** Returns whether there is a seam. */
  private join(at: Pixel, isOne: boolean): boolean {
    const model = this.editor.joining;
    const seam = this.seamAt(at, isOne);
    if (!model || seam.length === 0) return false;
    this.editor.joinEdges(model, seam);
    return true;
  }

  private preview(at: Pixel, isOne: boolean): void {
    const model = this.editor.joining;
    const seam = this.seamAt(at, isOne);
    if (!model || seam.length === 0) {
      this.end();
      return;
    }
    this.isShown = true;
    const of = this.edgesOf(model);
    const inSeam = new Set(model.alike(seam));
    const picker = this.events.outlines()?.picker;
    const both = [...(of?.keys() ?? [])].filter((edge) => inSeam.has(of?.[edge] ?? -1));
    this.marks.show(picker ? both.map((edge) => picker.sideOf(edge)) : []);
    this.editor.previewEdges(model, seam);
  }

  private end(): void {
    this.pressed = null;
    if (!this.isShown) return;
    this.isShown = false;
    this.marks.show([]);
    const model = this.editor.joining;
    if (model) this.editor.previewEdges(model, []);
  }

  /** The edges of the seam at a pixel from junction to junction or, with `isOne`, the edge alone. */
  private seamAt(at: Pixel, isOne: boolean): number[] {
    const model = this.editor.joining;
    const of = model && this.edgesOf(model);
    const picker = this.events.outlines()?.picker;
    if (!model || !of || !picker) return [];
    const hidden = this.events.hidden();
    const edge = picker.edgeNear(
      this.views.uvAt(at),
      EDGE_REACH / this.views.pixelsPerUv,
      (each) => model.all[of[each]] === 1 && !hidden.has(picker.chartOf(each)),
    );
    if (edge === null) return [];
    return isOne ? [of[edge]] : model.run(of[edge]);
  }

  private edgesOf(model: SeamModel): Int32Array | null {
    const outlines = this.events.outlines();
    if (!outlines) return null;
    if (this.edges?.outlines !== outlines || this.edges.model !== model) {
      const { picker, vertexMap } = outlines;
      const of = Int32Array.from({ length: picker.ends.length / 2 }, (_, edge) => {
        const [a, b] = picker.ends.subarray(2 * edge, 2 * edge + 2);
        return edgeBetween(model.graph, vertexMap[a], vertexMap[b]);
      });
      this.edges = { outlines, model, of };
    }
    return this.edges.of;
  }
}
