// Reads glTF files as one mesh, and writes them back with its new coordinates.

import type { Document, Material, Primitive } from '@gltf-transform/core';
import { documentMesh, freeTexcoord, sampledTexcoords, setTexcoords } from 'abflat/gltf';
import { loadInWorker } from '../base/load-part';
import { isFbx } from '../base/mesh-files';
import type { ChosenGltf, GltfFile, GltfFiles, LayoutArrays } from '../model/model';
import { GLTF } from '../words/gltf';
import { compressionsOf, decompressed } from './compression';
import { contentsOf } from './gltf-contents';
import { namedParts } from './gltf-parts';
import { glbOf, gltfIo, openGltf } from './gltf-source';

/** Null for a compressed file and for an FBX, which `readLong` reads. */
export function readGltf(chosen: ChosenGltf): Promise<GltfFile | null> {
  const { name } = chosen.file;
  return orDamaged(name, async () => (isFbx(name) ? null : readPlain(chosen)));
}

/** What may take forever to decode. The copy it keeps is an uncompressed GLB, so that nothing is decoded twice. */
export function readLong(chosen: ChosenGltf): Promise<GltfFile> {
  const { name } = chosen.file;
  return orDamaged(name, () => (isFbx(name) ? fromFbx : decode)(chosen));
}

/** Problems that glTF-Transform does not check for end in plain JavaScript errors. */
export async function orDamaged<T>(name: string, read: () => Promise<T>): Promise<T> {
  try {
    return await read();
  } catch (error) {
    if (!(error instanceof TypeError || error instanceof RangeError)) throw error;
    throw new Error(GLTF.damaged(name, error.message));
  }
}

async function readPlain({ file, others, texcoord }: ChosenGltf): Promise<GltfFile | null> {
  const { source, used } = await openGltf(file, others);
  if (compressionsOf(source).length > 0) return null;
  const document = await gltfIo().readJSON(source);
  const [copy, ...copies] = used.map(({ name, bytes }) => fileOf(name, bytes));
  return { ...contentOf(file.name, document, texcoord), files: { file: copy, others: copies } };
}

async function decode({ file, others, texcoord }: ChosenGltf): Promise<GltfFile> {
  const { name } = file;
  const { source } = await openGltf(file, others);
  const document = await decompressed(name, source);
  return {
    ...contentOf(name, document, texcoord),
    files: { file: fileOf(name, await glbOf(document)), others: [] },
    compressions: compressionsOf(source),
    remarks: [GLTF.compressed(name, compressionsOf(source))],
  };
}

async function fromFbx({ file, others, texcoord }: ChosenGltf): Promise<GltfFile> {
  const { readFbx } = await loadInWorker(import('./fbx-file'));
  const { document, lost, remarks } = await readFbx(file, others);
  return {
    ...contentOf(file.name, document, texcoord),
    files: { file: fileOf(file.name, await glbOf(document)), others: [] },
    lost,
    remarks,
  };
}

/** The file as GLB, with the coordinates of a layout of its mesh. */
export async function writeGltf(
  { file, others }: GltfFiles,
  layout: LayoutArrays,
  texcoord: number,
): Promise<Blob> {
  const { source } = await openGltf(file, others);
  const document = await gltfIo().readJSON(source);
  setTexcoords(documentMesh(document), layout, { texcoord });
  return new Blob([await glbOf(document)], { type: 'model/gltf-binary' });
}

function contentOf(name: string, document: Document, texcoord: number): Omit<GltfFile, 'files'> {
  const mesh = documentMesh(document, undefined, texcoord);
  const { positions, indices, texcoords, normals, materials, vertexObjects, notes } = mesh;
  if (indices.length === 0) throw new Error(GLTF.noTriangles(name));
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());
  return {
    mesh: { positions, indices, texcoords, normals, materials, vertexObjects },
    freeTexcoord: freeTexcoord(document),
    notes,
    texcoordSets: texcoordSets(primitives),
    paintedSets: sampledTexcoords(primitives),
    parts: namedParts(document, mesh.parts),
    holds: contentsOf(document),
    isPainted: primitives.some(
      (each) => hasMaps(each.getMaterial()) || each.getAttribute('COLOR_0') !== null,
    ),
    lost: [],
    compressions: [],
    remarks: [],
  };
}

function texcoordSets(primitives: Primitive[]): number[] {
  const names = primitives.flatMap((primitive) => primitive.listSemantics());
  const sets = names.flatMap((name) => /^TEXCOORD_(\d+)$/.exec(name)?.[1] ?? []);
  return [...new Set(sets.map(Number))].sort((a, b) => a - b);
}

/** Not those of extensions, which keep their layout. */
const hasMaps = (material: Material | null) =>
  material !== null &&
  [
    material.getBaseColorTexture(),
    material.getMetallicRoughnessTexture(),
    material.getOcclusionTexture(),
    material.getNormalTexture(),
    material.getEmissiveTexture(),
  ].some((texture) => texture !== null);

const fileOf = (name: string, bytes: Uint8Array) =>
  new File([bytes as Uint8Array<ArrayBuffer>], name);
