// glTF files as one mesh, and back with its new coordinates.

import { type Document, type JSONDocument, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { documentMesh, freeTexcoord, setTexcoords } from 'abflat/gltf';
import { count } from '../base/format';
import type { GltfFile, GltfFiles, LayoutArrays } from '../model/model';

export async function readGltf(file: File, others: File[]): Promise<GltfFile> {
  const { name } = file;
  const { source, used } = await open(file, others);
  refuseCompressed(name, source);
  const document = await io().readJSON(source);
  const { positions, indices, texcoords, materials } = documentMesh(document);
  if (indices.length === 0)
    throw new Error(`${name} has no triangles, so there is nothing to unwrap.`);
  const [copy, ...copies] = used.map(
    ({ name, bytes }) => new File([bytes as Uint8Array<ArrayBuffer>], name),
  );
  return {
    mesh: { positions, indices, texcoords, materials },
    freeTexcoord: freeTexcoord(document),
    files: { file: copy, others: copies },
  };
}

/** The file as GLB, with the coordinates of a layout of its mesh. */
export async function writeGltf(
  { file, others }: GltfFiles,
  layout: LayoutArrays,
  texcoord: number,
): Promise<Blob> {
  const { source } = await open(file, others);
  const document = await io().readJSON(source);
  setTexcoords(documentMesh(document), layout, { texcoord });
  joinBuffers(document);
  const bytes = await io().writeBinary(document);
  return new Blob([bytes as Uint8Array<ArrayBuffer>], { type: 'model/gltf-binary' });
}

const io = () => new WebIO().registerExtensions(ALL_EXTENSIONS);

/** What was read of which file. */
interface Used {
  name: string;
  bytes: Uint8Array;
}

async function open(file: File, others: File[]): Promise<{ source: JSONDocument; used: Used[] }> {
  const { name } = file;
  const bytes = new Uint8Array(await file.arrayBuffer());
  const isBinary = new TextDecoder().decode(bytes.subarray(0, 4)) === 'glTF';
  if (isBinary) {
    checkLength(name, bytes);
    return { source: await io().binaryToJSON(bytes), used: [{ name, bytes }] };
  }
  const json = parse(name, new TextDecoder().decode(bytes));
  const found = await resources(name, json, others);
  const byUri = [...found].map(([uri, { bytes }]) => [uri, bytes]);
  return {
    source: { json, resources: Object.fromEntries(byUri) },
    used: [{ name, bytes }, ...found.values()],
  };
}

/** A GLB says how long it is. */
function checkLength(name: string, bytes: Uint8Array): void {
  const length = bytes.length < 12 ? 12 : new DataView(bytes.buffer).getUint32(8, true);
  if (bytes.length < length)
    throw new Error(
      `${name} is truncated: ${count(bytes.length)} of ${count(length)} bytes are there. Copy or download it again.`,
    );
}

function parse(name: string, text: string): JSONDocument['json'] {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Error(`${name} is neither binary nor JSON: ${String(error)}`);
  }
}

/** The files that a document names, by their names alone: a browser does not tell where they are. */
async function resources(
  name: string,
  { buffers = [], images = [] }: JSONDocument['json'],
  others: File[],
): Promise<Map<string, Used>> {
  const found = new Map<string, Used>();
  for (const { uri } of [...buffers, ...images]) {
    if (uri === undefined || uri.startsWith('data:')) continue;
    const wanted = decodeURIComponent(uri).split('/').at(-1);
    const file = others.find((other) => other.name === wanted);
    if (!file) throw new Error(`${name} needs ${wanted}: open or drop both files together.`);
    found.set(uri, { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });
  }
  return found;
}

function refuseCompressed(name: string, { json }: JSONDocument): void {
  const compressed = json.extensionsUsed?.find((each) => /draco|meshopt/.test(each));
  if (compressed)
    throw new Error(
      `${name} is compressed (${compressed}), which this page cannot read: save it without compression.`,
    );
}

/** A GLB has one buffer. */
function joinBuffers(document: Document): void {
  const [first, ...more] = document.getRoot().listBuffers();
  for (const accessor of document.getRoot().listAccessors()) accessor.setBuffer(first ?? null);
  for (const buffer of more) buffer.dispose();
}
