// Reads documents with compressed triangles as if they were uncompressed.

import type { Accessor, Document, JSONDocument } from '@gltf-transform/core';
import { GLTF } from '../words/gltf';
import { type Compression, loadDecoders } from './decoders';
import { gltfIo } from './gltf-source';
import { checkMeshopt, NEWER, OLDER, withOlderName } from './meshopt-views';

const KINDS = new Map<string, Compression>([
  ['KHR_draco_mesh_compression', 'Draco'],
  [OLDER, 'meshopt'],
  [NEWER, 'meshopt'],
]);

export function compressionsOf({ json }: JSONDocument): Compression[] {
  const kinds = json.extensionsUsed?.flatMap((name) => KINDS.get(name) ?? []);
  return [...new Set(kinds)];
}

/** The document of a file without its compression, so that it is also written without. */
export async function decompressed(name: string, source: JSONDocument): Promise<Document> {
  const kinds = compressionsOf(source);
  const decoders = await loadDecoders(kinds);
  const document = await decoded(source, decoders).catch((error: unknown) => {
    throw damaged(name, kinds, error);
  });
  for (const extension of document.getRoot().listExtensionsUsed())
    if (KINDS.has(extension.extensionName)) extension.dispose();
  return document;
}

async function decoded(source: JSONDocument, decoders: Record<string, unknown>): Promise<Document> {
  const known = withOlderName(source);
  checkMeshopt(known);
  const document = await gltfIo().registerDependencies(decoders).readJSON(known);
  const isEmpty = (accessor: Accessor) => accessor.getArray()?.length === 0;
  if (document.getRoot().listAccessors().some(isEmpty)) throw new Error(GLTF.attributeMissing);
  return document;
}

/** The error for damaged data: decoders say little, and a wrong count can fail anywhere. */
function damaged(name: string, kinds: Compression[], error: unknown): Error {
  const reason = (error instanceof Error ? error.message : String(error))
    .replace(/^\[\w+\]:? /, '')
    .replace(/\.$/, '');
  return new Error(GLTF.undecodable(name, kinds, reason));
}
