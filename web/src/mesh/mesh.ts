/** Triangles as they are drawn. `positions`: xyz per vertex; `indices`: 3 vertices per triangle. */
export interface DisplayMesh {
  positions: Float64Array;
  indices: Uint32Array;
  /** The face that each triangle belongs to, if that is not the triangle itself. */
  faces?: Uint32Array;
}

/**
 * With data that seams may follow: 2 texcoords and a normal per vertex, a normal per corner where
 * vertices have several, a material per triangle, an object per vertex if there are several.
 */
export interface ArrayMesh extends DisplayMesh {
  texcoords?: Float64Array;
  normals?: Float64Array;
  cornerNormals?: Float64Array;
  materials?: Uint32Array;
  vertexObjects?: Uint32Array;
}

/** A flattened mesh as it is drawn: `uv` has 2 per vertex of `indices`. */
export interface FlatMesh extends DisplayMesh {
  uv: Float64Array;
}

export interface Box {
  min: [number, number, number];
  max: [number, number, number];
}

/** Bounding box of the points (`size` coordinates each) named by `vertices`. */
export function boundingBox(points: Float64Array, size: number, vertices: Uint32Array): Box {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < vertices.length; ++i) {
    const v = size * vertices[i];
    for (let d = 0; d < size; ++d) {
      const x = points[v + d];
      if (x < low[d]) low[d] = x;
      if (x > high[d]) high[d] = x;
    }
  }
  const box: Box = { min: [0, 0, 0], max: [0, 0, 0] };
  for (let d = 0; d < size; ++d) {
    if (low[d] > high[d]) continue;
    box.min[d] = low[d];
    box.max[d] = high[d];
  }
  return box;
}

/** The vertices that triangles have, in ascending order. */
export function usedVertices(count: number, indices: Uint32Array): Uint32Array {
  const isUsed = new Uint8Array(count);
  for (let c = 0; c < indices.length; ++c) isUsed[indices[c]] = 1;
  let size = 0;
  for (let v = 0; v < count; ++v) size += isUsed[v];
  const used = new Uint32Array(size);
  for (let v = 0, i = 0; v < count; ++v) if (isUsed[v]) used[i++] = v;
  return used;
}

/** Edges with exactly one triangle, as pairs of vertices in the direction of their triangle. */
export function boundaryEdges(indices: Uint32Array): Uint32Array {
  const next = (h: number) => (h % 3 === 2 ? h - 2 : h + 1);
  // A hash table of half-edges: the first one of each edge, and how often the edge has occurred, up
  // to 2.
  let slotCount = 16;
  while (slotCount < 2 * indices.length) slotCount *= 2;
  const slots = new Int32Array(slotCount).fill(-1);
  const uses = new Uint8Array(indices.length);
  let boundarySize = 0;
  for (let h = 0; h < indices.length; ++h) {
    const a = indices[h];
    const b = indices[next(h)];
    const low = a < b ? a : b;
    const high = a < b ? b : a;
    let hash = Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b);
    hash ^= hash >>> 15;
    for (let slot = hash & (slotCount - 1); ; slot = (slot + 1) & (slotCount - 1)) {
      const first = slots[slot];
      if (first < 0) slots[slot] = h;
      else if (!isEdge(indices[first], indices[next(first)], low, high)) continue;
      const own = first < 0 ? h : first;
      if (uses[own] < 2) boundarySize += uses[own]++ === 0 ? 1 : -1;
      break;
    }
  }
  const edges = new Uint32Array(2 * boundarySize);
  let size = 0;
  for (let h = 0; h < indices.length; ++h) {
    if (uses[h] !== 1) continue;
    edges[size++] = indices[h];
    edges[size++] = indices[next(h)];
  }
  return edges;
}

const isEdge = (a: number, b: number, low: number, high: number) =>
  (a === low && b === high) || (a === high && b === low);

/** Vector areas of all triangles, 3 per triangle: normal times area. */
export function areaVectors({
  positions: p,
  indices,
}: {
  positions: Float64Array | Float32Array;
  indices: Uint32Array;
}): Float64Array {
  const areas = new Float64Array(indices.length);
  for (let c = 0; c < indices.length; c += 3) {
    const i = 3 * indices[c];
    const j = 3 * indices[c + 1];
    const k = 3 * indices[c + 2];
    const ax = p[j] - p[i];
    const ay = p[j + 1] - p[i + 1];
    const az = p[j + 2] - p[i + 2];
    const bx = p[k] - p[i];
    const by = p[k + 1] - p[i + 1];
    const bz = p[k + 2] - p[i + 2];
    areas[c] = (ay * bz - az * by) / 2;
    areas[c + 1] = (az * bx - ax * bz) / 2;
    areas[c + 2] = (ax * by - ay * bx) / 2;
  }
  return areas;
}

/** Area of each triangle, given points with `size` coordinates. */
export function triangleAreas(p: Float64Array, size: 2 | 3, indices: Uint32Array): Float64Array {
  const areas = new Float64Array(indices.length / 3);
  for (let f = 0; f < areas.length; ++f) {
    const i = size * indices[3 * f];
    const j = size * indices[3 * f + 1];
    const k = size * indices[3 * f + 2];
    const ax = p[j] - p[i];
    const ay = p[j + 1] - p[i + 1];
    const az = size === 3 ? p[j + 2] - p[i + 2] : 0;
    const bx = p[k] - p[i];
    const by = p[k + 1] - p[i + 1];
    const bz = size === 3 ? p[k + 2] - p[i + 2] : 0;
    areas[f] = Math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx) / 2;
  }
  return areas;
}

/** Area of each triangle of a layout, on the surface and in uv. */
export interface TriangleAreas {
  in3d: Float64Array;
  inUv: Float64Array;
}

export const areasOf = ({ positions, uv, indices }: FlatMesh): TriangleAreas => ({
  in3d: triangleAreas(positions, 3, indices),
  inUv: triangleAreas(uv, 2, indices),
});

/** Unit normals per vertex, weighted by area; 0 if there is no area. */
export function vertexNormals(mesh: DisplayMesh, areas = areaVectors(mesh)): Float32Array {
  const sums = new Float64Array(mesh.positions.length);
  for (let c = 0; c < mesh.indices.length; ++c) {
    const v = 3 * mesh.indices[c];
    const f = c - (c % 3);
    sums[v] += areas[f];
    sums[v + 1] += areas[f + 1];
    sums[v + 2] += areas[f + 2];
  }
  const normals = new Float32Array(sums.length);
  for (let i = 0; i < sums.length; i += 3) {
    const length = Math.hypot(sums[i], sums[i + 1], sums[i + 2]);
    if (length > 0) for (let d = 0; d < 3; ++d) normals[i + d] = sums[i + d] / length;
  }
  return normals;
}

/**
 * The direction that an open surface faces, and how clearly: 1 for a plane, 0 for a closed surface.
 * The vector areas of a surface sum to that of its hole.
 */
export function facing(mesh: DisplayMesh, areas = areaVectors(mesh)): Facing {
  const sum = [0, 0, 0];
  let total = 0;
  for (let i = 0; i < areas.length; i += 3) {
    for (let d = 0; d < 3; ++d) sum[d] += areas[i + d];
    total += Math.hypot(areas[i], areas[i + 1], areas[i + 2]);
  }
  return facingOf(sum, total);
}

export interface Facing {
  direction: [number, number, number];
  clarity: number;
}

/** The same for a surface with this sum of vector areas and this total area. */
export function facingOf([x, y, z]: ArrayLike<number> & Iterable<number>, total: number): Facing {
  const length = Math.hypot(x, y, z);
  if (length === 0) return { direction: [0, 0, 1], clarity: 0 };
  return { direction: [x / length, y / length, z / length], clarity: length / total };
}

/**
 * Copies values per vertex (`size` numbers each) to every corner, as drawing without an index
 * requires.
 */
export function perCorner(
  values: Float32Array | Float64Array,
  size: 2 | 3,
  indices: Uint32Array,
): Float32Array {
  const corners = new Float32Array(size * indices.length);
  for (let c = 0; c < indices.length; ++c) {
    const to = size * c;
    const from = size * indices[c];
    corners[to] = values[from];
    corners[to + 1] = values[from + 1];
    if (size === 3) corners[to + 2] = values[from + 2];
  }
  return corners;
}

/** Copies one value per triangle to its three corners. */
export function toCorners(perTriangle: Float32Array | Uint32Array): Float32Array {
  const corners = new Float32Array(3 * perTriangle.length);
  for (let c = 0; c < corners.length; ++c) corners[c] = perTriangle[(c - (c % 3)) / 3];
  return corners;
}
