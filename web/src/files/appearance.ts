// Reads how a file looks, besides its shape.

import { meshFileOf } from '../base/mesh-files';
import type { AppearanceRead } from '../model/appearance';
import type { GltfFiles } from '../model/model';
import { WHITE } from './corner-looks';
import { readGltfLook } from './gltf-look';
import { decodeImages } from './look-images';
import { remarksOn } from './missing-files';
import { readObjLook } from './obj-look';
import { readPlyLook } from './ply-look';
import type { LookMesh, StoredLook } from './stored-look';

export interface LookSource {
  file: File;
  others: File[];
  /** The copy of a glTF, in place of them. */
  gltf?: GltfFiles;
  /** Bytes that decoded images may take. */
  memory: number;
}

export async function readAppearance(source: LookSource, mesh: LookMesh): Promise<AppearanceRead> {
  const stored = await readLook(source, mesh);
  if (!stored) return { appearance: null, remarks: [] };
  const { corners, missing } = stored;
  const { images, numbers } = await decodeImages(stored.images, source.memory);
  const undecoded = stored.images.filter((_, i) => numbers[i] === null).map(({ name }) => name);
  const materials = stored.materials.map((material) => ({
    ...material,
    image: material.image === null ? null : numbers[material.image],
  }));
  const isVaried = images.length > 0 || corners.onlyTint === null;
  const hasLook = isVaried || corners.onlyTint !== WHITE;
  return {
    appearance: hasLook ? { corners: corners.words, materials, images, isVaried } : null,
    remarks: remarksOn(source.file.name, missing, undecoded),
  };
}

/** Null for formats that hold only a shape. */
async function readLook(
  { file, others, gltf }: LookSource,
  mesh: LookMesh,
): Promise<StoredLook | null> {
  if (gltf) return readGltfLook(gltf);
  const format = meshFileOf(file.name)?.format;
  if (format === 'ply') return readPlyLook(file, mesh);
  return format === 'obj' ? readObjLook(file, others, mesh) : null;
}
