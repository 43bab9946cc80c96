import { FLAT_FRAME } from '../model/drawing';
import type { Point } from './motion';

/** The arrays of an atlas that moving its charts needs. */
export interface ChartArrays {
  /** 2 per vertex; no vertex belongs to more than one chart. */
  uv: Float64Array;
  indices: Uint32Array;
  chartOfTriangle: Uint32Array;
}

/** Faces without area that nothing touches have none. */
export const isChart = (chart: number) => chart !== 0xffffffff;

/** The vertices of each of some charts, each once. */
export function verticesOf(
  { uv, indices, chartOfTriangle }: ChartArrays,
  charts: Uint32Array,
): Map<number, number[]> {
  const found = new Map<number, number[]>([...charts].map((chart) => [chart, []]));
  const isSeen = new Uint8Array(uv.length / 2);
  chartOfTriangle.forEach((chart, f) => {
    const vertices = found.get(chart);
    if (!vertices) return;
    for (let i = 3 * f; i < 3 * f + 3; ++i) {
      const v = indices[i];
      if (isSeen[v]) continue;
      isSeen[v] = 1;
      vertices.push(v);
    }
  });
  return found;
}

export const pointOf = (uv: ArrayLike<number>, v: number): Point => [uv[2 * v], uv[2 * v + 1]];

/** The triangles of each of some charts. */
export function trianglesOf(chartOfTriangle: Uint32Array, charts: Uint32Array) {
  const found = new Map<number, number[]>([...charts].map((chart) => [chart, []]));
  chartOfTriangle.forEach((chart, f) => {
    found.get(chart)?.push(f);
  });
  return found;
}

export interface Box {
  low: Point;
  high: Point;
}

/** The smallest box that contains all these vertices. */
export function boxOf(uv: ArrayLike<number>, vertices: Iterable<number>): Box {
  const box: Box = { low: [Infinity, Infinity], high: [-Infinity, -Infinity] };
  for (const v of vertices)
    for (const d of [0, 1] as const) {
      box.low[d] = Math.min(box.low[d], uv[2 * v + d]);
      box.high[d] = Math.max(box.high[d], uv[2 * v + d]);
    }
  return box;
}

export const middleOf = ({ low, high }: Box): Point => [
  (low[0] + high[0]) / 2,
  (low[1] + high[1]) / 2,
];

/** The box around some charts; `frames` has the `FLAT_FRAME` of each. There may be too many for the arguments of a call. */
export function boxInFrames(frames: Float32Array, charts: Iterable<number>): Box {
  const { size, low, high } = FLAT_FRAME;
  const box: Box = { low: [Infinity, Infinity], high: [-Infinity, -Infinity] };
  for (const chart of charts)
    for (const d of [0, 1] as const) {
      box.low[d] = Math.min(box.low[d], frames[size * chart + low + d]);
      box.high[d] = Math.max(box.high[d], frames[size * chart + high + d]);
    }
  return box;
}
