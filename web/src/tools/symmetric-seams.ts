import { create, element } from '../base/dom';
import { svg } from '../plot/svg';
import type { SeamEditor } from '../seams/seam-editor';
import { type Mirror, mirrorOf, withImages } from '../surface/mirror';
import type { SurfaceGraph } from '../surface/surface-graph';
import { SYMMETRIC } from '../words/choosing';

export interface SymmetricEvents {
  /** xyz per vertex of the mesh on screen. */
  positions(): Float64Array | null;
  say(text: string): void;
}

/** A button beside those that edit seams: what is cut or joined on one side is so on the other. */
export class SymmetricSeams {
  private readonly button = create('button', 'tool');
  private made: { graph: SurfaceGraph; mirror: Mirror | null } | null = null;

  constructor(
    editor: SeamEditor,
    private readonly events: SymmetricEvents,
  ) {
    const { button } = this;
    button.type = 'button';
    button.id = 'seam-symmetric';
    button.title = SYMMETRIC.title;
    button.ariaLabel = SYMMETRIC.button;
    const icon = svg('svg', { class: 'in-short', viewBox: '0 0 16 16', 'aria-hidden': 'true' });
    icon.append(svg('path', { d: 'M8 1v14M5.5 4v8H1zM10.5 4v8H15z' }));
    button.append(create('span', 'in-full', SYMMETRIC.button), icon);
    button.ariaPressed = 'false';
    button.addEventListener('click', () => {
      button.ariaPressed = String(button.ariaPressed !== 'true');
      editor.update();
    });
    element('seam-paint', HTMLElement).after(button);
    editor.setSymmetry((graph, edges) => this.alike(graph, edges));
  }

  private alike(graph: SurfaceGraph, edges: number[]): number[] {
    if (this.button.ariaPressed !== 'true' || edges.length === 0) return edges;
    const mirror = this.mirrorOf(graph);
    return mirror ? withImages(graph, mirror, edges) : edges;
  }

  private mirrorOf(graph: SurfaceGraph): Mirror | null {
    if (this.made?.graph !== graph) {
      const positions = this.events.positions();
      this.made = { graph, mirror: positions && mirrorOf(graph, positions) };
      if (!this.made.mirror) this.events.say(SYMMETRIC.noPlane);
    }
    return this.made.mirror;
  }
}
