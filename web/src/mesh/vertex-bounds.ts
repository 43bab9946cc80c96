import type { VertexBound } from 'abflat';

export type VertexBounds = readonly VertexBound[];

/** Bounds with t for some more vertices, in the order of vertices. */
export function withBound(bounds: VertexBounds, vertices: Iterable<number>, t: number) {
  const all = new Map(bounds.map((bound) => [bound.vertex, bound.t]));
  for (const vertex of vertices) all.set(vertex, t);
  return [...all].map(([vertex, t]) => ({ vertex, t })).sort((a, b) => a.vertex - b.vertex);
}

/** Bounds without those of some vertices. */
export function withoutBound(bounds: VertexBounds, vertices: Iterable<number>): VertexBound[] {
  const left = new Set(vertices);
  return bounds.filter(({ vertex }) => !left.has(vertex));
}

/** The number of vertices whose bound differs. */
export function differences(before: VertexBounds, after: VertexBounds): number {
  const left = new Map(before.map(({ vertex, t }) => [vertex, t]));
  let count = 0;
  for (const { vertex, t } of after) {
    if (left.get(vertex) !== t) ++count;
    left.delete(vertex);
  }
  return count + left.size;
}
