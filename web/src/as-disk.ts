import type { Abflat, MeshSummary } from 'abflat';
import type { ArrayMesh } from './mesh';
import { weld } from './weld';

/**
 * The mesh with its vertices joined where that makes it a disk: some files repeat vertices where normals change. `summary` tells what it
 * is then.
 */
export async function asDisk(
  abflat: Abflat,
  mesh: ArrayMesh,
  signal: AbortSignal,
): Promise<{ mesh: ArrayMesh; summary: MeshSummary }> {
  const summary = await abflat.inspect(mesh, { signal });
  if (summary.disk.ok) return { mesh, summary };
  const first = weld(mesh.positions, 3);
  const indices = mesh.indices.map((vertex) => first[vertex]);
  // A joined vertex had several texcoords.
  const joined = { ...mesh, indices, texcoords: undefined };
  const found = await abflat.inspect(joined, { signal });
  if (found.disk.ok) return { mesh: joined, summary: found };
  return { mesh, summary: { ...summary, disk: found.disk } };
}
