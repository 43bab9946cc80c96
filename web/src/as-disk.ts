import type { Abflat, MeshSummary } from 'abflat';
import type { DisplayMesh } from './mesh';
import { weld } from './weld';

/**
 * The mesh with its vertices joined where that makes it a disk: some files repeat vertices where normals change. `disk` tells whether it
 * is one, and why not.
 */
export async function asDisk(
  abflat: Abflat,
  mesh: DisplayMesh,
  signal: AbortSignal,
): Promise<{ mesh: DisplayMesh; disk: MeshSummary['disk'] }> {
  const { disk } = await abflat.inspect(mesh, { signal });
  if (disk.ok) return { mesh, disk };
  const first = weld(mesh.positions, 3);
  const joined = { ...mesh, indices: mesh.indices.map((vertex) => first[vertex]) };
  const found = await abflat.inspect(joined, { signal });
  return { mesh: found.disk.ok ? joined : mesh, disk: found.disk };
}
