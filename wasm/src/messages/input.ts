// Checks the mesh that a caller passes and makes the call its owner.

import { AbflatError, messageOf } from '../base/errors.js';
import type { MeshArrays } from '../types/index.js';
import { fieldsOf, hasField } from './fields.js';
import type { OwnedArrays, OwnedFile, OwnedMesh } from './protocol.js';
import { bytesIn, checkBoolean, checkMemory, shown, tagOf } from './validate.js';

export interface Owned<T extends OwnedMesh> {
  mesh: T;
  /** All buffers of the mesh, to hand them to the worker. */
  buffers: ArrayBuffer[];
}

/** How a call comes by the arrays of a checked mesh. */
export interface Taking {
  take<T extends OwnedMesh>(mesh: T, transfer: unknown): Owned<T>;
}

const WANTED = 'The mesh must be { positions, indices } or { bytes, name }';

/** Advice for the mesh objects of other libraries. */
function hintFor(mesh: object): string {
  if ('isBufferGeometry' in mesh || 'isObject3D' in mesh)
    return '. For three.js geometry, use unwrapGeometry, packGeometry or verifyGeometry of "abflat/three"';
  if ('getRoot' in mesh)
    return '. For glTF-Transform documents, use unwrap, pack or verifyDocument of "abflat/gltf"';
  return '';
}

const invalid = (message: string) => new AbflatError('InvalidMesh', message);

export function takeMesh(mesh: unknown, transfer: unknown, taking: Taking): Owned<OwnedMesh> {
  return taking.take(checkMesh(mesh), transfer);
}

/** A layout, which a file may not be. */
export function takeArrays(mesh: unknown, transfer: unknown, taking: Taking): Owned<OwnedArrays> {
  if (tagOf(mesh) !== 'Object' || hasField(mesh, 'bytes'))
    throw invalid('The layout must be { positions, indices, texcoords }.');
  return taking.take(checkArrays(mesh as object), transfer);
}

export function takeFile(file: unknown, transfer: unknown, taking: Taking): Owned<OwnedFile> {
  if (tagOf(file) !== 'Object' || !hasField(file, 'bytes'))
    throw invalid('The file must be { bytes, name }.');
  return taking.take(checkFile(file), transfer);
}

/** In buffers of its own: copies, or with `transfer` the caller's, which get detached. */
export function take<T extends OwnedMesh>(mesh: T, transfer: unknown): Owned<T> {
  checkBoolean('transfer', transfer);
  const owned = transfer ? move(mesh) : copy(mesh);
  return { mesh: owned, buffers: buffersOf(owned) };
}

function move<T extends OwnedMesh>(mesh: T): T {
  const buffers = buffersOf(mesh);
  try {
    return structuredClone(mesh, { transfer: buffers });
  } catch (error) {
    throw new AbflatError(
      'InvalidOption',
      `transfer: the buffers cannot be transferred (${messageOf(error)}).`,
    );
  }
}

function checkMesh(mesh: unknown): OwnedMesh {
  if (tagOf(mesh) !== 'Object') throw invalid(`${WANTED}.`);
  return hasField(mesh, 'bytes') ? checkFile(mesh) : checkArrays(mesh as object);
}

function checkFile(file: unknown): OwnedFile {
  const { bytes, name = 'mesh' } = fieldsOf(file, ['bytes', 'name']);
  if (typeof name !== 'string') throw invalid('The name of the mesh must be a string.');
  const tag = tagOf(bytes);
  if (tag !== 'Uint8Array' && tag !== 'ArrayBuffer')
    throw invalid(`bytes must be a Uint8Array or ArrayBuffer, not ${tag}.`);
  const content = contentOf(bytes as Uint8Array | ArrayBuffer);
  refuseGltf(content, name);
  return { bytes: content, name };
}

function contentOf(bytes: Uint8Array | ArrayBuffer): Uint8Array {
  if (!ArrayBuffer.isView(bytes)) return bytesIn('bytes', bytes);
  checkMemory('bytes', bytes);
  return bytes;
}

function refuseGltf(bytes: Uint8Array, name: string): void {
  const isBinary = String.fromCharCode(...bytes.subarray(0, 4)) === 'glTF';
  if (!isBinary && !/\.gl(b|tf)$/i.test(name)) return;
  throw new AbflatError(
    'UnreadableFile',
    `${name} is a glTF. Read it with glTF-Transform and use unwrap, pack or verifyDocument of "abflat/gltf", or with GLTFLoader of three.js and use ` +
      'unwrapGeometry, packGeometry or verifyGeometry of "abflat/three".',
  );
}

const REALS = ['Float32Array', 'Float64Array'];
const WHOLE = ['Uint32Array', 'Uint16Array', 'Uint8Array'];
const OTHERS = ['Array', 'Int8Array', 'Int16Array', 'Int32Array'];

const OF_ARRAYS: readonly (keyof MeshArrays)[] = [
  'positions',
  'indices',
  'texcoords',
  'normals',
  'cornerNormals',
  'materials',
  'vertexObjects',
];

function checkArrays(mesh: object): OwnedArrays {
  const given = fieldsOf(mesh, OF_ARRAYS);
  if (given.positions === undefined)
    throw invalid(`${WANTED}; it has no positions${hintFor(mesh)}.`);
  const positions = reals('positions', given.positions);
  checkMultiple('positions', positions, 3);
  const indices =
    given.indices === undefined || given.indices === null
      ? ofSeparateTriangles(positions.length / 3)
      : whole('indices', given.indices);
  checkMultiple('indices', indices, 3);
  const checked: OwnedArrays = { positions, indices };
  const [vertices, triangles] = [positions.length / 3, indices.length / 3];
  const extras: [keyof OwnedArrays, typeof reals | typeof whole, number, string][] = [
    ['texcoords', reals, 2 * vertices, '2 per vertex'],
    ['normals', reals, 3 * vertices, '3 per vertex'],
    ['cornerNormals', reals, 9 * triangles, '3 per corner'],
    ['materials', whole, triangles, '1 per triangle'],
    ['vertexObjects', whole, vertices, '1 per vertex'],
  ];
  for (const [name, read, wanted, rule] of extras) {
    if (given[name] === undefined) continue;
    const array = read(name, given[name]);
    checkLength(name, array, wanted, rule);
    Object.assign(checked, { [name]: array });
  }
  return checked;
}

function ofSeparateTriangles(vertexCount: number): Uint32Array {
  if (vertexCount % 3 !== 0)
    throw invalid(
      `Without indices, every three vertices make a triangle, but there are ${vertexCount} vertices.`,
    );
  return Uint32Array.from({ length: vertexCount }, (_, vertex) => vertex);
}

/** Returns an array of a type that the module takes as it is. */
export function reals(name: string, values: unknown): Float32Array | Float64Array {
  const tag = kindOf(name, values);
  if (REALS.includes(tag)) return values as Float32Array;
  checkKind(name, tag, [...REALS, ...WHOLE]);
  return new Float64Array(
    listOf(values as ArrayLike<unknown>, (value, i) => {
      if (typeof value === 'number') return;
      throw invalid(`${name}[${i}] must be a number, not ${tagOf(value)}.`);
    }),
  );
}

export function whole(name: string, values: unknown): Uint32Array | Uint16Array | Uint8Array {
  const tag = kindOf(name, values);
  if (WHOLE.includes(tag)) return values as Uint32Array;
  checkKind(name, tag, WHOLE);
  return new Uint32Array(
    listOf(values as ArrayLike<unknown>, (value, i) => {
      const isWhole = Number.isInteger(value) && (value as number) >= 0;
      if (isWhole && (value as number) < 2 ** 32) return;
      throw invalid(`${name}[${i}] must be a whole number from 0, not ${shown(value)}.`);
    }),
  );
}

/** The elements, each read once and checked: those of an array may be getters. */
function listOf(values: ArrayLike<unknown>, check: (value: unknown, i: number) => void): number[] {
  const list: number[] = [];
  for (let i = 0; i < values.length; ++i) {
    const value = values[i];
    check(value, i);
    list.push(value as number);
  }
  return list;
}

function kindOf(name: string, values: unknown): string {
  if (ArrayBuffer.isView(values) && tagOf(values) !== 'DataView') checkMemory(name, values);
  return tagOf(values);
}

function checkKind(name: string, tag: string, kinds: string[]): void {
  if (!kinds.includes(tag) && !OTHERS.includes(tag))
    throw invalid(`${name} must be an array of numbers, such as a ${kinds[0]}, not ${tag}.`);
}

export function checkMultiple(name: string, { length }: { length: number }, of: number): void {
  if (length % of !== 0) throw invalid(`${name} has ${length} elements, not a multiple of ${of}.`);
}

export function checkLength(
  name: string,
  { length }: { length: number },
  wanted: number,
  rule: string,
) {
  if (length !== wanted) throw invalid(`${name} has ${length} elements, not ${wanted}: ${rule}.`);
}

/** A typed array made from another gets its own buffer, even if the other's is shared. */
function copy<T extends OwnedMesh>(mesh: T): T {
  const fields = Object.entries(mesh).map(([name, value]) => {
    if (!ArrayBuffer.isView(value)) return [name, value];
    const view = value as Float64Array;
    checkMemory(name, view); // a getter of the mesh may have taken it since
    const Kind = KINDS[tagOf(view) as keyof typeof KINDS];
    return [name, new Kind(view)];
  });
  return Object.fromEntries(fields) as T;
}

/** Not `view.constructor`, which is Buffer for a Buffer of Node. */
const KINDS = { Float32Array, Float64Array, Uint32Array, Uint16Array, Uint8Array };

function buffersOf(mesh: OwnedMesh): ArrayBuffer[] {
  const views = Object.values(mesh).filter((value) => ArrayBuffer.isView(value));
  const buffers = [...new Set(views.map((view) => view.buffer))];
  if (buffers.some((buffer) => tagOf(buffer) !== 'ArrayBuffer'))
    throw new AbflatError('InvalidOption', 'transfer: shared memory cannot be transferred.');
  return buffers as ArrayBuffer[];
}
