// Helpers for three.js.

import { BufferAttribute, BufferGeometry } from 'three';
import { AbflatError } from './base/errors.js';
import { normalized } from './base/normalized.js';
import { pickRows } from './base/rows.js';
import { ownFields } from './messages/fields.js';
import type { Layout, MeshArrays } from './types/index.js';

export type { Weights } from './messages/weights.js';
export { type PackGeometryOptions, packGeometry } from './pack-geometry.js';
export type { Preset, PresetOptions } from './preset.js';
export { type UnwrapGeometryOptions, unwrapGeometry } from './unwrap-geometry.js';
export {
  type UnwrappedMesh,
  type UnwrappedScene,
  type UnwrapSceneOptions,
  unwrapScene,
} from './unwrap-scene.js';
export { type VerifyGeometryOptions, verifyGeometry } from './verify-geometry.js';

export interface ToBufferGeometryOptions {
  /**
   * Scale and move uv into [0, 1] x [0, 1], keeping its proportions. Default: false, which leaves
   * uv in the unit of the mesh.
   */
  normalize?: boolean;
}

/**
 * A geometry with position, uv, normal (smooth) and index, and one vertex per output vertex of
 * `result`. `mesh`: the input arrays; not needed for a file, whose positions are in the result.
 */
export function toBufferGeometry(
  result: Pick<Layout<unknown>, 'uv' | 'indices' | 'vertexMap' | 'positions'>,
  mesh?: Pick<MeshArrays, 'positions'>,
  options: ToBufferGeometryOptions = {},
): BufferGeometry {
  const geometry = new BufferGeometry();
  const uv = ownFields(options).normalize ? normalized(result.uv) : new Float32Array(result.uv);
  const positions = positionsOf(result, mesh);
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  geometry.setAttribute('normal', new BufferAttribute(smoothNormals(positions, result), 3));
  geometry.setIndex(new BufferAttribute(new Uint32Array(result.indices), 1));
  return geometry;
}

/** The same for all output vertices of an input vertex: the surface is smooth across seams. */
function smoothNormals(
  positions: Float32Array,
  { indices, vertexMap }: Pick<Layout<unknown>, 'indices' | 'vertexMap'>,
): Float32Array {
  const first = new Map<number, number>();
  const shared = vertexMap.map((vertex, i) => {
    const known = first.get(vertex);
    if (known !== undefined) return known;
    first.set(vertex, i);
    return i;
  });
  const surface = new BufferGeometry();
  surface.setAttribute('position', new BufferAttribute(positions, 3));
  surface.setIndex(
    new BufferAttribute(
      indices.map((i) => shared[i] as number),
      1,
    ),
  );
  surface.computeVertexNormals();
  const { array } = surface.getAttribute('normal');
  const normals = new Float32Array(positions.length);
  shared.forEach((from, i) => {
    for (let k = 0; k < 3; ++k) normals[3 * i + k] = array[3 * from + k] as number;
  });
  return normals;
}

function positionsOf(
  result: Pick<Layout<unknown>, 'positions' | 'vertexMap'>,
  mesh: Pick<MeshArrays, 'positions'> | undefined,
): Float32Array {
  const { positions, vertexMap } = ownFields(result);
  if (positions) return new Float32Array(positions);
  if (!mesh) {
    throw new AbflatError(
      'InvalidMesh',
      'toBufferGeometry needs the mesh if it was given as arrays, not as a file.',
    );
  }
  return pickRows(new Float32Array(mesh.positions), vertexMap, { size: 3 });
}
