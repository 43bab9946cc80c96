// Helper for three.js.

import { BufferAttribute, BufferGeometry } from 'three';
import type { FlattenResult, MeshArrays } from './types.js';

export interface ToBufferGeometryOptions {
  /** Scale and move uv into [0, 1] x [0, 1], keeping its proportions. Default: false, uv in the unit of the mesh. */
  normalize?: boolean;
}

/**
 * Geometry with position, uv, normal (smooth) and index; one vertex per output vertex of `result`.
 * `mesh`: the arrays that were flattened; not needed when a file was, whose positions are in the result.
 */
export function toBufferGeometry(
  result: Pick<FlattenResult, 'uv' | 'indices' | 'vertexMap' | 'positions'>,
  mesh?: Pick<MeshArrays, 'positions'>,
  options: ToBufferGeometryOptions = {},
): BufferGeometry {
  const geometry = new BufferGeometry();
  const uv = options.normalize ? normalized(result.uv) : new Float32Array(result.uv);
  geometry.setAttribute('position', new BufferAttribute(positionsOf(result, mesh), 3));
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  geometry.setIndex(new BufferAttribute(new Uint32Array(result.indices), 1));
  geometry.computeVertexNormals();
  return geometry;
}

function positionsOf(
  { positions, vertexMap }: Pick<FlattenResult, 'positions' | 'vertexMap'>,
  mesh: Pick<MeshArrays, 'positions'> | undefined,
): Float32Array {
  if (positions) return new Float32Array(positions);
  if (!mesh) {
    throw new TypeError(
      'toBufferGeometry needs the mesh when arrays and not a file were flattened.',
    );
  }
  const out = new Float32Array(3 * vertexMap.length);
  vertexMap.forEach((vertex, i) => {
    out.set(mesh.positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i);
  });
  return out;
}

function normalized(uv: Float64Array): Float32Array {
  const least = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const most = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
  uv.forEach((value, i) => {
    least[i % 2] = Math.min(least[i % 2], value);
    most[i % 2] = Math.max(most[i % 2], value);
  });
  const extent = Math.max(most[0] - least[0], most[1] - least[1]);
  return Float32Array.from(uv, (value, i) => (value - least[i % 2]) / extent);
}
