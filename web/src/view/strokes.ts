import { STEADY } from './aim';
import { type Pixel, pixelOn } from './sight';

export interface StrokeEvents {
  /** Whether a drag that begins with this is a stroke, rather than one that turns the view. */
  begins(at: Pixel, event: PointerEvent): boolean;
  /** The pointer has moved, so it is no click. */
  begun(): void;
  /** The pointer has come along these pixels. */
  moved(along: Pixel[]): void;
  ended(): void;
  cancelled(): void;
}

/** Css pixels between the places of a stroke that are looked at, and the most of them at once. */
const STEP = 8;
const MOST_STEPS = 24;

interface Stroke {
  pointer: number;
  /** Where it was last. */
  at: Pixel;
  state: 'pressed' | 'drawing' | 'cancelled';
}

/**
 * Drags over a canvas that do not turn the view. Others hear of presses and releases as ever, so
 * clicks and gestures of two fingers stay what they are.
 */
export class Strokes {
  private stroke: Stroke | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly events: StrokeEvents,
  ) {
    // Before the listeners that turn and move the view.
    const first = { capture: true };
    canvas.addEventListener('pointerdown', (event) => this.onDown(event), first);
    canvas.addEventListener('pointermove', (event) => this.onMove(event), first);
    canvas.addEventListener('pointerup', (event) => this.onUp(event), first);
    canvas.addEventListener('pointercancel', (event) => this.onCancel(event), first);
  }

  get isDrawing(): boolean {
    return this.stroke?.state === 'drawing';
  }

  /** The rest of the drag does nothing. Returns whether there was a stroke. */
  cancel(): boolean {
    if (this.stroke?.state === 'pressed') this.stroke = null;
    if (this.stroke?.state !== 'drawing') return false;
    this.stroke.state = 'cancelled';
    this.events.cancelled();
    return true;
  }

  private onDown(event: PointerEvent): void {
    if (this.stroke) {
      this.addFinger(event);
      return;
    }
    if (event.button !== 0 || !event.isPrimary) return;
    const at = pixelOn(this.canvas, event);
    if (!this.events.begins(at, event)) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.stroke = { pointer: event.pointerId, at, state: 'pressed' };
  }

  /** Two fingers move the view, unless one of them has drawn already. */
  private addFinger(event: PointerEvent): void {
    const isDrawn = this.stroke?.state !== 'pressed';
    this.cancel();
    if (isDrawn) event.stopImmediatePropagation();
  }

  private onMove(event: PointerEvent): void {
    const { stroke } = this;
    if (!stroke) return;
    event.stopImmediatePropagation();
    if (stroke.pointer !== event.pointerId || stroke.state === 'cancelled') return;
    const at = pixelOn(this.canvas, event);
    if (stroke.state === 'pressed') {
      if (Math.hypot(at.x - stroke.at.x, at.y - stroke.at.y) <= STEADY) return;
      stroke.state = 'drawing';
      this.events.begun();
    }
    // Not in all browsers.
    const passed = event.getCoalescedEvents?.() ?? [];
    const pixels = passed.map((part) => pixelOn(this.canvas, part));
    this.events.moved(pixelsAlong([stroke.at, ...pixels, at]));
    stroke.at = at;
  }

  private onUp(event: PointerEvent): void {
    if (this.stroke?.pointer !== event.pointerId) return;
    const { isDrawing } = this;
    this.stroke = null;
    if (isDrawing) this.events.ended();
  }

  private onCancel(event: PointerEvent): void {
    if (this.stroke?.pointer !== event.pointerId) return;
    this.cancel();
    this.stroke = null;
  }
}

/** Places along a line through pixels, its end among them, but not its start. */
export function pixelsAlong(line: Pixel[]): Pixel[] {
  const lengths = line.slice(1).map((to, i) => Math.hypot(to.x - line[i].x, to.y - line[i].y));
  const total = lengths.reduce((sum, length) => sum + length, 0);
  const step = Math.max(STEP, total / MOST_STEPS);
  const found: Pixel[] = [];
  /** How far it is from the start of a part to the next place. */
  let ahead = step;
  lengths.forEach((length, i) => {
    const [from, to] = [line[i], line[i + 1]];
    for (; ahead < length; ahead += step) {
      const share = ahead / length;
      found.push({ x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) });
    }
    ahead -= length;
  });
  return [...found, line[line.length - 1]];
}
