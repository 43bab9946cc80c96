import type { DisplayMesh } from '../mesh/mesh';

/**
 * The edges of a surface, between its places: vertices at the same point share a place, which is
 * the first of them.
 */
export interface SurfaceGraph {
  /** The place of each vertex. */
  places: Uint32Array;
  /** Two places per edge, the lower one first. */
  ends: Uint32Array;
  lengths: Float64Array;
  /** Per edge: whether it has faces on both sides, so that it can be cut. */
  isInner: Uint8Array;
  /** The edges around place v are edgesAt[firstAt[v]] to edgesAt[firstAt[v + 1] - 1]. */
  firstAt: Uint32Array;
  edgesAt: Uint32Array;
}

/** The three sides of every triangle, sorted by their lower place, then by the higher one. */
interface Sides {
  low: Uint32Array;
  high: Uint32Array;
  face: Uint32Array;
}

/** `faces`: the face of each triangle. Edges inside a face only triangulate it and are left out. */
export function surfaceGraph(
  { positions, indices }: DisplayMesh,
  places: Uint32Array,
  faces: Uint32Array | undefined,
): SurfaceGraph {
  const { ends, uses } = uniqueEdges(sortedSides(indices, places, faces));
  const lengths = new Float64Array(uses.length);
  const isInner = new Uint8Array(uses.length);
  for (let e = 0; e < uses.length; ++e) {
    const [a, b] = [3 * ends[2 * e], 3 * ends[2 * e + 1]];
    isInner[e] = Number(uses[e] > 1);
    lengths[e] = Math.hypot(
      positions[a] - positions[b],
      positions[a + 1] - positions[b + 1],
      positions[a + 2] - positions[b + 2],
    );
  }
  return { places, ends, lengths, isInner, ...around(ends, places.length) };
}

export function otherEnd({ ends }: SurfaceGraph, edge: number, place: number): number {
  return ends[2 * edge] === place ? ends[2 * edge + 1] : ends[2 * edge];
}

/** The edge between two vertices, -1 if there is none. */
export function edgeBetween(graph: SurfaceGraph, a: number, b: number): number {
  const [from, to] = [graph.places[a], graph.places[b]];
  for (let i = graph.firstAt[from]; i < graph.firstAt[from + 1]; ++i)
    if (otherEnd(graph, graph.edgesAt[i], from) === to) return graph.edgesAt[i];
  return -1;
}

function sortedSides(
  indices: Uint32Array,
  places: Uint32Array,
  faces: Uint32Array | undefined,
): Sides {
  const low = new Uint32Array(indices.length);
  const high = new Uint32Array(indices.length);
  const face = new Uint32Array(indices.length);
  let size = 0;
  const add = (a: number, b: number, triangle: number) => {
    low[size] = a < b ? a : b;
    high[size] = a < b ? b : a;
    face[size++] = faces ? faces[triangle] : triangle;
  };
  for (let c = 0; c < indices.length; c += 3) {
    const [i, j, k] = [places[indices[c]], places[indices[c + 1]], places[indices[c + 2]]];
    if (i === j || j === k || k === i) continue; // no area, no edges
    add(i, j, c / 3);
    add(j, k, c / 3);
    add(k, i, c / 3);
  }
  const byHigh = ordered(high.subarray(0, size), places.length);
  const byBoth = ordered(pick(low, byHigh), places.length);
  const order = pick(byHigh, byBoth);
  return { low: pick(low, order), high: pick(high, order), face: pick(face, order) };
}

/** The indices of keys below `most`, smallest key first, equal ones in their order. */
function ordered(keys: Uint32Array, most: number): Uint32Array {
  const next = new Uint32Array(most + 1);
  for (const key of keys) next[key + 1] += 1;
  for (let key = 0; key < most; ++key) next[key + 1] += next[key];
  const order = new Uint32Array(keys.length);
  keys.forEach((key, i) => {
    order[next[key]++] = i;
  });
  return order;
}

function pick(values: Uint32Array, rows: Uint32Array): Uint32Array {
  const picked = new Uint32Array(rows.length);
  for (let i = 0; i < rows.length; ++i) picked[i] = values[rows[i]];
  return picked;
}

/** Each edge of a face once, with its number of faces. */
function uniqueEdges({ low, high, face }: Sides): { ends: Uint32Array; uses: Uint32Array } {
  const ends = new Uint32Array(2 * low.length);
  const uses = new Uint32Array(low.length);
  let size = 0;
  for (let from = 0, to = 0; from < low.length; from = to) {
    while (to < low.length && low[to] === low[from] && high[to] === high[from]) ++to;
    const sides = sidesOfFaces(face, from, to);
    if (sides === 0) continue;
    ends[2 * size] = low[from];
    ends[2 * size + 1] = high[from];
    uses[size++] = sides;
  }
  return { ends: ends.slice(0, 2 * size), uses: uses.slice(0, size) };
}

/**
 * How many of the sides `from` to `to` are not diagonals: inside a face, an edge has two triangles
 * of that face.
 */
function sidesOfFaces(face: Uint32Array, from: number, to: number): number {
  let sides = 0;
  for (let i = from; i < to; ++i) {
    let isDiagonal = false;
    for (let j = from; j < to; ++j) if (j !== i && face[j] === face[i]) isDiagonal = true;
    if (!isDiagonal) ++sides;
  }
  return sides;
}

function around(ends: Uint32Array, placeCount: number) {
  const firstAt = new Uint32Array(placeCount + 1);
  for (const v of ends) firstAt[v + 1] += 1;
  for (let v = 0; v < placeCount; ++v) firstAt[v + 1] += firstAt[v];
  const edgesAt = new Uint32Array(ends.length);
  const next = firstAt.slice();
  ends.forEach((v, i) => {
    edgesAt[next[v]++] = i >> 1;
  });
  return { firstAt, edgesAt };
}
