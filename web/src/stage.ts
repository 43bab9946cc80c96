import { WebGLRenderer } from 'three';

export class NoWebGl extends Error {}

/** A canvas that fills its parent, is redrawn only when asked, and follows size and pixel density. */
export class Stage {
  readonly renderer: WebGLRenderer;
  width = 1;
  height = 1;
  private isScheduled = false;

  /** Throws NoWebGl when the browser offers no WebGL 2. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly draw: () => void,
    private readonly resized: () => void,
  ) {
    const context = canvas.getContext('webgl2', {
      antialias: true,
      powerPreference: 'high-performance',
    });
    if (!context) throw new NoWebGl('The browser offers no WebGL 2.');
    this.renderer = new WebGLRenderer({ canvas, context });
    canvas.addEventListener('webglcontextrestored', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(parentOf(canvas));
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Draws in the next frame, however often it is called before. */
  invalidate(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      this.draw();
    });
  }

  resize(): void {
    const { clientWidth, clientHeight } = parentOf(this.canvas);
    this.width = Math.max(1, clientWidth);
    this.height = Math.max(1, clientHeight);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 3));
    this.renderer.setSize(this.width, this.height);
    this.resized();
    // At once: waiting for the next frame would show an empty canvas while the window is resized.
    this.draw();
  }
}

function parentOf(canvas: HTMLCanvasElement): HTMLElement {
  if (!canvas.parentElement) throw new Error('The canvas must be in the page.');
  return canvas.parentElement;
}
