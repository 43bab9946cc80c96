// Pins as corners of the atlas's triangles: their numbers stay the same however the mesh is cut.

import { type ChartArrays, pointOf } from '../arrange/charts';
import type { Point } from '../arrange/motion';

export type Pins = Uint32Array;

export const chartOfCorner = ({ chartOfTriangle }: ChartArrays, corner: number): number =>
  chartOfTriangle[Math.floor(corner / 3)];

export const pointOfCorner = ({ uv, indices }: ChartArrays, corner: number): Point =>
  pointOf(uv, indices[corner]);

/** Pins a vertex, or removes its pin. */
export function toggled(pins: Pins, arrays: ChartArrays, vertex: number): Pins {
  const { indices } = arrays;
  const others = pins.filter((corner) => indices[corner] !== vertex);
  if (others.length < pins.length) return others;
  return Uint32Array.of(...pins, indices.indexOf(vertex));
}

/** The corners whose vertices are pinned beside `corner` in its chart, each vertex once. */
export function othersInChart(pins: Pins, arrays: ChartArrays, corner: number): number[] {
  const { indices } = arrays;
  const chart = chartOfCorner(arrays, corner);
  const seen = new Set([indices[corner]]);
  return [...pins].filter((each) => {
    if (chartOfCorner(arrays, each) !== chart || seen.has(indices[each])) return false;
    seen.add(indices[each]);
    return true;
  });
}

/** The vertex nearest to a point of uv within `reach`, of charts that are not hidden; -1 if none. */
export function vertexNear(
  { uv, indices, chartOfTriangle }: ChartArrays,
  hidden: ReadonlySet<number>,
  [u, v]: Point,
  reach: number,
): number {
  let nearest = -1;
  let least = reach * reach;
  for (let corner = 0; corner < indices.length; ++corner) {
    const vertex = indices[corner];
    const [x, y] = [uv[2 * vertex] - u, uv[2 * vertex + 1] - v];
    const distance = x * x + y * y;
    if (!(distance < least)) continue;
    if (hidden.size > 0 && hidden.has(chartOfTriangle[Math.floor(corner / 3)])) continue;
    nearest = vertex;
    least = distance;
  }
  return nearest;
}

/** The pin nearest to a point of uv within `reach`; null if there is none. */
export function pinNear(
  pins: Pins,
  arrays: ChartArrays,
  hidden: ReadonlySet<number>,
  [u, v]: Point,
  reach: number,
): number | null {
  let nearest: number | null = null;
  let least = reach;
  for (const corner of pins) {
    const [x, y] = pointOfCorner(arrays, corner);
    const distance = Math.hypot(x - u, y - v);
    if (!(distance < least) || hidden.has(chartOfCorner(arrays, corner))) continue;
    nearest = corner;
    least = distance;
  }
  return nearest;
}
