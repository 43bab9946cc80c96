import { outlines } from '../mesh/outlines';
import type { ChartMesh } from './chart-mesh';
import type { Point } from './motion';
import type { OwnMesh } from './own-mesh';

/**
 * The layout of a chart that is a grid of quads as a rectangle, whose columns and rows are as wide as they are on the
 * surface; null if it is no such grid. `faces`: the face of each triangle.
 */
export function gridLayout(
  { positions }: ChartMesh,
  { indices, same }: OwnMesh,
  faces: Uint32Array,
): Float64Array | null {
  const quads = [...outlines({ positions, indices, faces })];
  if (quads.length === 0 || quads.some(({ length }) => length !== 4)) return null;
  const places = placesOf(quads);
  if (!places) return null;
  const all = [...places.values()];
  const low = [0, 1].map((d) => all.reduce((least, place) => Math.min(least, place[d]), Infinity));
  const high = [0, 1].map((d) => all.reduce((most, place) => Math.max(most, place[d]), -Infinity));
  const [columns, rows] = [high[0] - low[0], high[1] - low[1]];
  const isFull = quads.length === columns * rows && places.size === (columns + 1) * (rows + 1);
  if (!isFull || new Set(all.map(String)).size < all.length) return null;
  const stops = [0, 1].map((d) => stopsAlong(d, quads, places, positions, low[d], high[d]));
  const layout = new Float64Array(2 * same.length);
  same.forEach((first, v) => {
    const place = places.get(first);
    for (const d of [0, 1]) layout[2 * v + d] = place ? stops[d][place[d] - low[d]] : 0;
  });
  return layout;
}

/** Column and row of each vertex, walking from quad to quad; null where that leads to two places. */
function placesOf(quads: number[][]): Map<number, Point> | null {
  const quadAt = new Map<string, number>();
  quads.forEach((quad, q) => {
    quad.forEach((from, i) => {
      quadAt.set(`${from} ${quad[(i + 1) % 4]}`, q);
    });
  });
  const [[a, b]] = quads;
  const places = new Map<number, Point>([
    [a, [0, 0]],
    [b, [1, 0]],
  ]);
  const waiting: [number, number][] = [[a, b]];
  const isDone = new Set<number>();
  for (let side = waiting.pop(); side; side = waiting.pop()) {
    const q = quadAt.get(side.join(' '));
    if (q === undefined || isDone.has(q)) continue;
    isDone.add(q);
    const at = quads[q].indexOf(side[0]);
    const quad = [0, 1, 2, 3].map((i) => quads[q][(at + i) % 4]);
    const [[x0, y0], [x1, y1]] = side.map((v) => places.get(v) as Point);
    const [dx, dy] = [x1 - x0, y1 - y0];
    const corners: Point[] = [
      [x0, y0],
      [x1, y1],
      [x1 - dy, y1 + dx],
      [x0 - dy, y0 + dx],
    ];
    for (const [i, v] of quad.entries()) {
      const known = places.get(v);
      if (known && String(known) !== String(corners[i])) return null;
      places.set(v, corners[i]);
      waiting.push([quad[(i + 1) % 4], v]);
    }
  }
  return isDone.size === quads.length ? places : null;
}

/** Where columns (0) or rows (1) begin and end, by the mean length of their edges. */
function stopsAlong(
  d: number,
  quads: number[][],
  places: Map<number, Point>,
  positions: Float64Array,
  low: number,
  high: number,
): number[] {
  const [sums, counts] = [0, 0].map(() => new Float64Array(high - low));
  for (const quad of quads)
    quad.forEach((from, i) => {
      const to = quad[(i + 1) % 4];
      const [p, q] = [from, to].map((v) => (places.get(v) as Point)[d] - low);
      if (p === q) return;
      sums[Math.min(p, q)] += distance(positions, from, to);
      counts[Math.min(p, q)] += 1;
    });
  const stops = [0];
  sums.forEach((sum, i) => {
    stops.push(stops[i] + sum / counts[i]);
  });
  return stops;
}

export const distance = (p: Float64Array, v: number, w: number): number =>
  Math.hypot(p[3 * v] - p[3 * w], p[3 * v + 1] - p[3 * w + 1], p[3 * v + 2] - p[3 * w + 2]);
