import { boundingBox, type FlatMesh, triangleAreas } from './mesh';

/**
 * Checker cells along the diagonal of the mesh's box, if the layout neither shrinks nor enlarges
 * it.
 */
const CELLS = 36;

/** Length in uv over length in 3D: the geometric mean over the surface. */
function meanScale({ positions, indices, uv }: FlatMesh): number {
  let sum = 0;
  let total = 0;
  const inUv = triangleAreas(uv, 2, indices);
  triangleAreas(positions, 3, indices).forEach((area, f) => {
    const change = Math.log(inUv[f] / area) / 2;
    if (!Number.isFinite(change)) return;
    sum += area * change;
    total += area;
  });
  return total > 0 ? Math.exp(sum / total) : 1;
}

/**
 * uv in checker cells, 2 per vertex. The cell size suits typical parts of the surface rather than
 * the most stretched one.
 */
export function checkerCells(mesh: FlatMesh): Float32Array {
  const { min, max } = boundingBox(mesh.positions, 3, mesh.indices);
  const diagonal = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const cell = (meanScale(mesh) * diagonal) / CELLS || 1;
  const origin = boundingBox(mesh.uv, 2, mesh.indices).min;
  return Float32Array.from(mesh.uv, (x, i) => (x - origin[i % 2]) / cell);
}
