import { levelled } from '../arrange/level-edge';
import { isStill, type Motion, type Point } from '../arrange/motion';
import { closesSomething } from '../base/messages';
import { STEADY } from '../view/aim';
import { type Pixel, pixelOn } from '../view/sight';
import type { Views } from '../view/views';
import { LEVELLING } from '../words/choosing';
import type { LineMarks } from './line-marks';
import { EDGE_REACH, type OutlinePicker } from './outline-picker';

export interface EdgeToolEvents {
  /** The outlines of the atlas on screen; null if there is none. */
  outlines(): OutlinePicker | null;
  /** Whether edges of a chart can be chosen. */
  isMeant(chart: number): boolean;
  /** An edge, or a part of an outline, is to be level or upright. */
  chosen(chart: number, motion: Motion): void;
  say(text: string): void;
}

interface Press {
  id: number;
  at: Pixel;
  edge: number;
}

/** Lets the user choose an edge of an outline, or drag from one point of it to another, to turn its chart by. */
export class EdgeTool {
  private readonly canvas: HTMLCanvasElement;
  private press: Press | null = null;

  /** `stage` contains the canvas of the layout. */
  constructor(
    stage: HTMLElement,
    private readonly views: Views,
    private readonly marks: LineMarks,
    private readonly events: EdgeToolEvents,
  ) {
    this.canvas = views.canvasOf('layout');
    // Before the listeners of the canvas that pan and select.
    const before = { capture: true };
    stage.addEventListener('pointerdown', (event) => this.onDown(event), before);
    stage.addEventListener('pointermove', (event) => this.onMove(event), before);
    stage.addEventListener('pointerup', (event) => this.onUp(event), before);
    stage.addEventListener('pointercancel', () => this.show(null), before);
    stage.addEventListener('keydown', (event) => this.onStageKey(event), before);
    window.addEventListener('keydown', (event) => this.onKey(event), before);
    this.canvas.addEventListener('wheel', () => this.marks.show([]));
  }

  get isOn(): boolean {
    return this.canvas.classList.contains('drawing-edge');
  }

  turn(isOn: boolean): void {
    this.press = null;
    this.show(null);
    this.canvas.classList.toggle('drawing-edge', isOn);
    if (isOn) this.events.say(LEVELLING.toChoose);
  }

  private onDown(event: PointerEvent): void {
    if (!this.isOn || event.target !== this.canvas || event.button !== 0) return;
    event.stopImmediatePropagation();
    if (this.press) {
      // A second finger.
      this.turn(false);
      return;
    }
    const at = pixelOn(this.canvas, event);
    const edge = this.edgeAt(at);
    if (edge === null) {
      this.events.say(LEVELLING.noEdge);
      return;
    }
    this.canvas.focus();
    this.canvas.setPointerCapture(event.pointerId);
    this.press = { id: event.pointerId, at, edge };
    this.show(this.lineTo(at));
  }

  private onMove(event: PointerEvent): void {
    if (!this.isOn) return;
    const at = pixelOn(this.canvas, event);
    if (this.press) event.stopImmediatePropagation();
    if (this.press ? this.press.id === event.pointerId : event.pointerType !== 'touch')
      this.show(this.lineTo(at));
  }

  private onUp(event: PointerEvent): void {
    if (!this.isOn || this.press?.id !== event.pointerId) return;
    event.stopImmediatePropagation();
    this.finish(pixelOn(this.canvas, event));
  }

  /** Enter chooses what is in the middle. */
  private onStageKey(event: KeyboardEvent): void {
    const isChoice = event.key === 'Enter' || event.key === ' ';
    if (!this.isOn || event.target !== this.canvas || !isChoice) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.finish({ x: this.canvas.clientWidth / 2, y: this.canvas.clientHeight / 2 });
  }

  private onKey(event: KeyboardEvent): void {
    if (!this.isOn || event.key !== 'Escape' || closesSomething(event)) return;
    event.stopImmediatePropagation();
    this.turn(false);
    this.events.say(LEVELLING.cancelled);
  }

  private finish(at: Pixel): void {
    const line = this.lineTo(at);
    const edge = this.press?.edge ?? this.edgeAt(at);
    const outlines = this.events.outlines();
    if (!line || edge === null || !outlines) {
      this.events.say(LEVELLING.noEdge);
      return;
    }
    const motion = levelled(...line);
    this.turn(false);
    if (isStill(motion)) this.events.say(LEVELLING.isLevel);
    else this.events.chosen(outlines.chartOf(edge), motion);
  }

  /** The edge at a pixel or, once one is pressed, from there to the nearest point of the same outline. */
  private lineTo(at: Pixel): [Point, Point] | null {
    const outlines = this.events.outlines();
    const { press } = this;
    const edge = press ? press.edge : this.edgeAt(at);
    if (!outlines || edge === null) return null;
    if (!press || Math.hypot(at.x - press.at.x, at.y - press.at.y) <= STEADY)
      return outlines.sideOf(edge);
    const chart = outlines.chartOf(edge);
    const [from, to] = [press.at, at].map((each) =>
      outlines.pointNear(this.views.uvAt(each), chart),
    );
    return from[0] === to[0] && from[1] === to[1] ? outlines.sideOf(edge) : [from, to];
  }

  private edgeAt(at: Pixel): number | null {
    const outlines = this.events.outlines();
    const reach = EDGE_REACH / this.views.pixelsPerUv;
    const isMeant = (edge: number) =>
      outlines !== null && this.events.isMeant(outlines.chartOf(edge));
    return outlines?.edgeNear(this.views.uvAt(at), reach, isMeant) ?? null;
  }

  private show(line: [Point, Point] | null): void {
    this.marks.show(line ? [line] : []);
  }
}
