import { loadPart } from '../base/load-part';
import type { Unwrapped } from '../model/model';
import type { Workshop } from '../workshop/workshop';

export type PartKind = 'material' | 'group';

/**
 * The number of each triangle's material, or of its object or group, by the file; null if the file
 * has none of the kind. Without named groups, those are connected parts.
 */
export async function partsOfFile(
  { source, mesh, gltf }: Unwrapped,
  kind: PartKind,
  workshop: Pick<Workshop, 'connectedParts'>,
): Promise<ArrayLike<number> | null> {
  const named = await partsOfObj({ source, mesh }, kind);
  if (named) return named;
  if (kind === 'group') return workshop.connectedParts(mesh);
  const { materials } = gltf?.mesh ?? {};
  return materials && new Set(materials).size > 1 ? materials : null;
}

async function partsOfObj(
  { source, mesh }: Pick<Unwrapped, 'source' | 'mesh'>,
  kind: PartKind,
): Promise<ArrayLike<number> | null> {
  if (source.kind !== 'file' || !/\.obj$/i.test(source.file.name)) return null;
  const { objParts } = await loadPart(import('../files/obj-parts'));
  const parts = await objParts(await source.file.text());
  if ((kind === 'material' ? parts.materials : parts.groups) === 0) return null;
  const { faces, indices } = mesh;
  return Uint32Array.from({ length: indices.length / 3 }, (_, f) => parts[kind][faces?.[f] ?? f]);
}
