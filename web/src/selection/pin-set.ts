// Pins as corners of the atlas's triangles: their numbers stay the same however the mesh is cut.

import { type ChartArrays, pointOf } from '../arrange/charts';
import type { Point } from '../arrange/motion';

export type Pins = Uint32Array;

export const chartOfCorner = ({ chartOfTriangle }: ChartArrays, corner: number): number =>
  chartOfTriangle[Math.floor(corner / 3)];

export const pointOfCorner = ({ uv, indices }: ChartArrays, corner: number): Point =>
  pointOf(uv, indices[corner]);

/** Pins the vertex of a corner, or removes its pin. */
export function toggled(pins: Pins, { indices }: ChartArrays, corner: number): Pins {
  const others = pins.filter((each) => indices[each] !== indices[corner]);
  return others.length < pins.length ? others : Uint32Array.of(...pins, corner);
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

/**
 * A corner of the vertex nearest to a point of uv within `reach`, of charts that are not hidden;
 * null if there is none.
 */
export function cornerNear(
  arrays: ChartArrays,
  hidden: ReadonlySet<number>,
  [u, v]: Point,
  reach: number,
): number | null {
  const { uv, indices } = arrays;
  const isHidden = (vertex: number) =>
    hidden.size > 0 && hidden.has(chartOfCorner(arrays, indices.indexOf(vertex)));
  let nearest: number | null = null;
  let least = reach * reach;
  for (let vertex = 0; 2 * vertex < uv.length; ++vertex) {
    const [x, y] = [uv[2 * vertex] - u, uv[2 * vertex + 1] - v];
    const distance = x * x + y * y;
    if (!(distance < least) || isHidden(vertex)) continue;
    nearest = vertex;
    least = distance;
  }
  return nearest === null ? null : indices.indexOf(nearest);
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

/** The pinned vertices of a chart, as numbers of its own. */
export const pinsInChart = (
  pins: Pins,
  { indices }: Pick<ChartArrays, 'indices'>,
  { vertices }: { vertices: Uint32Array },
): number[] =>
  [...new Set(pins)].map((each) => vertices.indexOf(indices[each])).filter((v) => v >= 0);
