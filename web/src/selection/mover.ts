import {
  type Gesture,
  type GestureKind,
  motionOf,
  stepOf,
  textOf,
  withKey,
} from '../arrange/gesture';
import { isStill, type Motion, type Point } from '../arrange/motion';
import type { Pixel } from '../view/sight';
import type { Views } from '../view/views';

/** What a gesture moves in the layout. */
export interface Movable {
  /** It turns about this point of uv, and grows from it. */
  middle: Point;
  /** Shows it as if it was moved. */
  show(motion: Motion): void;
  /** Shows it where it is. */
  putBack(): void;
  /** The gesture has ended. */
  moved(motion: Motion, kind: GestureKind): void;
}

export interface MoverEvents {
  /** What a drag from here moves; null if nothing. */
  movableAt(at: Pixel): Movable | null;
  /** Texels along a side of the atlas. */
  resolution(): number;
  /** What a gesture does so far; null when it has ended. */
  shows(text: string | null): void;
}

/** Css pixels that the pointer must move before a press becomes a drag. */
const STEADY = 5;

/**
 * Moves, turns and scales what is in the layout: by dragging it, or from a key on until a click or
 * Enter, as in Blender.
 */
export class Mover {
  private readonly canvas: HTMLCanvasElement;
  private gesture: Gesture | null = null;
  private movable: Movable | null = null;
  /** A press that may become a drag. */
  private pressed: { id: number; at: Pixel; movable: Movable } | null = null;
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
  start(kind: GestureKind, movable: Movable): void {
    if (this.gesture) return;
    const { clientWidth, clientHeight } = this.canvas;
    this.begin(kind, movable, this.pointer ?? { x: clientWidth / 2, y: clientHeight / 2 });
  }

  /** Puts everything back where it was. */
  cancel(): void {
    this.pressed = null;
    if (this.gesture) this.end()?.putBack();
  }

  private begin(kind: GestureKind, movable: Movable, at: Pixel): void {
    const from = this.views.uvAt(at);
    const { middle } = movable;
    const texel = 1 / this.events.resolution();
    const step = stepOf(texel, this.views.pixelsPerUv);
    this.movable = movable;
    this.change({
      ...{ kind, middle, from, to: from, axis: null, nudge: [0, 0], typed: '' },
      ...{ snaps: false, texel, step },
    });
  }

  private change(gesture: Gesture): void {
    this.gesture = gesture;
    this.movable?.show(motionOf(gesture));
    this.events.shows(textOf(gesture));
  }

  /** Returns what was moved. */
  private end(): Movable | null {
    const { movable } = this;
    this.gesture = null;
    this.movable = null;
    this.dragging = null;
    this.events.shows(null);
    return movable;
  }

  private confirm(): void {
    const { gesture } = this;
    if (!gesture) return;
    const motion = motionOf(gesture);
    if (isStill(motion)) this.cancel();
    else this.end()?.moved(motion, gesture.kind);
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
    const movable = this.events.movableAt(at);
    if (movable) this.pressed = { id: event.pointerId, at, movable };
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
      this.begin('move', pressed.movable, pressed.at);
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
