// Reads the meshes that callers declare: interleaved arrays with strides in bytes.

import { AbflatError } from '../base/errors.js';
import { fieldsOf } from '../messages/fields.js';
import { checkMemory, shown, tagOf } from '../messages/validate.js';
import type { MeshDecl, UvMeshDecl } from './types.js';

/** A mesh with tight arrays of its own. */
export interface Part {
  /** 3 per vertex; what is not finite is 0. */
  positions: Float64Array;
  indices: Uint32Array;
  /** Which faces can be drawn: the others get the uv 0, 0, as in xatlas. */
  isDrawn: Uint8Array;
  normals?: Float64Array | undefined;
  /** 2 per vertex. */
  uvs?: Float64Array | undefined;
  materials?: Uint32Array | undefined;
}

type Name = keyof MeshDecl | keyof UvMeshDecl;
type Fields = Partial<Record<Name, unknown>>;

const invalid = (message: string) => new AbflatError('InvalidMesh', message);

export function readMesh(decl: unknown): Part {
  const given = fieldsOf(decl, [
    ...['vertexCount', 'vertexPositionData', 'vertexPositionStride', 'vertexNormalData'],
    ...['vertexNormalStride', 'vertexUvData', 'vertexUvStride', 'indexData', 'indexCount'],
    ...['indexOffset', 'faceMaterialData', 'faceVertexCount', 'faceCount'],
  ] as Name[]);
  const count = wholeNumber('vertexCount', given.vertexCount);
  const positions = rows(given, 'vertexPositionData', 'vertexPositionStride', count, 3);
  if (!positions) throw invalid('The mesh has no vertexPositionData.');
  const part = partOf(given, positions, count);
  checkTriangles(given.faceVertexCount);
  const normals = rows(given, 'vertexNormalData', 'vertexNormalStride', count, 3);
  if (normals) part.normals = finite(normals, 3);
  part.uvs = rows(given, 'vertexUvData', 'vertexUvStride', count, 2);
  return part;
}

export function readUvMesh(decl: unknown): Part {
  const given = fieldsOf(decl, [
    ...['vertexCount', 'vertexUvData', 'vertexStride', 'indexData', 'indexCount'],
    ...['indexOffset', 'faceMaterialData'],
  ] as Name[]);
  const count = wholeNumber('vertexCount', given.vertexCount);
  const uvs = rows(given, 'vertexUvData', 'vertexStride', count, 2);
  if (!uvs) throw invalid('The mesh has no vertexUvData.');
  const positions = new Float64Array(3 * count);
  for (let v = 0; v < count; ++v) positions.set(uvs.subarray(2 * v, 2 * v + 2), 3 * v);
  return { ...partOf(given, positions, count), uvs: finite(uvs, 2) };
}

function partOf(given: Fields, positions: Float64Array, count: number): Part {
  const indices = indicesOf(given, count);
  const part: Part = {
    positions: finite(positions, 3),
    indices,
    isDrawn: drawn(positions, indices),
  };
  const { faceMaterialData } = given;
  if (faceMaterialData !== undefined && faceMaterialData !== null) {
    part.materials = whole('faceMaterialData', faceMaterialData);
    if (part.materials.length < indices.length / 3)
      throw invalid(
        `faceMaterialData has ${part.materials.length} elements, but there are ${indices.length / 3} faces.`,
      );
  }
  return part;
}

function indicesOf({ indexData, indexCount, indexOffset = 0 }: Fields, count: number): Uint32Array {
  const all =
    indexData === undefined || indexData === null
      ? Uint32Array.from({ length: count }, (_, i) => i)
      : whole('indexData', indexData);
  const wanted = indexCount === undefined ? all.length : wholeNumber('indexCount', indexCount);
  if (wanted > all.length)
    throw invalid(`indexCount is ${wanted}, but indexData has ${all.length} elements.`);
  if (wanted % 3 !== 0) throw invalid(`indexCount is ${wanted}, not a multiple of 3.`);
  const offset = Number(indexOffset);
  const indices = all.subarray(0, wanted).map((index) => index + offset);
  const wrong = indices.findIndex((vertex) => vertex >= count);
  if (wrong < 0) return indices;
  throw invalid(
    `indexData[${wrong}] is vertex ${indices[wrong]}, but there are only ${count} vertices.`,
  );
}

/** Without faces that have no area by their numbers, and those with coordinates that are not finite. */
function drawn(positions: Float64Array, indices: Uint32Array): Uint8Array {
  const isPlaced = (vertex: number) =>
    positions.subarray(3 * vertex, 3 * vertex + 3).every((x) => Number.isFinite(x));
  return Uint8Array.from({ length: indices.length / 3 }, (_, face) => {
    const [a, b, c] = indices.subarray(3 * face, 3 * face + 3) as unknown as [
      number,
      number,
      number,
    ];
    return Number(a !== b && b !== c && c !== a && [a, b, c].every(isPlaced));
  });
}

/** The rows with numbers that are not finite as 0: the module refuses them, even if unused. */
function finite(values: Float64Array, size: number): Float64Array {
  const out = values.slice();
  for (let i = 0; i < out.length; i += size) {
    const row = out.subarray(i, i + size);
    if (!row.every((x) => Number.isFinite(x))) row.fill(0);
  }
  return out;
}

/** `size` numbers of single precision per vertex. */
function rows(
  given: Fields,
  name: Name,
  strideName: Name,
  count: number,
  size: number,
): Float64Array | undefined {
  const data = given[name];
  if (data === undefined || data === null) return undefined;
  const tag = tagOf(data);
  if (tag !== 'Float32Array' && tag !== 'Uint8Array')
    throw invalid(`${name} must be a Float32Array or Uint8Array, not ${tag}.`);
  const view = data as Float32Array | Uint8Array;
  checkMemory(name, view);
  const stride = wholeNumber(strideName, given[strideName] ?? 4 * size);
  const needed = count === 0 ? 0 : (count - 1) * stride + 4 * size;
  if (view.byteLength < needed)
    throw invalid(
      `${name} has ${view.byteLength} bytes, but ${count} vertices with a ${strideName} of ${stride} need ${needed}.`,
    );
  const bytes = new DataView(view.buffer, view.byteOffset, view.byteLength);
  const out = new Float64Array(size * count);
  for (let v = 0; v < count; ++v)
    for (let k = 0; k < size; ++k) out[size * v + k] = bytes.getFloat32(v * stride + 4 * k, true);
  return out;
}

const WHOLE = ['Uint32Array', 'Uint16Array', 'Uint8Array'];

function whole(name: Name, values: unknown): Uint32Array {
  const tag = tagOf(values);
  if (!WHOLE.includes(tag))
    throw invalid(`${name} must be a Uint32Array or Uint16Array, not ${tag}.`);
  checkMemory(name, values as Uint32Array);
  return new Uint32Array(values as Uint32Array);
}

function wholeNumber(name: Name, value: unknown): number {
  if (Number.isInteger(value) && (value as number) >= 0) return value as number;
  throw invalid(`${name} must be a whole number from 0, not ${shown(value)}.`);
}

function checkTriangles(counts: unknown): void {
  if (counts === undefined || counts === null) return;
  const other = whole('faceVertexCount', counts).findIndex((corners) => corners !== 3);
  if (other >= 0)
    throw invalid(
      `Face ${other} is not a triangle. Triangulate the mesh, without faceVertexCount.`,
    );
}
