import type { Abflat, MeshSummary } from 'abflat';
import type { ArrayMesh } from './mesh';

/**
 * The mesh with its vertices joined if that makes it a disk: some files repeat vertices where
 * normals change. `summary` describes the result. `weld` joins vertices at the same point.
 */
export async function asDisk(
  abflat: Abflat,
  mesh: ArrayMesh,
  signal: AbortSignal,
  weld: (mesh: ArrayMesh) => Promise<ArrayMesh>,
): Promise<{ mesh: ArrayMesh; summary: MeshSummary }> {
  const summary = await abflat.inspect(mesh, { signal });
  if (summary.disk.ok) return { mesh, summary };
  const joined = await weld(mesh);
  const found = await abflat.inspect(joined, { signal });
  if (found.disk.ok) return { mesh: joined, summary: found };
  return { mesh, summary: { ...summary, disk: found.disk } };
}
