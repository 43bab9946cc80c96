import { readPalette } from '../colors/palette';
import type { FlatDrawing } from '../model/drawing';
import { EdgeLines } from './edge-lines';
import { faceSides, NO_SIDES } from './face-sides';
import type { SurfaceScene } from './surface-scene';

/** Css pixels. */
const WIDTH = 3;

/** Outlines faces in both views. */
export class FaceMarks {
  private readonly mesh = new EdgeLines(WIDTH, true);
  private readonly layout = new EdgeLines(WIDTH, false);

  constructor(private readonly surfaces: { mesh: SurfaceScene; layout: SurfaceScene }) {
    for (const view of ['mesh', 'layout'] as const) {
      this[view].object.renderOrder = 2;
      surfaces[view].scene.add(this[view].object);
    }
    new MutationObserver(() => this.paint()).observe(document.documentElement, {
      attributeFilter: ['data-theme'],
    });
    this.paint();
  }

  /** Triangles of the mesh that is drawn; none: nothing. */
  show(drawing: FlatDrawing | null, triangles: number[]): void {
    const { mesh, layout } = drawing ? faceSides(drawing, triangles) : NO_SIDES;
    this.mesh.show(mesh);
    this.layout.show(layout);
    this.draw();
  }

  private paint(): void {
    const { cut } = readPalette();
    for (const lines of [this.mesh, this.layout]) lines.setColor(cut);
    this.draw();
  }

  private draw(): void {
    for (const view of ['mesh', 'layout'] as const) {
      const { stage } = this.surfaces[view];
      this[view].setResolution(stage.width, stage.height);
      stage.invalidate();
    }
  }
}
