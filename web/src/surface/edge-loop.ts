import { otherEnd, type SurfaceGraph } from './surface-graph';

/**
 * The edges that go straight on from one, on both sides: through vertices where faces meet as in
 * the plane, up to a boundary or another vertex, or all around.
 */
export function edgeLoop(graph: SurfaceGraph, edge: number): number[] {
  if (!graph.isInner[edge]) return [];
  const loop = new Set([edge]);
  for (const end of [0, 1]) {
    let place = graph.ends[2 * edge + end];
    let next = opposite(graph, place, edge);
    while (next >= 0 && !loop.has(next)) {
      loop.add(next);
      place = otherEnd(graph, next, place);
      next = opposite(graph, place, next);
    }
  }
  return [...loop];
}

/**
 * The edge opposite another one at a place where four faces meet, or six if all are triangles; -1
 * anywhere else.
 */
function opposite(graph: SurfaceGraph, place: number, edge: number): number {
  const degree = graph.firstAt[place + 1] - graph.firstAt[place];
  if (degree !== (graph.isTriangular ? 6 : 4)) return -1;
  let [at, face] = [edge, graph.sides[2 * edge]];
  let middle = -1;
  for (let step = 1; step <= degree; ++step) {
    const next = nextAround(graph, place, at, face);
    if (next < 0) return -1;
    if (step === degree / 2) middle = next;
    at = next;
    face = otherSide(graph, next, face);
  }
  return at === edge && middle !== edge ? middle : -1;
}

/** The other edge of a face at a place; -1 if there is not exactly one. */
function nextAround(graph: SurfaceGraph, place: number, edge: number, face: number): number {
  const { firstAt, edgesAt, sides, isInner } = graph;
  let next = -1;
  for (let i = firstAt[place]; i < firstAt[place + 1]; ++i) {
    const other = edgesAt[i];
    if (other === edge || !isInner[other]) continue;
    if (sides[2 * other] !== face && sides[2 * other + 1] !== face) continue;
    if (next >= 0) return -1;
    next = other;
  }
  return next;
}

const otherSide = ({ sides }: SurfaceGraph, edge: number, face: number) =>
  sides[2 * edge] === face ? sides[2 * edge + 1] : sides[2 * edge];
