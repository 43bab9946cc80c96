import { closesSomething } from '../base/messages';
import { svg } from '../plot/svg';
import { STEADY } from '../view/aim';
import { type Pixel, pixelOn } from '../view/sight';

export type AreaKind = 'box' | 'lasso';

export interface AreaEvents {
  /** What a press that is not announced may draw; null: it is for something else. */
  kindOf(event: PointerEvent, at: Pixel): AreaKind | null;
  /** The corners of an area in css pixels; `adds`: to what is selected. */
  drawn(area: Pixel[], adds: boolean): void;
  /** The next drag draws this, or none does any more. */
  announced(kind: AreaKind | null): void;
}

interface Press {
  id: number;
  kind: AreaKind;
  adds: boolean;
  /** From where it began to where it is. */
  way: Pixel[];
  isDrag: boolean;
}

/** Draws areas over a canvas by dragging, before its own listeners pan and select. */
export class AreaDrawing {
  private readonly shape = svg('polygon', {});
  private kind: AreaKind | null = null;
  private press: Press | null = null;

  /** `stage` contains the canvas. */
  constructor(
    stage: HTMLElement,
    private readonly canvas: HTMLCanvasElement,
    private readonly events: AreaEvents,
  ) {
    canvas.after(svg('svg', { class: 'area', 'aria-hidden': 'true' }, this.shape));
    const before = { capture: true };
    stage.addEventListener('pointerdown', (event) => this.onDown(event), before);
    stage.addEventListener('pointermove', (event) => this.onMove(event), before);
    stage.addEventListener('pointerup', (event) => this.onUp(event), before);
    stage.addEventListener('pointercancel', () => this.cancel(), before);
    window.addEventListener('keydown', (event) => this.onKey(event), before);
  }

  /** The next drag draws this; null: it does what it usually does. */
  announce(kind: AreaKind | null): void {
    this.kind = kind;
    this.canvas.classList.toggle('drawing', kind !== null);
    this.events.announced(kind);
  }

  get announced(): AreaKind | null {
    return this.kind;
  }

  private cancel(): void {
    this.press = null;
    this.draw([]);
  }

  private onDown(event: PointerEvent): void {
    if (event.target !== this.canvas) return;
    if (this.press) {
      // A second finger.
      if (this.press.isDrag || this.kind) event.stopImmediatePropagation();
      this.cancel();
      if (this.kind) this.announce(null);
      return;
    }
    if (event.button !== 0) return;
    const at = pixelOn(this.canvas, event);
    const kind = this.kind ?? this.events.kindOf(event, at);
    if (!kind) return;
    this.press = { id: event.pointerId, kind, adds: event.shiftKey, way: [at], isDrag: false };
    if (!this.kind) return; // it may be a click
    event.stopImmediatePropagation();
    this.canvas.focus();
    this.canvas.setPointerCapture(event.pointerId);
  }

  private onMove(event: PointerEvent): void {
    const { press } = this;
    if (!press) return;
    event.stopImmediatePropagation();
    if (event.pointerId !== press.id) return;
    const at = pixelOn(this.canvas, event);
    const [first] = press.way;
    press.isDrag ||= Math.hypot(at.x - first.x, at.y - first.y) > STEADY;
    if (press.kind === 'box') press.way = [first, at];
    else press.way.push(at);
    if (press.isDrag) this.draw(areaOf(press));
  }

  /** The release reaches the others: they have seen the press. */
  private onUp(event: PointerEvent): void {
    const { press } = this;
    if (press?.id !== event.pointerId) return;
    this.cancel();
    if (!press.isDrag) return;
    if (this.kind) this.announce(null);
    this.events.drawn(areaOf(press), press.adds);
  }

  private onKey(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || closesSomething(event)) return;
    if (this.press?.isDrag) this.cancel();
    else if (!this.kind) return;
    event.stopImmediatePropagation();
    if (this.kind) this.announce(null);
  }

  private draw(area: Pixel[]): void {
    this.shape.setAttribute('points', area.map(({ x, y }) => `${x},${y}`).join(' '));
  }
}

function areaOf({ kind, way }: Press): Pixel[] {
  if (kind === 'lasso') return way;
  const [{ x: x0, y: y0 }, { x: x1, y: y1 }] = [way[0], way[way.length - 1]];
  return [
    { x: x0, y: y0 },
    { x: x1, y: y0 },
    { x: x1, y: y1 },
    { x: x0, y: y1 },
  ];
}
