// Meshes and their graphs, for the modules that edit seams.

import { loadModule as load } from './modules.mjs';

/**
 * A grid of n x n squares in the plane, each two triangles of one face; `squeeze` maps x to move
 * columns closer together.
 */
export function plane(n, squeeze = (x) => x) {
  const positions = [];
  for (let y = 0; y <= n; ++y) for (let x = 0; x <= n; ++x) positions.push(squeeze(x), y, 0);
  const indices = [];
  const faces = [];
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      const [a, b] = [y * (n + 1) + x, (y + 1) * (n + 1) + x];
      indices.push(a, a + 1, b + 1, a, b + 1, b);
      faces.push(y * n + x, y * n + x);
    }
  return {
    positions: Float64Array.from(positions),
    indices: Uint32Array.from(indices),
    faces: Uint32Array.from(faces),
  };
}

export const identity = ({ positions }) =>
  Uint32Array.from({ length: positions.length / 3 }, (_, v) => v);

/** `faces`: null if each triangle is a face. */
export async function graphOf(mesh, faces = mesh.faces ?? null, places = identity(mesh)) {
  const { surfaceGraph } = await load('surface/surface-graph');
  return surfaceGraph(mesh, places, faces ?? undefined);
}
