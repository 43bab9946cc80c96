import { type Pixel, pixelOn } from './sight';

export interface Modifiers {
  /** Reverses the action: joins instead of cutting, and vice versa. */
  alt: boolean;
  shift: boolean;
}

export interface AimEvents {
  /** Aims at a pixel of the canvas, or with null at nothing. */
  moved(at: Pixel | null, modifiers: Modifiers): void;
  clicked(at: Pixel, modifiers: Modifiers): void;
  /** The last two clicks were a double-click, or L was pressed. */
  doubleClicked?(at: Pixel, modifiers: Modifiers): void;
}

/** Css pixels that the pointer may move during a click; beyond that, it turns the view. */
export const STEADY = 5;
/** Keys that turn the view, and with it what the middle aims at. */
const VIEW_KEYS = [
  'ArrowLeft',
  'ArrowRight',
  'ArrowUp',
  'ArrowDown',
  '+',
  '-',
  '=',
  'Home',
  '0',
  '1',
  '3',
  '5',
  '7',
  '9',
];

/** Where the user aims in a canvas: at the pointer or, when using the keyboard, at the middle. */
export class Aim {
  private pointer: Pixel | null = null;
  private modifiers: Modifiers = { alt: false, shift: false };
  private isByKeys = false;
  private pressed: { id: number; at: Pixel } | null = null;
  private isScheduled = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly events: AimEvents,
  ) {
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    canvas.addEventListener('pointerleave', () => this.leave());
    canvas.addEventListener('pointerdown', (event) => this.onDown(event));
    canvas.addEventListener('pointerup', (event) => this.onUp(event));
    canvas.addEventListener('pointercancel', () => {
      this.pressed = null;
    });
    canvas.addEventListener('dblclick', (event) =>
      this.events.doubleClicked?.(this.pixelOf(event), modifiersOf(event)),
    );
    canvas.addEventListener('keydown', (event) => this.onKey(event));
    canvas.addEventListener('blur', () => {
      if (this.isByKeys) this.leave();
    });
    for (const type of ['keydown', 'keyup'] as const)
      window.addEventListener(type, (event) => this.onModifier(event));
  }

  /** Aims again in the next frame because something has moved. */
  refresh(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      this.events.moved(this.at, this.modifiers);
    });
  }

  /** What was pressed is a drag that others see: its release is no click. */
  forget(): void {
    this.pressed = null;
    this.pointer = null;
    this.isByKeys = false;
  }

  private get at(): Pixel | null {
    return this.isByKeys ? this.middle : this.pointer;
  }

  private get middle(): Pixel {
    return { x: this.canvas.clientWidth / 2, y: this.canvas.clientHeight / 2 };
  }

  private leave(): void {
    this.pointer = null;
    this.isByKeys = false;
    this.refresh();
  }

  private onMove(event: PointerEvent): void {
    if (event.pointerType === 'touch') return; // a finger hides what it aims at
    this.isByKeys = false;
    this.pointer = event.buttons === 0 ? this.pixelOf(event) : null;
    this.modifiers = modifiersOf(event);
    this.refresh();
  }

  private onDown(event: PointerEvent): void {
    const isClick = event.button === 0 && event.isPrimary;
    this.pressed = isClick ? { id: event.pointerId, at: this.pixelOf(event) } : null;
  }

  private onUp(event: PointerEvent): void {
    const { pressed } = this;
    this.pressed = null;
    if (!pressed || pressed.id !== event.pointerId) return;
    const at = this.pixelOf(event);
    if (Math.hypot(at.x - pressed.at.x, at.y - pressed.at.y) > STEADY) return;
    this.events.clicked(at, modifiersOf(event));
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return;
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      this.isByKeys = true;
      this.events.clicked(this.middle, modifiersOf(event));
    } else if (event.key.toUpperCase() === 'L' && !event.altKey && this.events.doubleClicked) {
      event.preventDefault();
      this.events.doubleClicked(this.at ?? this.middle, modifiersOf(event));
    } else if (VIEW_KEYS.includes(event.key)) {
      this.isByKeys = true;
      this.refresh();
    }
  }

  private onModifier(event: KeyboardEvent): void {
    const { alt, shift } = modifiersOf(event);
    if (alt === this.modifiers.alt && shift === this.modifiers.shift) return;
    this.modifiers = { alt, shift };
    if (this.at) this.refresh();
  }

  private pixelOf(event: MouseEvent): Pixel {
    return pixelOn(this.canvas, event);
  }
}

export function modifiersOf({ altKey, shiftKey }: MouseEvent | KeyboardEvent): Modifiers {
  return { alt: altKey, shift: shiftKey };
}
