import { areasOf, boundingBox, type FlatMesh, type TriangleAreas, usedVertices } from './mesh';

/**
 * Checker cells along the diagonal of the mesh's box, if the layout neither shrinks nor enlarges
 * it.
 */
const CELLS = 36;

/** Length in uv over length in 3D: the geometric mean over the surface. */
function meanScale({ in3d, inUv }: TriangleAreas): number {
  let sum = 0;
  let total = 0;
  for (let f = 0; f < in3d.length; ++f) {
    const change = Math.log(inUv[f] / in3d[f]) / 2;
    if (!Number.isFinite(change)) continue;
    sum += in3d[f] * change;
    total += in3d[f];
  }
  return total > 0 ? Math.exp(sum / total) : 1;
}

/** Where checker cells lie in uv: `origin` + `cell` times their number. */
export interface Cells {
  origin: [number, number];
  cell: number;
}

/** The cell suits the typical place of the surface, not the most stretched one. */
export function checkerCells(mesh: FlatMesh, areas = areasOf(mesh)): Cells {
  const used = usedVertices(mesh.uv.length / 2, mesh.indices);
  const { min, max } = boundingBox(mesh.positions, 3, used);
  const diagonal = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const cell = (meanScale(areas) * diagonal) / CELLS || 1;
  const [u, v] = boundingBox(mesh.uv, 2, used).min;
  return { origin: [u, v], cell };
}

/** 2 per vertex. */
export function inCells(uv: Float64Array, { origin, cell }: Cells): Float32Array {
  const places = new Float32Array(uv.length);
  for (let i = 0; i < uv.length; ++i) places[i] = (uv[i] - origin[i % 2]) / cell;
  return places;
}
