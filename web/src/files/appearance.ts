// Reads how a file looks, besides its shape.

import type { DisplayMesh } from '../mesh/mesh';
import type { AppearanceRead, MaterialLook } from '../model/appearance';
import { type GltfFiles, isGltf } from '../model/model';
import { type CornerWriter, WHITE } from './corner-looks';
import { readGltfLook } from './gltf-look';
import { decodeImages, type StoredImage } from './look-images';
import { remarksOn } from './missing-files';
import { readObjLook } from './obj-look';
import { readPlyLook } from './ply-look';

export interface LookSource {
  file: File;
  others: File[];
  /** The copy of a glTF, in place of them. */
  gltf?: GltfFiles;
  /** Bytes that decoded images may take. */
  memory: number;
}

/** A mesh as it was opened. */
export type LookMesh = Pick<DisplayMesh, 'indices' | 'faces'>;

/** How a file looks, with images as they are stored. */
export interface StoredLook {
  corners: CornerWriter;
  /** Their images are numbers in `images`. */
  materials: MaterialLook[];
  images: StoredImage[];
  /** Names of files that are not there. */
  missing: string[];
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
  if (isGltf({ kind: 'sample', name: file.name })) return null;
  if (/\.ply$/i.test(file.name)) return readPlyLook(file, mesh);
  return /\.obj$/i.test(file.name) ? readObjLook(file, others, mesh) : null;
}
