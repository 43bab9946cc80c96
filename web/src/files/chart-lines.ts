import { weld } from '../mesh/weld';
import { chains } from './chains';

/** An atlas as it is drawn. */
export interface AtlasShape {
  /** 2 per vertex. */
  uv: Float64Array;
  /** 3 vertices per triangle. */
  indices: Uint32Array;
  /** The chart of each triangle; not a valid chart number for a triangle without area. */
  charts: Uint32Array;
  /** The face of each triangle, if that is not the triangle itself. */
  faces?: Uint32Array;
  chartCount: number;
}

/**
 * The lines that are drawn of a chart, as runs of vertices. Outlines are closed, with the chart on
 * their left.
 */
export interface ChartLines {
  outline: number[][];
  inner: number[][];
}

/** The lines of each chart: edges of faces, without those that only triangulate them. */
export function chartLines({ uv, indices, charts, faces, chartCount }: AtlasShape): ChartLines[] {
  const points = weld(uv, 2);
  const corners = indices.map((v) => points[v]);
  const next = (h: number) => (h % 3 === 2 ? h - 2 : h + 1);
  const triangleOf = (h: number) => Math.floor(h / 3);
  const key = (from: number, to: number) => from * points.length + to;
  const halfEdges = new Map<number, number>();
  for (let h = 0; h < corners.length; ++h)
    if (charts[triangleOf(h)] < chartCount) halfEdges.set(key(corners[h], corners[next(h)]), h);
  const edges = Array.from({ length: chartCount }, () => ({
    outline: [] as number[],
    inner: [] as number[],
  }));
  for (const h of halfEdges.values()) {
    const [from, to] = [corners[h], corners[next(h)]];
    const [triangle, twin] = [triangleOf(h), halfEdges.get(key(to, from))];
    if (from === to) continue; // an edge of a triangle without area
    const other = twin === undefined ? -1 : triangleOf(twin);
    const own = edges[charts[triangle]];
    if (other < 0 || charts[other] !== charts[triangle]) own.outline.push(from, to);
    else if (from < to && (faces?.[triangle] ?? triangle) !== (faces?.[other] ?? other))
      own.inner.push(from, to);
  }
  return edges.map(({ outline, inner }) => ({
    outline: chains(outline, false),
    inner: chains(inner, true),
  }));
}
