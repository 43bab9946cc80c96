// Unwraps glTF-Transform documents.

import type { Document, Mesh, Primitive, Transform } from '@gltf-transform/core';
import { AbflatError } from './base/errors.js';
import type { WrittenFormat } from './base/generated.js';
import { type DocumentMesh, documentMesh, type Member, membersOf } from './gltf/document-mesh.js';
import { giveOwnMeshes } from './gltf/own-meshes.js';
import { setTexcoords } from './gltf/texcoords.js';
import { freeTexcoord } from './gltf/texture-sets.js';
import { ownFields } from './messages/fields.js';
import { neededFor } from './messages/needed-arrays.js';
import { checkAbflat, checkBoolean, checkFunction, optionsOf, shown } from './messages/validate.js';
import type { Abflat, UnwrapOptions, UnwrapProgress, UnwrapResult } from './types/index.js';

export {
  type DocumentMesh,
  type DocumentPart,
  documentMesh,
} from './gltf/document-mesh.js';
export { type SetTexcoordsOptions, setTexcoords } from './gltf/texcoords.js';
export { freeTexcoord, sampledTexcoords } from './gltf/texture-sets.js';

/**
 * What shares an atlas: everything, the primitives of a mesh, or nothing (one atlas per primitive).
 */
export type GroupBy = 'scene' | 'mesh' | 'primitive';

export interface DocumentAtlas extends Pick<DocumentMesh, 'parts'> {
  result: UnwrapResult;
  /** The set that holds the coordinates. */
  texcoord: number;
}

/** The options of `unwrap`, which apply to every atlas, and these. */
export interface UnwrapDocumentOptions
  extends Omit<UnwrapOptions, 'transfer' | WrittenFormat | 'seamEdges' | 'roundsForGltf'> {
  /**
   * The new coordinates become TEXCOORD_`texcoord`. `auto`: the result of `freeTexcoord`, which is
   * 0 if no texture samples that set, otherwise the first unused set. Default: 0, and
   * `readTexcoord` with `fixedFaces: 'uv'`.
   */
  texcoord?: number | 'auto';
  /** `seams: 'uv'` and `fixedFaces: 'uv'` refer to TEXCOORD_`readTexcoord`. Default: 0. */
  readTexcoord?: number;
  /**
   * Whether to replace that set in primitives that already have it; otherwise they stay as they
   * are. Default: false, and true with `texcoord: 'auto'` or `fixedFaces`.
   */
  overwrite?: boolean;
  /** Default: `scene`, one atlas for all. */
  groupBy?: GroupBy;
  /**
   * Nodes of the scene that share a mesh each get a copy of it, with coordinates of its own, as
   * lightmaps need. Default: false, they share its texels.
   */
  ownTexels?: boolean;
  /** Called for each atlas once the document has it. */
  onAtlas?: (atlas: DocumentAtlas) => void;
}

/**
 * A transform that gives a document an atlas: `await document.transform(unwrap(abflat, { texcoord:
 * 1 }))`. If it fails, the document stays as it was.
 */
export function unwrap(
  abflat: Pick<Abflat, 'unwrap'>,
  options: UnwrapDocumentOptions = {},
): Transform {
  const own = optionsOf(options);
  const {
    readTexcoord = 0,
    texcoord = own.fixedFaces === 'uv' ? readTexcoord : 0,
    overwrite = texcoord === 'auto' || own.fixedFaces !== undefined,
    groupBy = 'scene',
    ownTexels = false,
    onAtlas,
    ...settings
  } = own;
  checkAbflat(abflat);
  check({ texcoord, readTexcoord, overwrite, groupBy, ownTexels, onAtlas });
  checkFunction('onProgress', own.onProgress);
  const transform = async (document: Document): Promise<void> => {
    const set = texcoord === 'auto' ? freeTexcoord(document) : texcoord;
    const all = membersOf(document);
    const isWanted = ({ primitive }: Member) =>
      overwrite || !primitive.getAttribute(`TEXCOORD_${set}`);
    const wanted = all.filter(isWanted);
    if (wanted.length < all.length) tellKept(document, set, all.length - wanted.length, all.length);
    const shared = ownTexels ? new Set(wanted.map(({ mesh }) => mesh)) : new Set<Mesh>();
    const takeBack = giveOwnMeshes(document, shared);
    const members = ownTexels ? membersOf(document).filter(isWanted) : wanted;
    const lay = async () => {
      const meshes = grouped(members, groupBy)
        .map((group) => documentMesh(document, group, readTexcoord))
        .filter(({ indices }) => indices.length > 0);
      return unwrapGroups(abflat, meshes, settings);
    };
    const unwrapped = await lay().catch((error) => {
      takeBack();
      throw error;
    });
    for (const { parts, result } of unwrapped) {
      const { turnedFaces } = result.report.repair;
      setTexcoords({ document, parts }, result, { texcoord: set, turnedFaces });
    }
    for (const atlas of unwrapped) await onAtlas?.({ ...atlas, texcoord: set });
  };
  return Object.defineProperty(transform, 'name', { value: 'unwrap' });
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
  const { texcoord, readTexcoord, overwrite, groupBy, ownTexels, onAtlas } = options;
  const isSet = (set: unknown) => Number.isInteger(set) && (set as number) >= 0;
  if (texcoord !== 'auto' && !isSet(texcoord))
    throw invalid(`texcoord must be 'auto' or a whole number from 0, not ${shown(texcoord)}.`);
  if (!isSet(readTexcoord))
    throw invalid(`readTexcoord must be a whole number from 0, not ${shown(readTexcoord)}.`);
  checkBoolean('overwrite', overwrite);
  checkBoolean('ownTexels', ownTexels);
  checkFunction('onAtlas', onAtlas);
  if (!['scene', 'mesh', 'primitive'].includes(groupBy as string))
    throw invalid(`groupBy must be one of scene, mesh, primitive, not ${shown(groupBy)}.`);
}

const invalid = (message: string) => new AbflatError('InvalidOption', message);

function grouped(members: Member[], groupBy: GroupBy): Member[][] {
  const groups = new Map<Mesh | Primitive | undefined, Member[]>();
  for (const member of members) {
    const key = groupBy === 'scene' ? undefined : member[groupBy];
    const group = groups.get(key) ?? [];
    group.push(member);
    groups.set(key, group);
  }
  return [...groups.values()];
}

/** One after the other; `fraction` covers all of them. */
async function unwrapGroups(
  abflat: Pick<Abflat, 'unwrap'>,
  meshes: DocumentMesh[],
  options: UnwrapOptions,
): Promise<Omit<DocumentAtlas, 'texcoord'>[]> {
  const { onProgress } = ownFields(options);
  const atlases: Omit<DocumentAtlas, 'texcoord'>[] = [];
  for (const [i, mesh] of meshes.entries()) {
    const tell = (progress: UnwrapProgress) =>
      onProgress?.({ ...progress, fraction: (i + progress.fraction) / meshes.length });
    const result = await abflat.unwrap(neededFor(options, mesh), {
      ...options,
      ...(onProgress && { onProgress: tell }),
      transfer: true,
      roundsForGltf: true,
    });
    // The only ones it has are about nodes that share texels.
    const notes = mesh.notes.map(
      (note) => `${note}. With the option ownTexels each node gets texels of its own`,
    );
    result.report.notes.unshift(...notes);
    atlases.push({ parts: mesh.parts, result });
  }
  return atlases;
}
