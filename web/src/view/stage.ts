import { type Camera, type Scene, WebGLRenderer } from 'three';

export class NoWebGl extends Error {}

/** A canvas that fills its parent, is redrawn only when asked, and follows size and pixel density. */
export class Stage {
  readonly renderer: WebGLRenderer;
  width = 1;
  height = 1;
  private isScheduled = false;
  private isReady = false;
  /** Something has changed since the last picture. */
  private isStale = false;

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
    if (!context) throw new NoWebGl('This browser has no WebGL 2.');
    this.renderer = new WebGLRenderer({ canvas, context });
    canvas.addEventListener('webglcontextrestored', () => this.invalidate());
  }

  /** Compiles the shaders of all that the scene will ever show, which takes the browser a while; nothing is drawn before. */
  async start(scene: Scene, camera: Camera): Promise<void> {
    new ResizeObserver(() => this.resize()).observe(parentOf(this.canvas));
    this.resize();
    await this.renderer.compileAsync(scene, camera);
    // Asks for their errors now: later it would wait for pictures that are being drawn.
    for (const program of this.renderer.info.programs ?? []) program.getUniforms();
    this.isReady = true;
    this.drawNow();
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Draws in the next frame, however often it is called before. */
  invalidate(): void {
    this.isStale = true;
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      if (!this.isReady || !this.isStale) return;
      // What is to be shown may have changed the page around it.
      this.follow();
      this.drawNow();
    });
  }

  private drawNow(): void {
    this.isStale = false;
    this.draw();
  }

  private resize(): void {
    // At once: waiting for the next frame would show an empty canvas while the window is resized.
    if (this.follow() && this.isReady) this.drawNow();
  }

  /** Takes the size of the parent; returns whether it is another one. */
  private follow(): boolean {
    const { clientWidth, clientHeight } = parentOf(this.canvas);
    const [width, height] = [Math.max(1, clientWidth), Math.max(1, clientHeight)];
    const ratio = Math.min(window.devicePixelRatio, 3);
    if (width === this.width && height === this.height && ratio === this.pixelRatio) return false;
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height);
    this.resized();
    return true;
  }
}

function parentOf(canvas: HTMLCanvasElement): HTMLElement {
  if (!canvas.parentElement) throw new Error('The canvas must be in the page.');
  return canvas.parentElement;
}
