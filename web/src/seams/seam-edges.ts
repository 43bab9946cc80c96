import { edgeBetween, otherEnd, type SurfaceGraph } from '../surface/surface-graph';

/** Seams as flags of the surface's edges: 1 if the edge is a seam. */
export type EdgeFlags = Uint8Array;

/** Seams given by two vertices each; pairs that are not an edge are left out. */
export function flagsOf(graph: SurfaceGraph, pairs: Uint32Array): EdgeFlags {
  const flags = new Uint8Array(graph.lengths.length);
  for (let i = 0; i + 1 < pairs.length; i += 2) {
    const edge = edgeBetween(graph, pairs[i], pairs[i + 1]);
    if (edge >= 0) flags[edge] = 1;
  }
  return flags;
}

/** The flagged edges as two vertices each. */
export function pairsOf({ ends }: SurfaceGraph, flags: EdgeFlags): Uint32Array {
  const pairs: number[] = [];
  for (let edge = 0; edge < flags.length; ++edge)
    if (flags[edge]) pairs.push(ends[2 * edge], ends[2 * edge + 1]);
  return Uint32Array.from(pairs);
}

/**
 * The seam through an edge, up to the nearest junction, end or boundary on both sides; all of it if
 * it is a loop.
 */
export function seamRun(graph: SurfaceGraph, flags: EdgeFlags, edge: number): number[] {
  const run = new Set([edge]);
  for (const end of [0, 1]) {
    let place = graph.ends[2 * edge + end];
    let next = nextAlong(graph, flags, place, edge);
    while (next >= 0 && !run.has(next)) {
      run.add(next);
      place = otherEnd(graph, next, place);
      next = nextAlong(graph, flags, place, next);
    }
  }
  return [...run];
}

/** The one seam edge that continues `edge` at a place; -1 if there is none or more than one. */
function nextAlong(graph: SurfaceGraph, flags: EdgeFlags, place: number, edge: number): number {
  let next = -1;
  for (let i = graph.firstAt[place]; i < graph.firstAt[place + 1]; ++i) {
    const other = graph.edgesAt[i];
    if (other === edge) continue;
    if (!graph.isInner[other]) return -1;
    if (!flags[other]) continue;
    if (next >= 0) return -1;
    next = other;
  }
  return next;
}
