// glTF files as they are stored: JSON and the bytes that belong to it.

import { type Document, type JSONDocument, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { isGlb, meshFileOf } from '../base/mesh-files';
import { GLTF } from '../words/gltf';
import { READING } from '../words/opening';
import { NEWER } from './meshopt-views';
import { fileNamed, nameOf } from './missing-files';

const KNOWN = new Set<string>([...ALL_EXTENSIONS.map((each) => each.EXTENSION_NAME), NEWER]);

/** What was read from which file. */
interface Used {
  name: string;
  bytes: Uint8Array;
}

interface Opened {
  source: JSONDocument;
  used: Used[];
}

export const gltfIo = () => new WebIO().registerExtensions(ALL_EXTENSIONS);

export async function glbOf(document: Document): Promise<Uint8Array<ArrayBuffer>> {
  joinBuffers(document);
  return (await gltfIo().writeBinary(document)) as Uint8Array<ArrayBuffer>;
}

/** A GLB has only one buffer. */
function joinBuffers(document: Document): void {
  const [first, ...more] = document.getRoot().listBuffers();
  for (const accessor of document.getRoot().listAccessors()) accessor.setBuffer(first ?? null);
  for (const buffer of more) buffer.dispose();
}

/** Opens a file and those of `others` that it refers to. */
export async function openGltf(file: File, others: File[]): Promise<Opened> {
  const { name } = file;
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes.length === 0) throw new Error(READING.empty(name));
  const opened = isGlb(bytes) ? await openBinary(name, bytes) : await openText(name, bytes, others);
  checkExtensions(name, opened.source);
  return opened;
}

async function openBinary(name: string, bytes: Uint8Array): Promise<Opened> {
  checkLength(name, bytes);
  return { source: await gltfIo().binaryToJSON(bytes), used: [{ name, bytes }] };
}

async function openText(name: string, bytes: Uint8Array, others: File[]): Promise<Opened> {
  const json = parse(name, new TextDecoder().decode(bytes));
  const found = await resources(name, json, others);
  const byUri = [...found].map(([uri, { bytes }]) => [uri, bytes]);
  return {
    source: { json, resources: Object.fromEntries(byUri) },
    used: [{ name, bytes }, ...found.values()],
  };
}

function checkExtensions(name: string, { json }: JSONDocument): void {
  const unknown = json.extensionsRequired?.find((each) => !KNOWN.has(each));
  if (unknown !== undefined) throw new Error(GLTF.unknownExtension(name, unknown));
}

/** A GLB states its own length. */
function checkLength(name: string, bytes: Uint8Array): void {
  const length = bytes.length < 12 ? 12 : new DataView(bytes.buffer).getUint32(8, true);
  if (bytes.length < length) throw new Error(GLTF.truncated(name, bytes.length, length));
}

function parse(name: string, text: string): JSONDocument['json'] {
  const json = parseJson(name, text);
  if (!/^2\b/.test(json?.asset?.version)) throw new Error(GLTF.otherVersion(name));
  return json;
}

function parseJson(name: string, text: string): JSONDocument['json'] {
  try {
    return JSON.parse(text);
  } catch (error) {
    const { message } = error as Error;
    throw new Error(
      meshFileOf(name)?.ending === '.glb' ? GLTF.notGlb(name) : GLTF.notJson(name, message),
    );
  }
}

/** The files that a document refers to. */
async function resources(
  name: string,
  { buffers = [], images = [] }: JSONDocument['json'],
  others: File[],
): Promise<Map<string, Used>> {
  const found = new Map<string, Used>();
  for (const { uri } of [...buffers, ...images]) {
    if (uri === undefined || uri.startsWith('data:')) continue;
    const wanted = decodeURIComponent(uri);
    const file = fileNamed(wanted, others);
    if (!file) throw new Error(GLTF.needs(name, nameOf(wanted)));
    found.set(uri, { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });
  }
  return found;
}
