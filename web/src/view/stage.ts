import { type Camera, type Scene, WebGLRenderer } from 'three';

export class NoWebGl extends Error {}

/**
 * A canvas that fills its parent, is redrawn only when asked, and follows changes of size and pixel
 * density.
 */
export class Stage {
  readonly renderer: WebGLRenderer;
  width = 1;
  height = 1;
  private isScheduled = false;
  private isReady = false;
  /** Something has changed since the last picture. */
  private isStale = false;

  /** Throws NoWebGl if the browser offers no WebGL 2. */
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

  /**
   * Compiles the shaders of everything that the scene will ever show, which takes the browser a
   * while; nothing is drawn before that.
   */
  async start(scene: Scene, camera: Camera): Promise<void> {
    new ResizeObserver(() => this.resize()).observe(parentOf(this.canvas));
    this.resize();
    await this.renderer.compileAsync(scene, camera);
    // Ask for their errors now: later, that would wait for pictures being drawn.
    for (const program of this.renderer.info.programs ?? []) program.getUniforms();
    this.isReady = true;
    this.drawNow();
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** Draws in the next frame, once, however often it is called before that. */
  invalidate(): void {
    this.isStale = true;
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      if (!this.isReady || !this.isStale) return;
      // The new content may have changed the page around it.
      this.follow();
      this.drawNow();
    });
  }

  /** A copy of what is shown, once everything has arrived and stands still. */
  async picture(): Promise<HTMLCanvasElement> {
    this.drawNow();
    while (this.isStale) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      this.drawNow();
    }
    // In the task that has drawn it: later, the browser has cleared it.
    const copy = document.createElement('canvas');
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    copy.getContext('2d')?.drawImage(this.canvas, 0, 0);
    return copy;
  }

  private drawNow(): void {
    this.isStale = false;
    this.draw();
  }

  private resize(): void {
    // Immediately: waiting for the next frame would show an empty canvas while the window is being
    // resized.
    if (this.follow() && this.isReady) this.drawNow();
  }

  /** Takes the parent's size; returns whether it has changed. */
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
