import { middleOf } from '../arrange/charts';
import {
  type Gesture,
  type GestureKind,
  motionOf,
  stepOf,
  textOf,
  withKey,
} from '../arrange/gesture';
import { isStill, type Motion, STILL } from '../arrange/motion';
import type { Pixel } from '../view/sight';
import type { Views } from '../view/views';

export interface MoverEvents {
  /** The selected charts that are not locked. */
  movable(): ReadonlySet<number>;
  /** Texels along a side of the atlas. */
  resolution(): number;
  /** What a gesture does so far; null when it has ended. */
  shows(text: string | null): void;
  /** A gesture has ended; `kind` is what it did. */
  moved(charts: ReadonlySet<number>, motion: Motion, kind: GestureKind): void;
}

/** Css pixels that the pointer must move before a press becomes a drag. */
const STEADY = 5;
const NO_CHARTS: ReadonlySet<number> = new Set();

/**
 * Moves, turns and scales the selected charts in the layout: by dragging one of them, or from a key
 * on until a click or Enter, as in Blender.
 */
export class ChartMover {
  private readonly canvas: HTMLCanvasElement;
  private gesture: Gesture | null = null;
  private charts: ReadonlySet<number> = NO_CHARTS;
  /** A press on a selected chart that may become a drag. */
  private pressed: { id: number; at: Pixel } | null = null;
  /** The gesture goes on while this pointer is down; null: until a click. */
  private dragging: number | null = null;
  private pointer: Pixel | null = null;

  constructor(
    private readonly views: Views,
    private readonly events: MoverEvents,
  ) {
    this.canvas = views.canvasOf('layout');
    views.setPanning(() => this.gesture === null && this.pressed === null);
    // Before the listeners of the canvas that pan and select.
    const first = { capture: true };
    this.canvas.addEventListener('pointerdown', (event) => this.onDown(event), first);
    window.addEventListener('pointermove', (event) => this.onMove(event), first);
    window.addEventListener('pointerup', (event) => this.onUp(event), first);
    window.addEventListener('pointercancel', () => this.cancel(), first);
    window.addEventListener('keydown', (event) => this.onKey(event), first);
    window.addEventListener('keyup', (event) => this.snap(event), first);
    this.canvas.addEventListener('contextmenu', (event) => {
      if (!this.gesture) return;
      event.preventDefault();
      this.cancel();
    });
  }

  get isActive(): boolean {
    return this.gesture !== null;
  }

  /** Begins a gesture that the pointer continues from where it is. */
  start(kind: GestureKind): void {
    const charts = this.events.movable();
    if (charts.size === 0 || this.gesture) return;
    const { clientWidth, clientHeight } = this.canvas;
    this.begin(kind, charts, this.pointer ?? { x: clientWidth / 2, y: clientHeight / 2 });
  }

  /** Puts everything back where it was. */
  cancel(): void {
    this.pressed = null;
    if (!this.gesture) return;
    this.end();
    this.views.moveCharts(NO_CHARTS, STILL);
  }

  private begin(kind: GestureKind, charts: ReadonlySet<number>, at: Pixel): void {
    const from = this.views.uvAt(at);
    const middle = middleOf(this.views.boxOf(charts));
    const texel = 1 / this.events.resolution();
    const step = stepOf(texel, this.views.pixelsPerUv);
    this.charts = new Set(charts);
    this.change({
      ...{ kind, middle, from, to: from, axis: null, nudge: [0, 0], typed: '' },
      ...{ snaps: false, texel, step },
    });
  }

  private change(gesture: Gesture): void {
    this.gesture = gesture;
    this.views.moveCharts(this.charts, motionOf(gesture));
    this.events.shows(textOf(gesture));
  }

  private end(): void {
    this.gesture = null;
    this.dragging = null;
    this.events.shows(null);
  }

  private confirm(): void {
    const { gesture, charts } = this;
    if (!gesture) return;
    const motion = motionOf(gesture);
    if (isStill(motion)) {
      this.cancel();
      return;
    }
    this.end();
    this.events.moved(charts, motion, gesture.kind);
  }

  private onDown(event: PointerEvent): void {
    const at = this.pixelOf(event);
    if (this.gesture) {
      event.stopImmediatePropagation();
      if (event.button !== 0) return;
      // A finger has no place before it touches.
      if (event.pointerType === 'touch') this.takeUp(event, at);
      else this.confirm();
      return;
    }
    if (this.pressed) {
      // A second finger zooms.
      this.pressed = null;
      return;
    }
    if (event.button !== 0 || event.shiftKey) return;
    const chart = this.views.chartAt('layout', at);
    if (chart !== null && this.events.movable().has(chart))
      this.pressed = { id: event.pointerId, at };
  }

  /** The gesture goes on with this finger. */
  private takeUp(event: PointerEvent, at: Pixel): void {
    if (!this.gesture || this.dragging !== null) return;
    this.dragging = event.pointerId;
    const from = this.views.uvAt(at);
    this.change({ ...this.gesture, from, to: from });
  }

  private onMove(event: PointerEvent): void {
    const at = this.pixelOf(event);
    this.pointer = event.target === this.canvas ? at : this.pointer;
    const { pressed } = this;
    if (pressed?.id === event.pointerId) {
      if (Math.hypot(at.x - pressed.at.x, at.y - pressed.at.y) <= STEADY) return;
      this.pressed = null;
      this.dragging = event.pointerId;
      this.begin('move', this.events.movable(), pressed.at);
    }
    const isOther = this.dragging !== null && this.dragging !== event.pointerId;
    const hovers = event.pointerType !== 'touch' || this.dragging !== null;
    if (!this.gesture || isOther || !hovers) return;
    this.change({ ...this.gesture, to: this.views.uvAt(at), snaps: hasCtrl(event) });
  }

  private onUp(event: PointerEvent): void {
    if (this.pressed?.id === event.pointerId) this.pressed = null;
    if (this.dragging === event.pointerId) this.confirm();
  }

  private onKey(event: KeyboardEvent): void {
    this.snap(event);
    if (!this.gesture || hasCtrl(event) || event.altKey) return;
    const actions: Record<string, () => void> = {
      Enter: () => this.confirm(),
      ' ': () => this.confirm(),
      Escape: () => this.cancel(),
    };
    const changed = withKey(this.gesture, event.key, event.shiftKey);
    const action = actions[event.key] ?? (changed && (() => this.change(changed)));
    if (!action) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    action();
  }

  private snap(event: KeyboardEvent): void {
    const snaps = hasCtrl(event);
    if (this.gesture && snaps !== this.gesture.snaps) this.change({ ...this.gesture, snaps });
  }

  private pixelOf({ clientX, clientY }: PointerEvent): Pixel {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }
}

const hasCtrl = ({ ctrlKey, metaKey }: MouseEvent | KeyboardEvent) => ctrlKey || metaKey;
