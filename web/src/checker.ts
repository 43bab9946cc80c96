import type { FlatMesh } from './mesh';
import { boundingBox } from './mesh';

/** Checker cells along the diagonal of the mesh's box, where the layout neither shrinks nor grows it. */
const CELLS = 36;

/** Twice the area of a triangle. */
function doubleArea(p: Float64Array, size: number, [i, j, k]: Uint32Array): number {
  const along = (v: number, d: number) => (d < size ? p[size * v + d] - p[size * i + d] : 0);
  const [ax, ay, az] = [along(j, 0), along(j, 1), along(j, 2)];
  const [bx, by, bz] = [along(k, 0), along(k, 1), along(k, 2)];
  return Math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx);
}

/** Length in uv over length in 3D: the geometric mean over the surface. */
function meanScale({ positions, indices, uv }: FlatMesh): number {
  let sum = 0;
  let total = 0;
  for (let c = 0; c < indices.length; c += 3) {
    const vertices = indices.subarray(c, c + 3);
    const area = doubleArea(positions, 3, vertices);
    const change = Math.log(doubleArea(uv, 2, vertices) / area) / 2;
    if (!Number.isFinite(change)) continue;
    sum += area * change;
    total += area;
  }
  return total > 0 ? Math.exp(sum / total) : 1;
}

/** uv in checker cells, 2 per vertex. The cell suits the typical place of the surface, not the most stretched one. */
export function checkerCells(mesh: FlatMesh): Float32Array {
  const { min, max } = boundingBox(mesh.positions, 3, mesh.indices);
  const diagonal = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
  const cell = (meanScale(mesh) * diagonal) / CELLS || 1;
  const origin = boundingBox(mesh.uv, 2, mesh.indices).min;
  return Float32Array.from(mesh.uv, (x, i) => (x - origin[i % 2]) / cell);
}
