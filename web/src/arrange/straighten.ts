import { hull } from '../base/hull';
import { boxOf, type ChartArrays, middleOf, verticesOf } from './charts';
import { turned } from './motion';
import type { Motions } from './move-charts';

/**
 * Turns each chart, by no more than an eighth, so that the smallest box around it in any direction
 * is upright.
 */
export function straightened(arrays: ChartArrays, charts: Uint32Array): Motions {
  const vertices = verticesOf(arrays, charts);
  const motions = [...charts].map((chart) => {
    const own = vertices.get(chart) ?? [];
    const angle = angleOfSmallestBox(
      Float64Array.from(own, (v) => arrays.uv[2 * v]),
      Float64Array.from(own, (v) => arrays.uv[2 * v + 1]),
    );
    return turned(middleOf(boxOf(arrays.uv, own)), -angle);
  });
  return { charts, motions };
}

const QUARTER = Math.PI / 2;

/**
 * The angle, from -pi/4 to pi/4, of the box of least area around points: one of its sides lies along
 * a side of their convex hull.
 */
export function angleOfSmallestBox(x: Float64Array, y: Float64Array): number {
  const corners = hull(x, y);
  let [best, least] = [0, Infinity];
  corners.forEach((from, i) => {
    const to = corners[(i + 1) % corners.length];
    const angle = Math.atan2(y[to] - y[from], x[to] - x[from]);
    const area = areaAlong(corners, x, y, angle);
    // A box that is nearly as small is no reason to turn further.
    const turn = angle - QUARTER * Math.round(angle / QUARTER);
    if (area < least * (1 - 1e-9) || (area <= least && Math.abs(turn) < Math.abs(best)))
      [best, least] = [turn, area];
  });
  return best;
}

function areaAlong(corners: number[], x: Float64Array, y: Float64Array, angle: number): number {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const size = (along: (i: number) => number) => {
    const places = corners.map(along);
    return Math.max(...places) - Math.min(...places);
  };
  return size((i) => c * x[i] + s * y[i]) * size((i) => c * y[i] - s * x[i]);
}
