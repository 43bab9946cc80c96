import { type Camera, type Object3D, type Scene, WebGLRenderer } from 'three';

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
    /** Whether there has never been anything to draw: the page shows the same background. */
    private readonly isBlank: () => boolean,
  ) {
    // A context that has its size from the start need not allocate its buffers again.
    const { width, height, ratio } = this.wanted;
    canvas.width = Math.floor(width * ratio);
    canvas.height = Math.floor(height * ratio);
    const context = canvas.getContext('webgl2', {
      antialias: true,
      powerPreference: 'high-performance',
    });
    if (!context) throw new NoWebGl('This browser has no WebGL 2.');
    this.renderer = new WebGLRenderer({ canvas, context });
    canvas.addEventListener('webglcontextrestored', () => this.invalidate());
    canvas.addEventListener('mousedown', (event) => {
      if (event.button !== 1) return;
      // The browser would scroll the page.
      event.preventDefault();
      canvas.focus();
    });
  }

  /**
   * Compiles the shaders of `first`, which every first picture shows. That takes the browser a while,
   * and nothing is drawn before it is done. Other shaders are compiled when they are first drawn.
   */
  async start(scene: Scene, camera: Camera, first: Object3D[]): Promise<void> {
    new ResizeObserver(() => this.resize()).observe(parentOf(this.canvas));
    this.resize();
    const compile = (object: Object3D) => this.renderer.compileAsync(object, camera, scene);
    await Promise.all(first.map(compile));
    // Ask for their errors now: later, that would wait for pictures being drawn.
    for (const program of this.renderer.info.programs ?? []) program.getUniforms();
    this.isReady = true;
    if (this.canDraw) this.drawNow();
  }

  private get canDraw(): boolean {
    return this.isReady && !this.isBlank();
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  /** The most texels along a side of a texture. */
  get mostTexels(): number {
    return this.renderer.capabilities.maxTextureSize;
  }

  /** Draws in the next frame, once, however often it is called before that. */
  invalidate(): void {
    this.isStale = true;
    if (this.isScheduled) return;
    this.isScheduled = true;
    requestAnimationFrame(() => {
      this.isScheduled = false;
      if (!this.canDraw || !this.isStale) return;
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
    if (this.follow() && this.canDraw) this.drawNow();
  }

  /** Takes the parent's size; returns whether it has changed. */
  private follow(): boolean {
    const { width, height, ratio } = this.wanted;
    if (width === this.width && height === this.height && ratio === this.pixelRatio) return false;
    this.width = width;
    this.height = height;
    this.renderer.setDrawingBufferSize(width, height, ratio);
    this.canvas.style.width = `${width}px`;
    this.canvas.style.height = `${height}px`;
    this.resized();
    return true;
  }

  /** In css pixels, and device pixels per css pixel. */
  private get wanted(): { width: number; height: number; ratio: number } {
    const { clientWidth, clientHeight } = parentOf(this.canvas);
    const ratio = Math.min(window.devicePixelRatio, 3);
    return { width: Math.max(1, clientWidth), height: Math.max(1, clientHeight), ratio };
  }
}

function parentOf(canvas: HTMLCanvasElement): HTMLElement {
  if (!canvas.parentElement) throw new Error('The canvas must be in the page.');
  return canvas.parentElement;
}
