// A geometry of three.js as a mesh, and with the coordinates of a layout.

import {
  BufferAttribute,
  BufferGeometry,
  Float16BufferAttribute,
  InstancedBufferGeometry,
  type InterleavedBufferAttribute,
} from 'three';
import { AbflatError } from '../base/errors.js';
import { indexArray, pickRows } from '../base/rows.js';
import { checkMemory } from '../messages/validate.js';
import type { Layout, MeshArrays } from '../types/index.js';

type Attribute = BufferAttribute | InterleavedBufferAttribute;

const invalid = (message: string) => new AbflatError('InvalidMesh', message);

/** `uvName`: the attribute with the texcoords; `caller`: for messages. */
export function meshOf(geometry: BufferGeometry, uvName: string, caller: string): MeshArrays {
  if (!(geometry as Partial<BufferGeometry> | undefined)?.isBufferGeometry)
    throw invalid(`${caller} needs a BufferGeometry. For a mesh, pass mesh.geometry.`);
  const position = geometry.getAttribute('position') as Attribute | undefined;
  if (!position) throw invalid(`${caller} needs a geometry with a position attribute.`);
  const positions = numbersOf(position, 3);
  if (geometry.index) checkMemory('The index of the geometry', geometry.index.array);
  const corners =
    geometry.index?.array ?? Uint32Array.from({ length: position.count }, (_, vertex) => vertex);
  // Leftover corners are not drawn either: they make no triangle.
  const indices = new Uint32Array(corners).subarray(0, corners.length - (corners.length % 3));
  const mesh: MeshArrays = { positions, indices };
  const uv = geometry.getAttribute(uvName) as Attribute | undefined;
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

/**
 * A new geometry with the coordinates of a layout as the attribute `name`. It has all attributes,
 * morph targets and groups of `from`, with the vertices of the layout.
 */
export function withUv(
  from: BufferGeometry,
  { uv, indices, vertexMap }: Pick<Layout<unknown>, 'uv' | 'indices' | 'vertexMap'>,
  name: string,
): BufferGeometry {
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
export function pick(attribute: Attribute, rows: Uint32Array): BufferAttribute {
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
