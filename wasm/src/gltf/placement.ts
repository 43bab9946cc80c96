// Where the nodes of a document put its meshes.

import type { Document, Mesh, mat4 } from '@gltf-transform/core';

export interface Placement {
  /** Column-major; undefined if vertices stay where they are. */
  matrix?: mat4;
  /** Corners run clockwise when seen from outside. */
  isMirrored: boolean;
}

const AS_IT_IS: Placement = { isMirrored: false };

/**
 * The place of each mesh: where the first node with a matrix that does not flatten it puts it. A
 * skinned mesh is where its vertices are. All instances share one layout, so there is no second
 * place.
 */
export function placements(document: Document): (mesh: Mesh) => Placement {
  const found = new Map<Mesh, Placement>();
  for (const node of document.getRoot().listNodes()) {
    const mesh = node.getMesh();
    if (!mesh || found.has(mesh)) continue;
    if (node.getSkin()) {
      found.set(mesh, AS_IT_IS);
      continue;
    }
    const matrix = node.getWorldMatrix();
    const volume = determinant(matrix);
    if (volume !== 0 && Number.isFinite(volume))
      found.set(mesh, { matrix, isMirrored: volume < 0 });
  }
  return (mesh) => found.get(mesh) ?? AS_IT_IS;
}

function determinant(m: mat4): number {
  return (
    m[0] * (m[5] * m[10] - m[6] * m[9]) -
    m[4] * (m[1] * m[10] - m[2] * m[9]) +
    m[8] * (m[1] * m[6] - m[2] * m[5])
  );
}

/** Writes the point to where it is placed. */
export function put(
  [x = 0, y = 0, z = 0]: number[],
  m: mat4 | undefined,
  to: Float64Array,
  at: number,
) {
  for (let d = 0; d < 3; ++d)
    to[at + d] = m
      ? (m[d] as number) * x +
        (m[4 + d] as number) * y +
        (m[8 + d] as number) * z +
        (m[12 + d] as number)
      : ([x, y, z][d] as number);
}
