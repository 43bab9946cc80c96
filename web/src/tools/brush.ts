import { type Pixel, pixelOn } from '../view/sight';
import type { ViewName, Views } from '../view/views';

export interface BrushEvents {
  isOn(): boolean;
  /** What the brush touches there: vertices or faces, by their numbers. */
  under(view: ViewName, at: Pixel): Set<number>;
  /** Whether a stroke with these keys takes away what was painted. */
  erases(isAlt: boolean): boolean;
  /** The pointer is at these, or has painted them so far; none: it is elsewhere. */
  aimed(touched: ReadonlySet<number>, erases: boolean): void;
  painted(touched: ReadonlySet<number>, erases: boolean): void;
}

/** Css pixels. */
export const RADIUS = 16;
const NOTHING: ReadonlySet<number> = new Set();

interface Stroke {
  pointer: number;
  at: Pixel;
  touched: Set<number>;
  erases: boolean;
}

/** Drags over what can be painted. Other drags turn and move the view as ever. */
export class Brush {
  private stroke: Stroke | null = null;

  constructor(
    private readonly views: Views,
    /** Those that can be painted in. */
    names: readonly ViewName[],
    private readonly events: BrushEvents,
  ) {
    for (const view of names) this.listen(view);
  }

  private listen(view: ViewName): void {
    const canvas = this.views.canvasOf(view);
    const on = <T extends keyof HTMLElementEventMap>(
      type: T,
      act: (event: HTMLElementEventMap[T]) => boolean,
    ) =>
      // Before the listeners that turn and move the view, and select.
      canvas.addEventListener(
        type,
        (event) => {
          if (this.events.isOn() && act(event)) event.stopImmediatePropagation();
        },
        { capture: true },
      );
    on('pointerdown', (event) => this.begin(view, canvas, event));
    on('pointermove', (event) => this.move(view, canvas, event));
    on('pointerup', (event) => this.end(event));
    on('pointercancel', (event) => this.cancel(event));
    on('keydown', (event) => this.press(view, canvas, event));
    canvas.addEventListener('pointerleave', () => {
      if (this.events.isOn() && !this.stroke) this.events.aimed(NOTHING, false);
    });
  }

  private begin(view: ViewName, canvas: HTMLElement, event: PointerEvent): boolean {
    if (this.stroke) return true; // another finger
    if (event.button !== 0 || !event.isPrimary) return false;
    const at = pixelOn(canvas, event);
    const touched = this.events.under(view, at);
    if (touched.size === 0) return false;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    const erases = this.events.erases(event.altKey);
    this.stroke = { pointer: event.pointerId, at, touched, erases };
    this.events.aimed(touched, erases);
    return true;
  }

  private move(view: ViewName, canvas: HTMLElement, event: PointerEvent): boolean {
    const { stroke } = this;
    if (!stroke) {
      if (event.buttons !== 0 || event.pointerType === 'touch') return false;
      const touched = this.events.under(view, pixelOn(canvas, event));
      this.events.aimed(touched, this.events.erases(event.altKey));
      // What a click here would do otherwise does not count.
      return touched.size > 0;
    }
    if (stroke.pointer !== event.pointerId) return true;
    const to = pixelOn(canvas, event);
    for (const at of pixelsBetween(stroke.at, to))
      for (const each of this.events.under(view, at)) stroke.touched.add(each);
    stroke.at = to;
    this.events.aimed(stroke.touched, stroke.erases);
    return true;
  }

  private end(event: PointerEvent): boolean {
    const { stroke } = this;
    if (stroke?.pointer !== event.pointerId) return stroke !== null;
    this.stroke = null;
    this.events.painted(stroke.touched, stroke.erases);
    return true;
  }

  private cancel(event: PointerEvent): boolean {
    if (this.stroke?.pointer !== event.pointerId) return false;
    this.stroke = null;
    this.events.aimed(NOTHING, false);
    return true;
  }

  private press(view: ViewName, canvas: HTMLElement, event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || (event.key !== 'Enter' && event.key !== ' '))
      return false;
    event.preventDefault();
    const middle = { x: canvas.clientWidth / 2, y: canvas.clientHeight / 2 };
    this.events.painted(this.events.under(view, middle), this.events.erases(event.altKey));
    return true;
  }
}

/** The places of the brush on its way, the last one included. */
function pixelsBetween(from: Pixel, to: Pixel): Pixel[] {
  const steps = Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / (RADIUS / 2)) || 1;
  return Array.from({ length: steps }, (_, i) => {
    const share = (i + 1) / steps;
    return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
  });
}
