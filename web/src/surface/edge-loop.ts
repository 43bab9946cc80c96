import { edgeBetween, otherEnd, type SurfaceGraph } from './surface-graph';

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
 * The edge opposite another one at a place where six triangles meet, or four faces that are not all
 * triangles; -1 anywhere else.
 */
function opposite(graph: SurfaceGraph, place: number, edge: number): number {
  const degree = graph.firstAt[place + 1] - graph.firstAt[place];
  if (degree !== 4 && degree !== 6) return -1;
  let [at, face] = [edge, graph.sides[2 * edge]];
  let [middle, triangles] = [-1, 0];
  for (let step = 1; step <= degree; ++step) {
    const next = nextAround(graph, place, at, face);
    if (next < 0) return -1;
    if (closesTriangle(graph, place, at, next, face)) ++triangles;
    if (step === degree / 2) middle = next;
    at = next;
    face = otherSide(graph, next, face);
  }
  const isWhole = at === edge && middle !== edge;
  return isWhole && (degree === 6) === (triangles === degree) ? middle : -1;
}

/** The other edge of a face at a place; -1 if there is not exactly one. */
function nextAround(graph: SurfaceGraph, place: number, edge: number, face: number): number {
  let next = -1;
  for (let i = graph.firstAt[place]; i < graph.firstAt[place + 1]; ++i) {
    const other = graph.edgesAt[i];
    if (other === edge || !isSide(graph, other, face) || !graph.isInner[other]) continue;
    if (next >= 0) return -1;
    next = other;
  }
  return next;
}

const isSide = ({ sides }: SurfaceGraph, edge: number, face: number) =>
  sides[2 * edge] === face || sides[2 * edge + 1] === face;

const otherSide = ({ sides }: SurfaceGraph, edge: number, face: number) =>
  sides[2 * edge] === face ? sides[2 * edge + 1] : sides[2 * edge];

/** Whether two edges of a face that meet at a place have its third one between their other ends. */
function closesTriangle(
  graph: SurfaceGraph,
  place: number,
  a: number,
  b: number,
  face: number,
): boolean {
  const third = edgeBetween(graph, otherEnd(graph, a, place), otherEnd(graph, b, place));
  return third >= 0 && isSide(graph, third, face);
}
