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

/** Where checker cells lie in uv: `origin` + `cell` times their number. */
export interface Cells {
  origin: [number, number];
  cell: number;
}

/** The cell suits the typical place of the surface, not the most stretched one. */
export function checkerCells(mesh: FlatMesh): Cells {
  const { min, max } = boundingBox(mesh.positions, 3, mesh.indices);
  const diagonal = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const cell = (meanScale(mesh) * diagonal) / CELLS || 1;
  const [u, v] = boundingBox(mesh.uv, 2, mesh.indices).min;
  return { origin: [u, v], cell };
}

/** 2 per vertex. */
export const inCells = (uv: Float64Array, { origin, cell }: Cells): Float32Array =>
  Float32Array.from(uv, (x, i) => (x - origin[i % 2]) / cell);
