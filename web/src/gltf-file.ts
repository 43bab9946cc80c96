// glTF files as one mesh, and back with its new coordinates. Loaded when the first one is opened.

import { type Document, type JSONDocument, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import type { Layout } from 'abflat';
import { documentMesh, freeTexcoord, setTexcoords } from 'abflat/gltf';
import { count } from './format';
import type { ArrayMesh } from './mesh';
import type { FileSource } from './session';

export interface GltfFile {
  mesh: ArrayMesh;
  /** The first set of coordinates that no texture needs as it is: 0 where no texture uses that. */
  freeTexcoord: number;
  /** The file as GLB, with the coordinates of a layout of `mesh` as TEXCOORD_`texcoord`. */
  write(layout: Layout<unknown>, texcoord: number): Promise<Uint8Array>;
}

export async function readGltf({ file, name, others }: FileSource): Promise<GltfFile> {
  const source = await open(name, file, others);
  refuseCompressed(name, source);
  const document = await io().readJSON(source);
  const { positions, indices, texcoords, materials } = documentMesh(document);
  if (indices.length === 0)
    throw new Error(`${name} has no triangles, so there is nothing to unwrap.`);
  return {
    mesh: { positions, indices, texcoords, materials },
    freeTexcoord: freeTexcoord(document),
    async write(layout, texcoord) {
      // What was read is not kept: it would take several times the memory of the file.
      const document = await io().readJSON(source);
      setTexcoords(documentMesh(document), layout, { texcoord });
      joinBuffers(document);
      return io().writeBinary(document);
    },
  };
}

const io = () => new WebIO().registerExtensions(ALL_EXTENSIONS);

async function open(name: string, file: File, others: File[]): Promise<JSONDocument> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const isBinary = new TextDecoder().decode(bytes.subarray(0, 4)) === 'glTF';
  if (isBinary) {
    checkLength(name, bytes);
    return io().binaryToJSON(bytes);
  }
  const json = parse(name, new TextDecoder().decode(bytes));
  return { json, resources: await resources(name, json, others) };
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
): Promise<JSONDocument['resources']> {
  const found: JSONDocument['resources'] = {};
  for (const { uri } of [...buffers, ...images]) {
    if (uri === undefined || uri.startsWith('data:')) continue;
    const wanted = decodeURIComponent(uri).split('/').at(-1);
    const file = others.find((other) => other.name === wanted);
    if (!file) throw new Error(`${name} needs ${wanted}: open or drop both files together.`);
    found[uri] = new Uint8Array(await file.arrayBuffer());
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
