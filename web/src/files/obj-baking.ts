// What the archive and the GLB of a baked OBJ have in common.

import type { Document } from '@gltf-transform/core';
import type { Abflat } from 'abflat';
import { bakeLayout, documentMesh } from 'abflat/gltf';
import type { BakeSettings } from '../model/bake-settings';
import type { BakedGltf } from './baked-gltf';
import type { ObjShape } from './obj-document';

export type Bake = Pick<Abflat, 'bake'>;
export type Tell = (fraction: number) => void;

interface Baked {
  document: Document;
  images: BakedGltf['images'];
  notes: string[];
  /** Of the first new image. */
  bytes: Uint8Array | undefined;
}

export async function bake(
  abflat: Bake,
  document: Document,
  { layout }: ObjShape,
  { side, ...atlas }: BakeSettings,
  onProgress: Tell,
): Promise<Baked> {
  const options = { ...atlas, bakeResolution: side, onProgress };
  const { baked, notes } = await bakeLayout(abflat, documentMesh(document), layout, options);
  const images = baked.map(({ maps, side }) => ({ maps, side }));
  return { document, images, notes, bytes: baked[0]?.texture.getImage() ?? undefined };
}

export async function bytesOf(images: Blob[]): Promise<Map<Blob, Uint8Array<ArrayBuffer>>> {
  const read = [...new Set(images)].map(
    async (image) => [image, new Uint8Array(await image.arrayBuffer())] as const,
  );
  return new Map(await Promise.all(read));
}

export function textureOf(
  document: Document,
  image: Blob,
  bytes: Map<Blob, Uint8Array<ArrayBuffer>>,
) {
  const content = bytes.get(image) as Uint8Array<ArrayBuffer>;
  const known = document
    .getRoot()
    .listTextures()
    .find((each) => each.getImage() === content);
  if (known) return known;
  const type = image.type || 'image/png';
  return document.createTexture().setImage(content).setMimeType(type);
}
