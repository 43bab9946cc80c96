// Several meshes as one, so that they share an atlas.

import type { Part } from './decl.js';

/** The drawn faces of all parts. */
export interface Joined {
  positions: Float64Array;
  indices: Uint32Array;
  normals?: Float64Array | undefined;
  materials?: Uint32Array | undefined;
  /** NaN for vertices without any. */
  texcoords?: Float64Array | undefined;
}

const verticesOf = (part: Part) => part.positions.length / 3;

/** The first vertex of each part. */
export function startsOf(parts: readonly Part[]): number[] {
  let sum = 0;
  return parts.map((part) => {
    const start = sum;
    sum += verticesOf(part);
    return start;
  });
}

export const drawnFaces = ({ isDrawn }: Part): number[] =>
  Array.from(isDrawn.keys()).filter((face) => isDrawn[face]);

/** The parts lie side by side along x, so that none is joined to another. */
export function joined(parts: readonly Part[]): Joined {
  const starts = startsOf(parts);
  const count = parts.reduce((sum, part) => sum + verticesOf(part), 0);
  const positions = new Float64Array(3 * count);
  const step = parts.length > 1 ? stepOf(parts) : 0;
  const indices: number[] = [];
  const materials: number[] = [];
  for (const [i, part] of parts.entries()) {
    const start = starts[i] as number;
    positions.set(part.positions, 3 * start);
    for (let v = 0; v < verticesOf(part); ++v) {
      const at = 3 * (start + v);
      positions[at] = (positions[at] as number) + i * step;
    }
    for (const face of drawnFaces(part)) {
      for (const vertex of part.indices.subarray(3 * face, 3 * face + 3))
        indices.push(start + vertex);
      materials.push(part.materials?.[face] ?? 0);
    }
  }
  return {
    positions,
    indices: Uint32Array.from(indices),
    ...(parts.some((part) => part.materials) && { materials: Uint32Array.from(materials) }),
    ...(parts.some((part) => part.normals) && { normals: normalsOf(parts, starts, count) }),
  };
}

/** A power of two leaves most digits of the coordinates as they are. */
function stepOf(parts: readonly Part[]): number {
  let size = 2 ** -126;
  for (const { positions } of parts) for (const x of positions) size = Math.max(size, Math.abs(x));
  return 4 * 2 ** Math.ceil(Math.log2(size));
}

function normalsOf(parts: readonly Part[], starts: number[], count: number): Float64Array {
  const normals = new Float64Array(3 * count);
  for (const [i, part] of parts.entries())
    if (part.normals) normals.set(part.normals, 3 * (starts[i] as number));
  return normals;
}
