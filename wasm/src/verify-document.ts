// Verifies the layout of glTF-Transform documents.

import type { Document } from '@gltf-transform/core';
import { AbflatError } from './base/errors.js';
import { type DocumentMesh, documentMesh, membersOf } from './gltf/document-mesh.js';
import { checkGroupBy, checkSets, type GroupBy, grouped } from './gltf/groups.js';
import { checkAbflat, checkFunction, optionsOf } from './messages/validate.js';
import type { AnyAbflat, VerifyOptions, VerifyProgress, VerifyResult } from './types/index.js';

/** Faces of the result are the triangles of `parts`, in their order. */
export interface VerifiedAtlas extends Pick<DocumentMesh, 'parts'> {
  result: VerifyResult;
}

/** The options of `verify`, which apply to every atlas, and these. */
export interface VerifyDocumentOptions extends Omit<VerifyOptions, 'transfer' | 'uv'> {
  /** The layout is TEXCOORD_`texcoord`. Default: 0. */
  texcoord?: number;
  /** Default: `scene`, one atlas for all. */
  groupBy?: GroupBy;
}

/** Judges the layout of a document, which stays as it is: a result for each atlas. */
export async function verifyDocument(
  abflat: AnyAbflat<'verify'>,
  document: Document,
  settings: VerifyDocumentOptions = {},
): Promise<VerifiedAtlas[]> {
  checkAbflat(abflat, 'verify');
  const { texcoord = 0, groupBy = 'scene', onProgress, ...options } = optionsOf(settings);
  checkSets(texcoord, texcoord);
  checkGroupBy(groupBy);
  checkFunction('onProgress', onProgress);
  const meshes = meshesOf(document, texcoord, groupBy);
  const atlases: VerifiedAtlas[] = [];
  for (const [i, { positions, indices, texcoords, parts, notes }] of meshes.entries()) {
    const tell = (progress: VerifyProgress) =>
      onProgress?.({ ...progress, fraction: (i + progress.fraction) / meshes.length });
    const mesh = { positions, indices, ...(texcoords && { texcoords }) };
    const call = { ...options, ...(onProgress && { onProgress: tell }), transfer: true };
    const result = await abflat.verify(mesh, call);
    result.report.notes.unshift(...notes);
    atlases.push({ parts, result });
  }
  return atlases;
}

/** A mesh for each atlas of which a part has a layout. */
function meshesOf(document: Document, set: number, groupBy: GroupBy): DocumentMesh[] {
  const meshes = grouped(membersOf(document), groupBy)
    .map((group) => documentMesh(document, group, set))
    .filter(({ indices, texcoords }) => indices.length > 0 && texcoords !== undefined);
  if (meshes.length > 0) return meshes;
  throw new AbflatError(
    'NoTexcoords',
    `No triangle has TEXCOORD_${set}, so there is no layout to verify. Make one with unwrap.`,
  );
}
