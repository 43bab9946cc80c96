// Unwraps documents of glTF-Transform.

import type { Document, Mesh, Primitive, Transform } from '@gltf-transform/core';
import { AbflatError } from './errors.js';
import { type DocumentMesh, documentMesh, type Member, membersOf } from './gltf/document-mesh.js';
import { setTexcoords } from './gltf/texcoords.js';
import { neededFor } from './needed-arrays.js';
import type { Abflat, UnwrapOptions, UnwrapProgress, UnwrapResult } from './types.js';
import { checkBoolean, checkFunction, checkNumber } from './validate.js';

export {
  type DocumentMesh,
  type DocumentPart,
  documentMesh,
} from './gltf/document-mesh.js';
export { type SetTexcoordsOptions, setTexcoords } from './gltf/texcoords.js';

/** What shares an atlas: everything, the primitives of a mesh, or each primitive has one of its own. */
export type GroupBy = 'scene' | 'mesh' | 'primitive';

export interface DocumentAtlas extends Pick<DocumentMesh, 'parts'> {
  result: UnwrapResult;
}

/** Those of `unwrap`, for all that is unwrapped, and */
export interface UnwrapDocumentOptions
  extends Omit<UnwrapOptions, 'transfer' | 'obj' | 'ply' | 'seamEdges' | 'roundsForGltf'> {
  /** The new coordinates become TEXCOORD_`texcoord`. Default: 0. */
  texcoord?: number;
  /** Whether primitives that have that set get a new one; otherwise they stay as they are. Default: true. */
  overwrite?: boolean;
  /** Default: `scene`, one atlas for all. */
  groupBy?: GroupBy;
  /** Called for each atlas when the document has it. */
  onAtlas?: (atlas: DocumentAtlas) => void;
}

/**
 * A transform that gives a document an atlas: `await document.transform(unwrap(abflat, { texcoord: 1 }))`. What goes wrong leaves the
 * document as it was.
 */
export function unwrap(
  abflat: Pick<Abflat, 'unwrap'>,
  options: UnwrapDocumentOptions = {},
): Transform {
  const { texcoord = 0, overwrite = true, groupBy = 'scene', onAtlas, ...rest } = options;
  check({ texcoord, overwrite, groupBy, onAtlas });
  const transform = async (document: Document): Promise<void> => {
    const all = membersOf(document);
    if (all.length === 0)
      throw new AbflatError('EmptyMesh', 'The document has no triangles to unwrap.');
    const isWanted = ({ primitive }: Member) =>
      overwrite || !primitive.getAttribute(`TEXCOORD_${texcoord}`);
    const atlases = await unwrapGroups(
      abflat,
      grouped(all.filter(isWanted), groupBy).map((members) => documentMesh(document, members)),
      rest,
    );
    for (const { parts, result } of atlases)
      setTexcoords({ document, parts }, result, { texcoord });
    for (const atlas of atlases) onAtlas?.(atlas);
  };
  return Object.defineProperty(transform, 'name', { value: 'unwrap' });
}

function check(options: UnwrapDocumentOptions): void {
  const { texcoord, overwrite, groupBy, onAtlas } = options;
  checkNumber('texcoord', texcoord, { range: 'from 0, whole', atLeast: 0 });
  checkBoolean('overwrite', overwrite);
  checkFunction('onAtlas', onAtlas);
  if (!Number.isInteger(texcoord) || !['scene', 'mesh', 'primitive'].includes(groupBy as string))
    throw new AbflatError(
      'InvalidOption',
      `texcoord must be whole and groupBy one of scene, mesh, primitive; they are ${texcoord} and ${groupBy}.`,
    );
}

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

/** One after the other; progress is that of all together. */
async function unwrapGroups(
  abflat: Pick<Abflat, 'unwrap'>,
  meshes: DocumentMesh[],
  options: UnwrapOptions,
): Promise<DocumentAtlas[]> {
  const { onProgress } = options;
  const atlases: DocumentAtlas[] = [];
  for (const [i, mesh] of meshes.entries()) {
    const tell = (progress: UnwrapProgress) =>
      onProgress?.({ ...progress, fraction: (i + progress.fraction) / meshes.length });
    const result = await abflat.unwrap(neededFor(options, mesh), {
      ...options,
      ...(onProgress && { onProgress: tell }),
      transfer: true,
      roundsForGltf: true,
    });
    atlases.push({ parts: mesh.parts, result });
  }
  return atlases;
}
