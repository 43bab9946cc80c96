export interface PanZoomEvents {
  /** Whether a drag is free to pan. */
  isFree(): boolean;
  moved(): void;
  fit(): void;
}

/** Css pixels and zoom factor per key press. */
const STEP = 40;
const ZOOM = 1.2;
const LEAST_SCALE = 20;
const MOST_SCALE = 2e7;

/**
 * The part of a plane (y up) that a canvas shows: (x, y) at its centre, `scale` css pixels per
 * unit. Moved by drag, wheel, pinch and keys; zooming keeps the point under the cursor in place.
 */
export class PanZoom {
  x = 0;
  y = 0;
  scale = 1;
  private readonly pointers = new Map<number, { x: number; y: number }>();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly events: PanZoomEvents,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.onDown(event));
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    for (const type of ['pointerup', 'pointercancel'] as const)
      canvas.addEventListener(type, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener('wheel', (event) => this.onWheel(event), { passive: false });
    canvas.addEventListener('dblclick', () => this.events.fit());
    canvas.addEventListener('keydown', (event) => this.onKey(event));
  }

  set(x: number, y: number, scale: number): void {
    this.x = x;
    this.y = y;
    this.scale = Math.min(MOST_SCALE, Math.max(LEAST_SCALE, scale));
  }

  private pan(dx: number, dy: number): void {
    this.set(this.x - dx / this.scale, this.y + dy / this.scale, this.scale);
    this.events.moved();
  }

  /** `clientX`, `clientY`: the point that stays in place. */
  private zoom(factor: number, clientX: number, clientY: number): void {
    const box = this.canvas.getBoundingClientRect();
    const right = clientX - box.left - box.width / 2;
    const up = box.height / 2 - (clientY - box.top);
    const [x, y] = [this.x + right / this.scale, this.y + up / this.scale];
    this.set(this.x, this.y, this.scale * factor);
    this.set(x - right / this.scale, y - up / this.scale, this.scale);
    this.events.moved();
  }

  private zoomAtCenter(factor: number): void {
    const box = this.canvas.getBoundingClientRect();
    this.zoom(factor, box.left + box.width / 2, box.top + box.height / 2);
  }

  private onDown(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  private onMove(event: PointerEvent): void {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const now = { x: event.clientX, y: event.clientY };
    this.pointers.set(event.pointerId, now);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (!other) {
      if (this.events.isFree()) this.pan(now.x - last.x, now.y - last.y);
      return;
    }
    // Each finger moves the midpoint by half of its own movement.
    this.pan((now.x - last.x) / 2, (now.y - last.y) / 2);
    const before = Math.hypot(last.x - other.x, last.y - other.y);
    const after = Math.hypot(now.x - other.x, now.y - other.y);
    if (before > 0 && after > 0)
      this.zoom(after / before, (now.x + other.x) / 2, (now.y + other.y) / 2);
  }

  private onWheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    // Trackpads report a pinch as a wheel with ctrl and small steps.
    const speed = event.ctrlKey ? 0.01 : 0.0015;
    this.zoom(Math.exp(-event.deltaY * lines * speed), event.clientX, event.clientY);
  }

  private onKey(event: KeyboardEvent): void {
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.pan(STEP, 0),
      ArrowRight: () => this.pan(-STEP, 0),
      ArrowUp: () => this.pan(0, STEP),
      ArrowDown: () => this.pan(0, -STEP),
      '+': () => this.zoomAtCenter(ZOOM),
      '=': () => this.zoomAtCenter(ZOOM),
      '-': () => this.zoomAtCenter(1 / ZOOM),
      Home: () => this.events.fit(),
      '0': () => this.events.fit(),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }
}
