// Unwraps glTF-Transform documents.

import type { Document, Mesh, Transform } from '@gltf-transform/core';
import { AbflatError } from './base/errors.js';
import type { WrittenFormat } from './base/generated.js';
import type { BakeDocumentOptions, LaidAtlas } from './gltf/bake/bake-document.js';
import type { BakedTexture } from './gltf/bake/put-look.js';
import { bakingOf, firstPart, lastPart } from './gltf/baking.js';
import {
  type DocumentMesh,
  type DocumentPart,
  documentMesh,
  type Member,
  membersOf,
} from './gltf/document-mesh.js';
import {
  checkGroupBy,
  checkSets,
  type GroupBy,
  grouped,
  layEach,
  sizedMeshes,
} from './gltf/groups.js';
import { MeshWeights } from './gltf/mesh-weights.js';
import { giveOwnMeshes } from './gltf/own-meshes.js';
import { setTexcoords } from './gltf/texcoords.js';
import { freeBakedTexcoord, freeTexcoord } from './gltf/texture-sets.js';
import { neededFor } from './messages/needed-arrays.js';
import { checkAbflat, checkBoolean, checkFunction, optionsOf } from './messages/validate.js';
import { checkWeights, type Weights } from './messages/weights.js';
import { checkPages, layPages, pagesNote, type Sized } from './pages.js';
import { type PresetOptions, withPreset } from './preset.js';
import type { AnyAbflat, UnwrapOptions, UnwrapResult } from './types/index.js';

export { type BakedLayout, type BakeLayoutOptions, bakeLayout } from './bake-layout.js';
export { type BakeSetOptions, bake } from './bake-set.js';
export type { BakeDocumentOptions } from './gltf/bake/bake-document.js';
export type { DecodeImage, EncodeImage } from './gltf/bake/codecs.js';
export type { ImageFile } from './gltf/bake/image-file.js';
export type { MapName } from './gltf/bake/material-look.js';
export type { BakedTexture } from './gltf/bake/put-look.js';
export {
  type DocumentMesh,
  type DocumentPart,
  documentMesh,
} from './gltf/document-mesh.js';
export type { GroupBy } from './gltf/groups.js';
export { type SetTexcoordsOptions, setTexcoords } from './gltf/texcoords.js';
export { freeTexcoord, sampledTexcoords } from './gltf/texture-sets.js';
export type { Weights } from './messages/weights.js';
export { type PackDocumentOptions, type PackedDocumentAtlas, pack } from './pack-document.js';
export type { Preset, PresetOptions } from './preset.js';
export {
  type VerifiedAtlas,
  type VerifyDocumentOptions,
  verifyDocument,
} from './verify-document.js';

export interface DocumentAtlas extends Pick<DocumentMesh, 'parts'> {
  result: UnwrapResult;
  /** The set that holds the coordinates. */
  texcoord: number;
  /** Its number from 0, with `pages`. */
  page?: number;
  /** The new images, with `bake`. */
  baked?: BakedTexture[];
}

/** The options of `unwrap`, which apply to every atlas, and these. */
export interface UnwrapDocumentOptions
  extends PresetOptions,
    Omit<UnwrapOptions, 'transfer' | WrittenFormat | 'seamEdges' | 'roundsForGltf'> {
  /**
   * The new coordinates become TEXCOORD_`texcoord`. `auto`: the result of `freeTexcoord`, which is
   * 0 if no texture samples that set, otherwise the first unused set. Default: 0, 1 with a preset,
   * and `readTexcoord` with `fixedFaces: 'uv'`.
   */
  texcoord?: number | 'auto';
  /** `seams: 'uv'` and `fixedFaces: 'uv'` refer to TEXCOORD_`readTexcoord`. Default: 0. */
  readTexcoord?: number;
  /**
   * Whether to replace that set in primitives that already have it; otherwise they stay as they
   * are. Default: false, and true with `texcoord: 'auto'` or `fixedFaces`.
   */
  overwrite?: boolean;
  /**
   * Default: `mesh`, one atlas for each mesh, as in glTF-Transform; `scene` with
   * `ownTexels`, `pages`, and with `fixedFaces`, as meshes may share the atlas that they have.
   */
  groupBy?: GroupBy;
  /**
   * So many atlases of equal size, at one texel density, with `groupBy: 'scene'`. Each mesh lies on
   * one of them as a whole, and pages are filled about alike. Default: 1.
   */
  pages?: number;
  /**
   * Nodes of the scene that share a mesh each get a copy of it, with coordinates of its own, as
   * lightmaps need. Default: false, they share its texels, and true with a preset.
   */
  ownTexels?: boolean;
  /**
   * Texel densities of meshes relative to the others of their atlas, from 0.001 to 1000, as a Map or
   * a function; 1 where there is none. 0 leaves a mesh as it is. Copies have that of their mesh.
   */
  weights?: Weights<Mesh>;
  /**
   * Have textures follow the new layout: materials get new images, with what to know about them in
   * an object. `texcoord` is then `auto` by default, for which baked textures do not count.
   * Default: false.
   */
  bake?: boolean | BakeDocumentOptions;
  /** Called for each atlas once the document has it. */
  onAtlas?: (atlas: DocumentAtlas) => void;
}

/**
 * A transform that gives a document an atlas: `await document.transform(unwrap(abflat, { texcoord:
 * 1 }))`. If it fails, the document stays as it was.
 */
export function unwrap(
  abflat: AnyAbflat<'unwrap'> & Partial<AnyAbflat<'bake'>>,
  options: UnwrapDocumentOptions = {},
): Transform {
  const own = optionsOf(options);
  const {
    readTexcoord = 0,
    bake = false,
    texcoord = usualTexcoord(own, readTexcoord),
    overwrite = texcoord === 'auto' || own.fixedFaces !== undefined,
    ownTexels = own.preset !== undefined,
    pages,
    groupBy = ownTexels || pages !== undefined || own.fixedFaces !== undefined ? 'scene' : 'mesh',
    onAtlas,
    weights,
    ...others
  } = own;
  checkAbflat(abflat, 'unwrap');
  check({ texcoord, readTexcoord, overwrite, groupBy, ownTexels, onAtlas, weights, pages });
  const settings = withPreset(others);
  checkPages(pages, settings);
  checkFunction('onProgress', own.onProgress);
  const baking = bakingOf(abflat, bake, own.udim);
  const transform = async (document: Document): Promise<void> => {
    const free = baking ? freeBakedTexcoord : freeTexcoord;
    const set = texcoord === 'auto' ? free(document) : texcoord;
    const weighed = new MeshWeights(document, weights);
    const all = membersOf(document).filter((member) => weighed.takesPart(member));
    const isWanted = ({ primitive }: Member) =>
      overwrite || !primitive.getAttribute(`TEXCOORD_${set}`);
    const wanted = all.filter(isWanted);
    if (wanted.length < all.length) tellKept(document, set, all.length - wanted.length, all.length);
    const shared = ownTexels ? new Set(wanted.map(({ mesh }) => mesh)) : new Set<Mesh>();
    const copies = giveOwnMeshes(document, shared);
    const members = ownTexels
      ? membersOf(document).filter((each) => isWanted(each) && weighed.takesPart(each, copies))
      : wanted;
    const lay = async () => {
      const meshOf = (group: Member[]) => documentMesh(document, group, readTexcoord);
      const onLaid = baking ? firstPart(own.onProgress) : own.onProgress;
      const optionsOfMesh = ({ parts }: DocumentMesh): UnwrapOptions => ({
        ...settings,
        ...weighed.options(parts, copies),
        onProgress: onLaid,
      });
      const sizeOf = (part: DocumentPart, area: number) => weighed.size(part, area, copies);
      const atlases =
        pages === undefined
          ? await unwrapGroups(abflat, grouped(members, groupBy).map(meshOf), optionsOfMesh)
          : await unwrapPages(
              abflat,
              sizedMeshes(meshOf(members), sizeOf),
              (meshes) => meshOf(members.filter(({ mesh }) => meshes.includes(mesh))),
              optionsOfMesh,
              { pages, texelDensity: own.texelDensity, onProgress: onLaid },
            );
      const looks = await baking?.prepare(document, atlases.map(laidOf), {
        signal: own.signal,
        onProgress: lastPart(own.onProgress),
      });
      return atlases.map((atlas, i) => ({ atlas, look: looks?.[i] }));
    };
    const unwrapped = await lay().catch((error) => {
      copies.takeBack();
      throw error;
    });
    const done = unwrapped.map(({ atlas, look }, page): DocumentAtlas => {
      const { parts, result } = atlas;
      const { turnedFaces } = result.report.repair;
      setTexcoords({ document, parts }, result, { texcoord: set, turnedFaces });
      return {
        ...atlas,
        texcoord: set,
        ...(pages !== undefined && { page }),
        ...(look && { baked: look(set) }),
      };
    });
    for (const atlas of done) await onAtlas?.(atlas);
  };
  return Object.defineProperty(transform, 'name', { value: 'unwrap' });
}

/** Textures stay correct unless the caller says otherwise. */
function usualTexcoord(options: UnwrapDocumentOptions, readTexcoord: number) {
  const { fixedFaces, bake, preset } = options;
  if (fixedFaces === 'uv') return readTexcoord;
  if (bake) return 'auto';
  return preset === undefined ? 0 : 1;
}

function laidOf({ parts, result }: Pick<DocumentAtlas, 'parts' | 'result'>): LaidAtlas {
  const { repair, atlas } = result.report;
  const { padding, width, height } = atlas;
  const resolution = [width, height] as const;
  return { parts, result, turnedFaces: repair.turnedFaces, padding, resolution };
}

/** An unchanged document may surprise a caller who asked for an atlas. */
function tellKept(document: Document, set: number, kept: number, count: number): void {
  const message =
    `abflat: ${kept} of ${count} primitives already have TEXCOORD_${set} and keep it. ` +
    `Pass texcoord: 'auto' to add a set, or overwrite: true to replace it.`;
  const logger = document.getLogger();
  if (kept === count) logger.warn(message);
  else logger.info(message);
}

function check(options: UnwrapDocumentOptions): void {
  const { texcoord, readTexcoord, overwrite, groupBy, ownTexels, onAtlas, weights } = options;
  const { pages } = options;
  checkSets(texcoord, readTexcoord);
  checkBoolean('overwrite', overwrite);
  checkBoolean('ownTexels', ownTexels);
  checkFunction('onAtlas', onAtlas);
  checkGroupBy(groupBy);
  checkWeights(weights);
  if (pages !== undefined && groupBy !== 'scene')
    throw new AbflatError(
      'InvalidOption',
      `pages are those of a whole scene, so groupBy must be 'scene', not '${groupBy}'.`,
    );
}

async function unwrapGroups(
  abflat: AnyAbflat<'unwrap'>,
  all: DocumentMesh[],
  optionsOfMesh: (mesh: DocumentMesh) => UnwrapOptions,
): Promise<Omit<DocumentAtlas, 'texcoord'>[]> {
  const meshes = all.filter(({ indices }) => indices.length > 0);
  const options = meshes.map(optionsOfMesh);
  return layEach(meshes, options[0]?.onProgress, async (mesh, call, i) => {
    const own = options[i] as UnwrapOptions;
    const result = await abflat.unwrap(neededFor(own, mesh), { ...own, ...call });
    result.report.notes.unshift(...notesOf(mesh));
    return result;
  });
}

/** The only ones it has are about nodes that share texels. */
const notesOf = ({ notes }: DocumentMesh) =>
  notes.map((note) => `${note}. With the option ownTexels each node gets texels of its own`);

async function unwrapPages(
  abflat: AnyAbflat<'unwrap'>,
  things: Sized<Mesh>[],
  meshOf: (meshes: Mesh[]) => DocumentMesh,
  optionsOfMesh: (mesh: DocumentMesh) => UnwrapOptions,
  { pages, ...common }: Pick<UnwrapOptions, 'texelDensity' | 'onProgress'> & { pages: number },
): Promise<Omit<DocumentAtlas, 'texcoord'>[]> {
  if (things.length === 0) return [];
  const partsOf = new Map<UnwrapResult, DocumentMesh['parts']>();
  const results = await layPages(things, pages, common, async (meshes, more) => {
    const mesh = meshOf(meshes);
    const all = { ...optionsOfMesh(mesh), ...more, transfer: true, roundsForGltf: true };
    const result = await abflat.unwrap(neededFor(all, mesh), all);
    result.report.notes.unshift(...notesOf(mesh));
    partsOf.set(result, mesh.parts);
    return result;
  });
  results[0]?.report.notes.unshift(...pagesNote(pages, results.length, 'meshes'));
  return results.map((result) => ({
    parts: partsOf.get(result) as DocumentMesh['parts'],
    result,
  }));
}
