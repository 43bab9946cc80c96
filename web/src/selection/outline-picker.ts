import { pointOf } from '../arrange/charts';
import type { Point } from '../arrange/motion';
import { type ChartTriangles, edgesOfOne, weldInCharts } from '../mesh/outline-edges';

/** The farthest that an edge may be from the pointer, in css pixels. */
export const EDGE_REACH = 14;

/** The edges around the charts of an atlas. */
export class OutlinePicker {
  /** Two vertices of the atlas per edge. */
  readonly ends: Uint32Array;
  private readonly chartOfVertex: Uint32Array;

  constructor(private readonly atlas: ChartTriangles) {
    const { uv, indices, chartOfTriangle } = atlas;
    this.ends = edgesOfOne(indices, weldInCharts(atlas));
    this.chartOfVertex = new Uint32Array(uv.length / 2);
    indices.forEach((v, c) => {
      this.chartOfVertex[v] = chartOfTriangle[Math.floor(c / 3)];
    });
  }

  chartOf(edge: number): number {
    return this.chartOfVertex[this.ends[2 * edge]];
  }

  /** Both ends, in uv. */
  sideOf(edge: number): [Point, Point] {
    return [
      pointOf(this.atlas.uv, this.ends[2 * edge]),
      pointOf(this.atlas.uv, this.ends[2 * edge + 1]),
    ];
  }

  /** The edge nearest to a point of uv within `reach`, of those that are meant; null if there is none. */
  edgeNear(at: Point, reach: number, isMeant: (edge: number) => boolean): number | null {
    let [nearest, least]: [number | null, number] = [null, reach];
    const { uv } = this.atlas;
    for (let edge = 0; 2 * edge < this.ends.length; ++edge) {
      const [a, b] = [2 * this.ends[2 * edge], 2 * this.ends[2 * edge + 1]];
      if (isBeside(uv[a], uv[b], at[0], least) || isBeside(uv[a + 1], uv[b + 1], at[1], least))
        continue;
      const [from, to] = this.sideOf(edge);
      const distance = distanceTo(from, to, at);
      if (!(distance < least) || !isMeant(edge)) continue;
      [nearest, least] = [edge, distance];
    }
    return nearest;
  }

  /** The end of an outline's edge that is nearest to a point of uv in a chart, however far. */
  pointNear([u, v]: Point, chart: number): Point {
    let [nearest, least]: [Point, number] = [[u, v], Infinity];
    for (let edge = 0; 2 * edge < this.ends.length; ++edge) {
      if (this.chartOf(edge) !== chart) continue;
      const [[x, y]] = this.sideOf(edge);
      const distance = Math.hypot(x - u, y - v);
      if (distance < least) [nearest, least] = [[x, y], distance];
    }
    return nearest;
  }
}

/** Whether a number is farther than that from all between two others. */
const isBeside = (from: number, to: number, at: number, reach: number): boolean =>
  Math.min(from, to) - at > reach || at - Math.max(from, to) > reach;

/** From a point to a line between two others. */
function distanceTo([x0, y0]: Point, [x1, y1]: Point, [x, y]: Point): number {
  const [dx, dy] = [x1 - x0, y1 - y0];
  const square = dx * dx + dy * dy;
  const along = square > 0 ? ((x - x0) * dx + (y - y0) * dy) / square : 0;
  const share = Math.min(1, Math.max(0, along));
  return Math.hypot(x0 + share * dx - x, y0 + share * dy - y);
}
