import { create, element } from '../base/dom';
import { tileAt } from '../mesh/tiles';

/** In css pixels: the numbers of smaller tiles would overlap. */
const LEAST_SIDE = 44;

/** Where a tile's lower left corner lies in the view and how large the tile is, in css pixels. */
export interface TilePlacement {
  x(u: number): number;
  y(v: number): number;
  side: number;
  width: number;
  height: number;
}

/** The numbers of UDIM tiles, shown in their corners. A single tile needs none. */
export class TileLabels {
  private readonly place = element('tiles', HTMLElement);
  private count = 0;

  show(tiles: number): void {
    this.count = tiles > 1 ? tiles : 0;
    if (this.count === 0) this.place.replaceChildren();
  }

  /** Moves the labels to where the tiles are now. */
  move({ x, y, side, width, height }: TilePlacement): void {
    if (this.count === 0) return;
    const labels: HTMLElement[] = [];
    for (let i = 0; side >= LEAST_SIDE && i < this.count; ++i) {
      const { u, v, number } = tileAt(i);
      const [left, top] = [x(u), y(v + 1)];
      if (left + side < 0 || left > width || top + side < 0 || top > height) continue;
      const label = create('span', 'tile', String(number));
      label.style.transform = `translate(${left}px, ${top}px)`;
      labels.push(label);
    }
    this.place.replaceChildren(...labels);
  }
}
