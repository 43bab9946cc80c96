// Checks the mesh that a caller passes and makes the call its owner.

import { AbflatError, messageOf } from './errors.js';
import type { OwnedFile, OwnedMesh } from './protocol.js';
import type { MeshArrays } from './types.js';
import { checkBoolean, tagOf } from './validate.js';

interface Owned<T extends OwnedMesh> {
  mesh: T;
  /** All buffers of the mesh, to hand them to the worker. */
  buffers: ArrayBuffer[];
}

const invalid = (message: string) => new AbflatError('InvalidMesh', message);

/** The mesh in buffers of its own: copies, or the caller's, which are detached by that. */
export function takeMesh(mesh: unknown, transfer: unknown): Owned<OwnedMesh> {
  return take(checkMesh(mesh), transfer);
}

export function takeFile(file: unknown, transfer: unknown): Owned<OwnedFile> {
  if (tagOf(file) !== 'Object' || !('bytes' in (file as object)))
    throw invalid('The file must be { bytes, name }.');
  return take(checkFile(file as object), transfer);
}

function take<T extends OwnedMesh>(mesh: T, transfer: unknown): Owned<T> {
  checkBoolean('transfer', transfer);
  const owned = transfer ? move(mesh) : copy(mesh);
  return { mesh: owned, buffers: buffersOf(owned) };
}

function move<T extends OwnedMesh>(mesh: T): T {
  const buffers = buffersOf(mesh);
  try {
    return structuredClone(mesh, { transfer: buffers });
  } catch (error) {
    throw new AbflatError('InvalidOption', `transfer: the buffers stay (${messageOf(error)}).`);
  }
}

function checkMesh(mesh: unknown): OwnedMesh {
  if (tagOf(mesh) !== 'Object')
    throw invalid('The mesh must be { positions, indices } or { bytes, name }.');
  return 'bytes' in (mesh as object) ? checkFile(mesh as object) : checkArrays(mesh as object);
}

function checkFile({ bytes, name = 'mesh' }: { bytes?: unknown; name?: unknown }): OwnedFile {
  if (typeof name !== 'string') throw invalid('The name of the mesh must be a string.');
  const tag = tagOf(bytes);
  if (tag === 'Uint8Array') return { bytes: bytes as Uint8Array, name };
  if (tag === 'ArrayBuffer') return { bytes: new Uint8Array(bytes as ArrayBuffer), name };
  throw invalid(`bytes must be a Uint8Array or ArrayBuffer, not ${tag}.`);
}

const REALS = ['Float32Array', 'Float64Array'];
const WHOLE = ['Uint32Array', 'Uint16Array'];

function checkArrays(mesh: Partial<Record<keyof MeshArrays, unknown>>): MeshArrays {
  checkTag('positions', mesh.positions, REALS);
  checkTag('indices', mesh.indices, WHOLE);
  const { positions, indices, texcoords, materials } = mesh as MeshArrays;
  for (const [name, { length }] of Object.entries({ positions, indices })) {
    if (length % 3 !== 0) throw invalid(`${name} has ${length} elements, not a multiple of 3.`);
  }
  const checked: MeshArrays = { positions, indices };
  if (texcoords !== undefined) {
    checkTag('texcoords', texcoords, REALS);
    checkLength('texcoords', texcoords, (2 * positions.length) / 3, '2 per vertex');
    checked.texcoords = texcoords;
  }
  if (materials !== undefined) {
    checkTag('materials', materials, WHOLE);
    checkLength('materials', materials, indices.length / 3, '1 per triangle');
    checked.materials = materials;
  }
  return checked;
}

function checkLength(name: string, { length }: { length: number }, wanted: number, rule: string) {
  if (length !== wanted) throw invalid(`${name} has ${length} elements, not ${wanted}: ${rule}.`);
}

function checkTag(name: string, value: unknown, tags: string[]): void {
  if (!tags.includes(tagOf(value)))
    throw invalid(`${name} must be a ${tags.join(' or ')}, not ${tagOf(value)}.`);
}

/** A typed array made from another has a buffer of its own, also where that of the other is shared. */
function copy<T extends OwnedMesh>(mesh: T): T {
  const fields = Object.entries(mesh).map(([name, value]) => {
    if (!ArrayBuffer.isView(value)) return [name, value];
    const view = value as Float64Array;
    const Kind = KINDS[tagOf(view) as keyof typeof KINDS];
    return [name, new Kind(view)];
  });
  return Object.fromEntries(fields) as T;
}

/** Not `view.constructor`: that of a Node Buffer is another. */
const KINDS = { Float32Array, Float64Array, Uint32Array, Uint16Array, Uint8Array };

function buffersOf(mesh: OwnedMesh): ArrayBuffer[] {
  const views = Object.values(mesh).filter((value) => ArrayBuffer.isView(value));
  const buffers = [...new Set(views.map((view) => view.buffer))];
  if (buffers.some((buffer) => tagOf(buffer) !== 'ArrayBuffer'))
    throw new AbflatError('InvalidOption', 'transfer: shared memory cannot be transferred.');
  return buffers as ArrayBuffer[];
}
