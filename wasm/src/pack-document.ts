// Packs the layout of glTF-Transform documents.

import type { Document, Transform } from '@gltf-transform/core';
import { AbflatError } from './base/errors.js';
import type { WrittenFormat } from './base/generated.js';
import type { BakeDocumentOptions, LaidAtlas } from './gltf/bake/bake-document.js';
import type { BakedTexture } from './gltf/bake/put-look.js';
import { bakingOf, firstPart, lastPart } from './gltf/baking.js';
import { type DocumentMesh, documentMesh, membersOf } from './gltf/document-mesh.js';
import { checkGroupBy, checkSets, type GroupBy, grouped, layEach } from './gltf/groups.js';
import { setTexcoords } from './gltf/texcoords.js';
import { freeBakedTexcoord, freeTexcoord } from './gltf/texture-sets.js';
import { checkAbflat, checkFunction, optionsOf } from './messages/validate.js';
import type { AnyAbflat, PackOptions, PackResult } from './types/index.js';

export interface PackedDocumentAtlas extends Pick<DocumentMesh, 'parts'> {
  result: PackResult;
  /** The set that holds the coordinates. */
  texcoord: number;
  /** The new images, with `bake`. */
  baked?: BakedTexture[];
}

/** The options of `pack`, which apply to every atlas, and these. */
export interface PackDocumentOptions
  extends Omit<PackOptions, 'transfer' | WrittenFormat | 'roundsForGltf'> {
  /** The layout to pack is TEXCOORD_`readTexcoord`. Primitives without it stay as they are. Default: 0. */
  readTexcoord?: number;
  /**
   * The new coordinates become TEXCOORD_`texcoord`. `auto`: the result of `freeTexcoord`, which is
   * 0 if no texture samples that set, otherwise the first unused set. Default: `readTexcoord`, but
   * `auto` if that is 0, since textures fit only the layout that they were made for.
   */
  texcoord?: number | 'auto';
  /** Default: `scene`, one atlas for all. */
  groupBy?: GroupBy;
  /** As in UnwrapDocumentOptions. Default: false. */
  bake?: boolean | BakeDocumentOptions;
  /** Called for each atlas once the document has it. */
  onAtlas?: (atlas: PackedDocumentAtlas) => void;
}

/**
 * A transform that packs the layout of a document: `await document.transform(pack(abflat))`. If it
 * fails, the document stays as it was.
 */
export function pack(
  abflat: AnyAbflat<'pack'> & Partial<AnyAbflat<'bake'>>,
  options: PackDocumentOptions = {},
): Transform {
  const own = optionsOf(options);
  const {
    readTexcoord = 0,
    texcoord = readTexcoord === 0 ? 'auto' : readTexcoord,
    groupBy = 'scene',
    bake = false,
    onAtlas,
    ...settings
  } = own;
  checkAbflat(abflat, 'pack');
  checkSets(texcoord, readTexcoord);
  checkGroupBy(groupBy);
  checkFunction('onAtlas', onAtlas);
  checkFunction('onProgress', own.onProgress);
  const baking = bakingOf(abflat, bake, own.udim);
  const transform = async (document: Document): Promise<void> => {
    const free = baking ? freeBakedTexcoord : freeTexcoord;
    const set = texcoord === 'auto' ? free(document) : texcoord;
    const packed = await layEach(
      meshesOf(document, readTexcoord, groupBy),
      baking ? firstPart(own.onProgress) : own.onProgress,
      async ({ positions, indices, texcoords, materials, notes }, call) => {
        const mesh = { positions, indices, materials, ...(texcoords && { texcoords }) };
        const result = await abflat.pack(mesh, { ...settings, ...call });
        result.report.notes.unshift(...notes);
        return result;
      },
    );
    const looks = await baking?.prepare(document, packed.map(laidOf), {
      signal: own.signal,
      onProgress: lastPart(own.onProgress),
    });
    const done = packed.map(({ parts, result }, i): PackedDocumentAtlas => {
      setTexcoords({ document, parts }, result, { texcoord: set });
      return { parts, result, texcoord: set, ...(looks && { baked: looks[i]?.(set) }) };
    });
    for (const atlas of done) await onAtlas?.(atlas);
  };
  return Object.defineProperty(transform, 'name', { value: 'pack' });
}

function laidOf({ parts, result }: Pick<PackedDocumentAtlas, 'parts' | 'result'>): LaidAtlas {
  const { padding, width, height } = result.report;
  const resolution = [width, height] as const;
  return { parts, result, padding, resolution };
}

/** Those with a layout, a mesh for each atlas. */
function meshesOf(document: Document, set: number, groupBy: GroupBy): DocumentMesh[] {
  const members = membersOf(document).filter(({ primitive }) =>
    primitive.getAttribute(`TEXCOORD_${set}`),
  );
  const meshes = grouped(members, groupBy)
    .map((group) => documentMesh(document, group, set))
    .filter(({ indices }) => indices.length > 0);
  if (meshes.length > 0) return meshes;
  throw new AbflatError(
    'NoTexcoords',
    `No triangle has TEXCOORD_${set}, so there is no layout to pack. Make one with unwrap.`,
  );
}
