import type { Point } from '../arrange/motion';
import { svg } from '../plot/svg';
import type { Views } from '../view/views';

/** Lines over the layout. */
export class LineMarks {
  private readonly path = svg('path', {});
  private lines: readonly [Point, Point][] = [];

  constructor(
    private readonly views: Views,
    kind: 'marked-lines' | 'joined-lines',
  ) {
    views
      .canvasOf('layout')
      .after(svg('svg', { class: `area ${kind}`, 'aria-hidden': 'true' }, this.path));
  }

  /** Each from one point of uv to another; none: nothing is marked. */
  show(lines: readonly [Point, Point][]): void {
    if (lines.length === 0 && this.lines.length === 0) return;
    this.lines = lines;
    const [left, top] = this.views.uvAt({ x: 0, y: 0 });
    const scale = this.views.pixelsPerUv;
    const at = ([u, v]: Point) =>
      `${((u - left) * scale).toFixed(1)} ${((top - v) * scale).toFixed(1)}`;
    this.path.setAttribute('d', lines.map(([from, to]) => `M${at(from)}L${at(to)}`).join(''));
  }
}
