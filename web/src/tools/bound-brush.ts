import { pointsAround } from '../seams/brush';
import type { Solid } from '../surface/solid';
import { type Pixel, pixelOn } from '../view/sight';
import type { ViewName, Views } from '../view/views';

export interface BrushEvents {
  isOn(): boolean;
  /** Whether a stroke with these keys takes bounds away. */
  erases(isAlt: boolean): boolean;
  /** The pointer is at these vertices, or has painted them so far; none: it is elsewhere. */
  aimed(vertices: ReadonlySet<number>, erases: boolean): void;
  painted(vertices: ReadonlySet<number>, erases: boolean): void;
}

/** Css pixels. */
const RADIUS = 16;
const NO_VERTICES: ReadonlySet<number> = new Set();

interface Stroke {
  pointer: number;
  at: Pixel;
  vertices: Set<number>;
  erases: boolean;
}

/** Drags along the boundary, in either view. Other drags turn and move the view as ever. */
export class BoundBrush {
  private stroke: Stroke | null = null;

  constructor(
    private readonly views: Views,
    /** That of the mesh on screen. */
    private readonly solid: () => Solid | null,
    private readonly events: BrushEvents,
  ) {
    for (const view of ['mesh', 'layout'] as const) this.listen(view);
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
      if (this.events.isOn() && !this.stroke) this.events.aimed(NO_VERTICES, false);
    });
  }

  private begin(view: ViewName, canvas: HTMLElement, event: PointerEvent): boolean {
    if (this.stroke) return true; // another finger
    if (event.button !== 0 || !event.isPrimary) return false;
    const at = pixelOn(canvas, event);
    const vertices = this.verticesAround(view, at);
    if (vertices.size === 0) return false;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
    const erases = this.events.erases(event.altKey);
    this.stroke = { pointer: event.pointerId, at, vertices, erases };
    this.events.aimed(vertices, erases);
    return true;
  }

  private move(view: ViewName, canvas: HTMLElement, event: PointerEvent): boolean {
    const { stroke } = this;
    if (!stroke) {
      if (event.buttons === 0 && event.pointerType !== 'touch')
        this.events.aimed(
          this.verticesAround(view, pixelOn(canvas, event)),
          this.events.erases(event.altKey),
        );
      return false;
    }
    if (stroke.pointer !== event.pointerId) return true;
    const to = pixelOn(canvas, event);
    for (const at of pixelsBetween(stroke.at, to))
      for (const vertex of this.verticesAround(view, at)) stroke.vertices.add(vertex);
    stroke.at = to;
    this.events.aimed(stroke.vertices, stroke.erases);
    return true;
  }

  private end(event: PointerEvent): boolean {
    const { stroke } = this;
    if (stroke?.pointer !== event.pointerId) return stroke !== null;
    this.stroke = null;
    this.events.painted(stroke.vertices, stroke.erases);
    return true;
  }

  private cancel(event: PointerEvent): boolean {
    if (this.stroke?.pointer !== event.pointerId) return false;
    this.stroke = null;
    this.events.aimed(NO_VERTICES, false);
    return true;
  }

  private press(view: ViewName, canvas: HTMLElement, event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || (event.key !== 'Enter' && event.key !== ' '))
      return false;
    event.preventDefault();
    const middle = { x: canvas.clientWidth / 2, y: canvas.clientHeight / 2 };
    this.events.painted(this.verticesAround(view, middle), this.events.erases(event.altKey));
    return true;
  }

  private verticesAround(view: ViewName, at: Pixel): Set<number> {
    const { boundary } = this.views;
    if (!boundary) return new Set();
    const { vertices } = boundary;
    const solid = this.solid();
    if (view === 'layout') {
      const isNear = (i: number) => {
        const { x, y } = this.views.layoutPixel(boundary, i);
        return Math.hypot(x - at.x, y - at.y) <= RADIUS;
      };
      return new Set(vertices.filter((_, i) => isNear(i)));
    }
    if (!solid) return new Set();
    const near = pointsAround(solid, this.views.mesh.sight, at, boundary.mesh, RADIUS);
    return new Set(near.map((i) => vertices[i]));
  }
}

/** The places of the brush on its way, the last one included. */
function pixelsBetween(from: Pixel, to: Pixel): Pixel[] {
  const steps = Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / RADIUS) || 1;
  return Array.from({ length: steps }, (_, i) => {
    const share = (i + 1) / steps;
    return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
  });
}
