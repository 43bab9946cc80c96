// Bakes the atlases of a document.

import type { Document } from '@gltf-transform/core';
import { AbflatError } from '../../base/errors.js';
import type { UnwrapOptionValues } from '../../base/generated.js';
import type { AnyAbflat, BakeOptions, Layout } from '../../types/index.js';
import type { DocumentPart } from '../document-mesh.js';
import { keptTexcoords } from '../texture-sets.js';
import { bakeAtlas, type NewLook } from './bake-atlas.js';
import { type DecodeImage, type EncodeImage, usualEncode } from './codecs.js';
import { atlasCorners } from './corners.js';
import { OldImages } from './old-images.js';
import { type BakedTexture, putLook } from './put-look.js';

/** A layout and what it was made of. */
export interface LaidAtlas {
  parts: DocumentPart[];
  result: Pick<Layout<{ notes: string[] }>, 'uv' | 'indices' | 'report'>;
  turnedFaces?: readonly number[];
  /** In texels, and the size of the image that they are of; undefined: of the new ones. */
  padding: number;
  resolution: UnwrapOptionValues['resolution'] | undefined;
}

export interface BakeDocumentOptions {
  /**
   * Size of the new images in texels; a number is the longer side of images in the shape of the
   * layout. Default: `auto`, for each map the power of two that is nearest to the texels of the old
   * images, or that of the layout if there are none.
   */
  bakeResolution?: BakeOptions['bakeResolution'];
  /**
   * Turns an image file into pixels of 8 bits, with colours that are not multiplied by alpha, or
   * returns null to leave it to the default: browsers do it; Node has nothing that could.
   */
  decode?: DecodeImage;
  /** Turns a new image into a file. Default: a PNG. */
  encode?: EncodeImage;
}

/** Gives an atlas its new look, once the document has the texcoords. */
export type PutLook = (texcoord: number) => BakedTexture[];

interface Settings extends BakeDocumentOptions, Pick<BakeOptions, 'signal'> {
  onProgress?: (fraction: number) => void;
}

/** Returns what puts the looks into the document, one for each atlas. */
export async function bakeDocument(
  abflat: AnyAbflat<'bake'>,
  document: Document,
  atlases: readonly LaidAtlas[],
  settings: Settings,
): Promise<PutLook[]> {
  const { bakeResolution = 'auto', decode, encode = usualEncode } = settings;
  const { signal, onProgress } = settings;
  const oldImages = new OldImages(decode);
  const looks: PutLook[] = [];
  for (const [i, { parts, result, turnedFaces, padding, resolution }] of atlases.entries()) {
    const corners = atlasCorners(parts, result, turnedFaces ?? []);
    const look = await bakeAtlas(abflat, corners, {
      oldImages,
      encode,
      bakeResolution,
      padding,
      layoutResolution: resolution ?? 'none',
      signal,
      onProgress: onProgress && ((fraction: number) => onProgress((i + fraction) / atlases.length)),
    });
    onProgress?.((i + 1) / atlases.length);
    checkWebp(document, look);
    looks.push((texcoord) => {
      const primitives = parts.map(({ primitive }) => primitive);
      const isMoved = texcoord > 0 && keptTexcoords(primitives).includes(0);
      result.report.notes.push(...notesOf(parts, look, isMoved ? texcoord : 0));
      result.report.notes.push(...depthNotes(oldImages.deepCount));
      return putLook(document, primitives, look, texcoord);
    });
  }
  return looks;
}

const WEBP = 'EXT_texture_webp';

/** The extension is not part of the core of glTF-Transform, so the caller must add it. */
function checkWebp(document: Document, { images }: NewLook): void {
  const extensions = document.getRoot().listExtensionsUsed();
  const isWebp = images.some(({ file }) => file.mimeType === 'image/webp');
  if (!isWebp || extensions.some(({ extensionName }) => extensionName === WEBP)) return;
  throw new AbflatError(
    'InvalidOption',
    `bake.encode returned a WebP, which needs document.createExtension(EXTTextureWebP).setRequired(true).`,
  );
}

function depthNotes(count: number): string[] {
  if (count === 0) return [];
  const images = count === 1 ? '1 image has' : `${count} images have`;
  return [`${images} 16 bits per channel, of which the new ones have 8`];
}

/** What to know about the new look, one sentence each. */
function notesOf(parts: DocumentPart[], { images }: NewLook, texcoord: number): string[] {
  if (images.length === 0)
    return ['nothing was baked: no material of the mesh has a texture, and no vertex has a colour'];
  const notes: string[] = [];
  if (texcoord > 0)
    notes.push(
      `a texture that is not baked uses TEXCOORD_0, so the new texcoords are TEXCOORD_${texcoord}`,
    );
  const count = parts.filter(({ primitive }) => primitive.getAttribute('TANGENT')).length;
  if (count > 0 && images.some(({ maps }) => maps.includes('normal')))
    notes.push(
      `the tangents of ${count} ${count === 1 ? 'primitive' : 'primitives'} were those of the old layout, so they were left out: ` +
        'programs compute those that the new normal map is made for',
    );
  return notes;
}
