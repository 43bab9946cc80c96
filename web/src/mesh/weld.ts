import type { ArrayMesh } from './mesh';

/** For every point (`size` coordinates each), the first point with the same coordinates. */
export function weld(points: Float64Array, size: number): Uint32Array {
  const count = points.length / size;
  const numbers = new Float64Array(points.length);
  for (let i = 0; i < points.length; ++i) numbers[i] = points[i] + 0; // no negative zero
  const bits = new Uint32Array(numbers.buffer);
  let slotCount = 16;
  while (slotCount < 2 * count) slotCount *= 2;
  const EMPTY = 0xffffffff;
  const slots = new Uint32Array(slotCount).fill(EMPTY);
  const words = 2 * size;
  const isSame = (a: number, b: number) => {
    for (let k = 0; k < words; ++k) if (bits[words * a + k] !== bits[words * b + k]) return false;
    return true;
  };
  const first = new Uint32Array(count);
  for (let v = 0; v < count; ++v) {
    let hash = 0;
    for (let k = 0; k < words; ++k)
      hash = Math.imul(hash ^ bits[words * v + k], 0x9e3779b1) ^ (hash >>> 15);
    let slot = (hash ^ (hash >>> 13)) & (slotCount - 1);
    while (slots[slot] !== EMPTY && !isSame(slots[slot], v)) slot = (slot + 1) & (slotCount - 1);
    if (slots[slot] === EMPTY) slots[slot] = v;
    first[v] = slots[slot];
  }
  return first;
}

/**
 * The mesh with vertices at the same point joined. A joined vertex had several texcoords, so there
 * are none; normals are those of corners.
 */
export function joined({ positions, indices, normals, materials }: ArrayMesh): ArrayMesh {
  const first = weld(positions, 3);
  const cornerNormals = normals && ofCorners(normals, indices);
  return { positions, indices: indices.map((vertex) => first[vertex]), cornerNormals, materials };
}

function ofCorners(normals: Float64Array, indices: Uint32Array): Float64Array {
  const corners = new Float64Array(3 * indices.length);
  indices.forEach((vertex, c) => {
    for (let d = 0; d < 3; ++d) corners[3 * c + d] = normals[3 * vertex + d];
  });
  return corners;
}
