import { areaVectors, type DisplayMesh } from '../mesh/mesh';

/** In place of a face, where an edge has none. */
export const NO_FACE = 0xffffffff;

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
  /** Whether all faces are triangles. */
  isTriangular: boolean;
  /** The two faces of each edge; none if there are more. */
  sides: Uint32Array;
  /** The angle between the normals of its two triangles, in degrees; 0 if there are not two. */
  bends: Float32Array;
  /** The edges around place v are edgesAt[firstAt[v]] to edgesAt[firstAt[v + 1] - 1]. */
  firstAt: Uint32Array;
  edgesAt: Uint32Array;
}

/** The three sides of every triangle, sorted by their lower place, then by the higher one. */
interface Sides {
  low: Uint32Array;
  high: Uint32Array;
  triangle: Uint32Array;
}

/** `faces`: the face of each triangle. Edges inside a face only triangulate it and are left out. */
export function surfaceGraph(
  { positions, indices }: DisplayMesh,
  places: Uint32Array,
  faces: Uint32Array | undefined,
): SurfaceGraph {
  const { ends, uses, triangles } = uniqueEdges(sortedSides(indices, places), faces);
  const areas = areaVectors({ positions, indices });
  const sides = new Uint32Array(2 * uses.length).fill(NO_FACE);
  const bends = new Float32Array(uses.length);
  const lengths = new Float64Array(uses.length);
  const isInner = new Uint8Array(uses.length);
  for (let e = 0; e < uses.length; ++e) {
    const a = 3 * ends[2 * e];
    const b = 3 * ends[2 * e + 1];
    isInner[e] = Number(uses[e] > 1);
    lengths[e] = Math.hypot(
      positions[a] - positions[b],
      positions[a + 1] - positions[b + 1],
      positions[a + 2] - positions[b + 2],
    );
    if (uses[e] > 2) continue;
    const s = triangles[2 * e];
    sides[2 * e] = faces ? faces[s] : s;
    if (uses[e] < 2) continue;
    const t = triangles[2 * e + 1];
    sides[2 * e + 1] = faces ? faces[t] : t;
    const from = ends[2 * e];
    const to = ends[2 * e + 1];
    // Neighbours that face opposite ways run along their edge in the same direction.
    const areOpposite =
      runsAlong(indices, places, s, from, to) === runsAlong(indices, places, t, from, to);
    bends[e] = degreesBetween(areas, 3 * s, 3 * t, areOpposite ? -1 : 1);
  }
  const isTriangular = faces === undefined;
  return {
    ...{ places, ends, lengths, isInner, isTriangular, sides, bends },
    ...around(ends, places.length),
  };
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

/** Whether a triangle goes from one place to the other along its border. */
function runsAlong(
  indices: Uint32Array,
  places: Uint32Array,
  triangle: number,
  from: number,
  to: number,
): boolean {
  const i = places[indices[3 * triangle]];
  const j = places[indices[3 * triangle + 1]];
  const k = places[indices[3 * triangle + 2]];
  return (i === from && j === to) || (j === from && k === to) || (k === from && i === to);
}

/**
 * The angle between two vectors in an array, the second one times a sign; 0 if one of them has no
 * length.
 */
function degreesBetween(v: ArrayLike<number>, i: number, j: number, sign: 1 | -1): number {
  const x = v[i + 1] * v[j + 2] - v[i + 2] * v[j + 1];
  const y = v[i + 2] * v[j] - v[i] * v[j + 2];
  const z = v[i] * v[j + 1] - v[i + 1] * v[j];
  const along = v[i] * v[j] + v[i + 1] * v[j + 1] + v[i + 2] * v[j + 2];
  // Not -0, whose angle is 180 degrees.
  return (Math.atan2(Math.hypot(x, y, z), sign * along || 0) * 180) / Math.PI;
}

function sortedSides(indices: Uint32Array, places: Uint32Array): Sides {
  const low = new Uint32Array(indices.length);
  const high = new Uint32Array(indices.length);
  const triangle = new Uint32Array(indices.length);
  let size = 0;
  const add = (a: number, b: number, t: number) => {
    low[size] = a < b ? a : b;
    high[size] = a < b ? b : a;
    triangle[size++] = t;
  };
  for (let c = 0; c < indices.length; c += 3) {
    const i = places[indices[c]];
    const j = places[indices[c + 1]];
    const k = places[indices[c + 2]];
    if (i === j || j === k || k === i) continue; // no area, no edges
    add(i, j, c / 3);
    add(j, k, c / 3);
    add(k, i, c / 3);
  }
  const byHigh = ordered(high.subarray(0, size), places.length);
  const byBoth = ordered(pick(low, byHigh), places.length);
  const order = pick(byHigh, byBoth);
  return { low: pick(low, order), high: pick(high, order), triangle: pick(triangle, order) };
}

/** The indices of keys below `most`, smallest key first, equal ones in their order. */
function ordered(keys: Uint32Array, most: number): Uint32Array {
  const next = new Uint32Array(most + 1);
  for (let i = 0; i < keys.length; ++i) next[keys[i] + 1] += 1;
  for (let key = 0; key < most; ++key) next[key + 1] += next[key];
  const order = new Uint32Array(keys.length);
  for (let i = 0; i < keys.length; ++i) order[next[keys[i]]++] = i;
  return order;
}

function pick(values: Uint32Array, rows: Uint32Array): Uint32Array {
  const picked = new Uint32Array(rows.length);
  for (let i = 0; i < rows.length; ++i) picked[i] = values[rows[i]];
  return picked;
}

interface UniqueEdges {
  ends: Uint32Array;
  /** The number of faces of each edge. */
  uses: Uint32Array;
  /** The first two triangles of each edge. */
  triangles: Uint32Array;
}

/** Each edge of a face once. */
function uniqueEdges({ low, high, triangle }: Sides, faces: Uint32Array | undefined): UniqueEdges {
  const ends = new Uint32Array(2 * low.length);
  const triangles = new Uint32Array(2 * low.length);
  const uses = new Uint32Array(low.length);
  let size = 0;
  for (let from = 0, to = 0; from < low.length; from = to) {
    while (to < low.length && low[to] === low[from] && high[to] === high[from]) ++to;
    let found = 0;
    for (let i = from; i < to; ++i) {
      if (faces && isInside(triangle, from, to, i, faces)) continue;
      if (found < 2) triangles[2 * size + found] = triangle[i];
      ++found;
    }
    if (found === 0) continue;
    ends[2 * size] = low[from];
    ends[2 * size + 1] = high[from];
    uses[size++] = found;
  }
  return {
    ends: ends.slice(0, 2 * size),
    uses: uses.slice(0, size),
    triangles: triangles.slice(0, 2 * size),
  };
}

/**
 * Whether side `i`, one of the sides `from` to `to` of an edge, is inside a face: there, an edge has
 * two triangles of that face.
 */
function isInside(
  triangle: Uint32Array,
  from: number,
  to: number,
  i: number,
  faces: Uint32Array,
): boolean {
  for (let j = from; j < to; ++j)
    if (j !== i && faces[triangle[j]] === faces[triangle[i]]) return true;
  return false;
}

function around(ends: Uint32Array, placeCount: number) {
  const firstAt = new Uint32Array(placeCount + 1);
  for (let i = 0; i < ends.length; ++i) firstAt[ends[i] + 1] += 1;
  for (let v = 0; v < placeCount; ++v) firstAt[v + 1] += firstAt[v];
  const edgesAt = new Uint32Array(ends.length);
  const next = firstAt.slice();
  for (let i = 0; i < ends.length; ++i) edgesAt[next[ends[i]]++] = i >> 1;
  return { firstAt, edgesAt };
}
