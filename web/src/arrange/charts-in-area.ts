import { boxOf, type ChartArrays, isChart, pointOf } from './charts';
import type { Point } from './motion';

/** The charts, but for hidden ones, that a polygon in uv touches anywhere. */
export function chartsInArea(
  { uv, indices, chartOfTriangle }: ChartArrays,
  area: readonly Point[],
  hidden: ReadonlySet<number>,
): Set<number> {
  const box = boxOf(area.flat(), area.keys());
  const found = new Set<number>();
  chartOfTriangle.forEach((chart, f) => {
    if (!isChart(chart) || found.has(chart) || hidden.has(chart)) return;
    const corners = indices.subarray(3 * f, 3 * f + 3);
    const { low, high } = boxOf(uv, corners);
    const isBeside = [0, 1].some((d) => high[d] < box.low[d] || low[d] > box.high[d]);
    if (isBeside) return;
    const triangle = Array.from(corners, (v) => pointOf(uv, v));
    if (touch(area, triangle)) found.add(chart);
  });
  return found;
}

/** Whether two polygons have a point in common. */
const touch = (a: readonly Point[], b: readonly Point[]): boolean =>
  contains(a, b[0]) || contains(b, a[0]) || sidesOf(a).some((side) => crosses(side, sidesOf(b)));

type Side = readonly [Point, Point];

const sidesOf = (polygon: readonly Point[]): Side[] =>
  polygon.map((from, i) => [from, polygon[(i + 1) % polygon.length]]);

/** By how often a ray from the point crosses the outline. */
function contains(polygon: readonly Point[], [x, y]: Point): boolean {
  const crossed = sidesOf(polygon).filter(([[x0, y0], [x1, y1]]) => {
    if (y0 > y === y1 > y) return false;
    return x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0);
  });
  return crossed.length % 2 === 1;
}

const crosses = (side: Side, others: Side[]): boolean =>
  others.some((other) => areApart(side, other) && areApart(other, side));

/** Whether the ends of one side are not strictly on the same side of the line through the other. */
const areApart = ([a, b]: Side, [c, d]: Side): boolean => turnOf(a, b, c) * turnOf(a, b, d) <= 0;

const turnOf = ([x, y]: Point, [x1, y1]: Point, [x2, y2]: Point): number =>
  (x1 - x) * (y2 - y) - (x2 - x) * (y1 - y);
