// Unwraps three.js geometry.

import {
  BufferAttribute,
  BufferGeometry,
  Float16BufferAttribute,
  InstancedBufferGeometry,
  type InterleavedBufferAttribute,
} from 'three';
import { AbflatError } from './base/errors.js';
import type { WrittenFormat } from './base/generated.js';
import { indexArray, pickRows } from './base/rows.js';
import { neededFor } from './messages/needed-arrays.js';
import { checkAbflat, checkMemory, checkString, optionsOf } from './messages/validate.js';
import type { Abflat, MeshArrays, UnwrapOptions, UnwrapResult } from './types/index.js';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/**
 * The options of `unwrap`, without `transfer`, as a geometry keeps its buffers, and without the
 * file formats.
 */
export interface UnwrapGeometryOptions extends Omit<UnwrapOptions, 'transfer' | WrittenFormat> {
  /** Name of the attribute for the new coordinates. Default: `uv`; `uv1` leaves `uv` as it is, for light maps. */
  attribute?: string;
}

/**
 * A new geometry with the new coordinates. It has all attributes, morph targets and groups of
 * `geometry`, which may or may not have an index, and repeats a vertex for every coordinate that it
 * has. Tangents are copied like the rest and belong to the old coordinates.
 */
export async function unwrapGeometry(
  abflat: Pick<Abflat, 'unwrap'>,
  geometry: BufferGeometry,
  settings: UnwrapGeometryOptions = {},
): Promise<{ geometry: BufferGeometry; result: UnwrapResult }> {
  checkAbflat(abflat);
  const { attribute = 'uv', ...options } = optionsOf(settings);
  checkString('attribute', attribute);
  const result = await abflat.unwrap(neededFor(options, meshOf(geometry)), options);
  return { geometry: withUv(geometry, result, attribute), result };
}

const invalid = (message: string) => new AbflatError('InvalidMesh', message);

function meshOf(geometry: BufferGeometry): MeshArrays {
  if (!(geometry as Partial<BufferGeometry> | undefined)?.isBufferGeometry)
    throw invalid('unwrapGeometry needs a BufferGeometry. For a mesh, pass mesh.geometry.');
  const position = geometry.getAttribute('position') as Attribute | undefined;
  if (!position) throw invalid('unwrapGeometry needs a geometry with a position attribute.');
  const positions = numbersOf(position, 3);
  if (geometry.index) checkMemory('The index of the geometry', geometry.index.array);
  const corners =
    geometry.index?.array ?? Uint32Array.from({ length: position.count }, (_, vertex) => vertex);
  // Leftover corners are not drawn either: they make no triangle.
  const indices = new Uint32Array(corners).subarray(0, corners.length - (corners.length % 3));
  const mesh: MeshArrays = { positions, indices };
  const uv = geometry.getAttribute('uv') as Attribute | undefined;
  if (uv) mesh.texcoords = numbersOf(uv, 2);
  const normal = geometry.getAttribute('normal') as Attribute | undefined;
  if (normal) mesh.normals = numbersOf(normal, 3);
  if (geometry.groups.length > 0) mesh.materials = materialsOf(geometry, indices.length / 3);
  return mesh;
}

/** The first `size` components of each row, denormalized; 0 if the attribute has fewer. */
function numbersOf(attribute: Attribute, size: 2 | 3): Float64Array {
  const { count, itemSize } = attribute;
  const out = new Float64Array(size * count);
  for (let i = 0; i < count; ++i) {
    out[size * i] = attribute.getX(i);
    if (itemSize > 1) out[size * i + 1] = attribute.getY(i);
    if (itemSize > 2 && size > 2) out[size * i + 2] = attribute.getZ(i);
  }
  return out;
}

/** One per triangle; 0 if no group covers it. */
function materialsOf({ groups }: BufferGeometry, triangleCount: number): Uint32Array {
  const materials = new Uint32Array(triangleCount);
  for (const { start, count, materialIndex = 0 } of groups)
    materials.fill(materialIndex + 1, start / 3, (start + count) / 3);
  return materials;
}

function withUv(from: BufferGeometry, result: UnwrapResult, name: string): BufferGeometry {
  const { uv, indices, vertexMap } = result;
  const to = emptyLike(from);
  to.name = from.name;
  to.userData = { ...from.userData };
  for (const [key, attribute] of Object.entries(from.attributes))
    to.setAttribute(key, isOfInstances(attribute) ? alike(attribute) : pick(attribute, vertexMap));
  to.setAttribute(name, new BufferAttribute(new Float32Array(uv), 2));
  const morphs: Record<string, Attribute[]> = to.morphAttributes;
  for (const [key, targets] of Object.entries<Attribute[]>(from.morphAttributes))
    morphs[key] = targets.map((target) => pick(target, vertexMap));
  to.morphTargetsRelative = from.morphTargetsRelative;
  to.setIndex(new BufferAttribute(indexArray(indices, vertexMap.length), 1));
  // Triangles keep their order, so ranges of them stay valid.
  to.groups = from.groups.map((group) => ({ ...group }));
  to.drawRange = { ...from.drawRange };
  to.boundingBox = from.boundingBox?.clone() ?? null;
  to.boundingSphere = from.boundingSphere?.clone() ?? null;
  return to;
}

function emptyLike(from: BufferGeometry): BufferGeometry {
  const { isInstancedBufferGeometry, instanceCount } = from as InstancedBufferGeometry;
  if (!isInstancedBufferGeometry) return new BufferGeometry();
  return Object.assign(new InstancedBufferGeometry(), { instanceCount });
}

/** Whether it has a row per instance, not per vertex. */
function isOfInstances(attribute: Attribute): boolean {
  return 'data' in attribute
    ? 'isInstancedInterleavedBuffer' in attribute.data
    : 'isInstancedBufferAttribute' in attribute;
}

/** A copy, or the attribute itself if interleaved, as others may share its buffer. */
const alike = (attribute: Attribute) => ('data' in attribute ? attribute : attribute.clone());

/** Copies the given rows of an attribute, as they are stored. */
function pick(attribute: Attribute, rows: Uint32Array): BufferAttribute {
  const { itemSize, normalized } = attribute;
  const isInterleaved = 'data' in attribute;
  const picked = isInterleaved
    ? pickRows(attribute.data.array, rows, {
        size: itemSize,
        stride: attribute.data.stride,
        offset: attribute.offset,
      })
    : pickRows(attribute.array, rows, { size: itemSize });
  const Kind = 'isFloat16BufferAttribute' in attribute ? Float16BufferAttribute : BufferAttribute;
  const made = new Kind(picked as Uint16Array, itemSize, normalized);
  made.name = attribute.name;
  if (!isInterleaved) {
    made.gpuType = attribute.gpuType;
    made.usage = attribute.usage;
  }
  return made;
}
