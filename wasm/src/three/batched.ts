// The geometries of a BatchedMesh, which are ranges of one geometry, and their instances.

import { type BatchedMesh, BufferAttribute, BufferGeometry, Matrix4, type Mesh } from 'three';
import { AbflatError } from '../base/errors.js';
import type { Matrix } from '../base/placement.js';
import { indexArray } from '../base/rows.js';
import { pick } from './geometry.js';

/** One of the geometries, as a geometry of its own, and where it is drawn, in the world. */
export interface Batched {
  geometryId: number;
  geometry: BufferGeometry;
  places: Matrix[];
}

export const isBatched = (mesh: Mesh): mesh is BatchedMesh => 'isBatchedMesh' in mesh;

/** The geometries with visible instances, in order. */
export function batchedOf(mesh: BatchedMesh): Batched[] {
  const places = new Map<number, Matrix[]>();
  for (const instance of visibleInstances(mesh)) {
    const id = mesh.getGeometryIdAt(instance);
    const matrix = mesh.getMatrixAt(instance, new Matrix4()).premultiply(mesh.matrixWorld);
    places.set(id, [...(places.get(id) ?? []), matrix.elements]);
  }
  return [...places]
    .sort(([a], [b]) => a - b)
    .map(([geometryId, its]) => ({
      geometryId,
      geometry: geometryAt(mesh, geometryId),
      places: its,
    }));
}

/** There may be gaps between their numbers, where instances were deleted. */
function visibleInstances(mesh: BatchedMesh): number[] {
  const out: number[] = [];
  let left = mesh.instanceCount;
  for (let instance = 0; left > 0 && instance < mesh.maxInstanceCount; ++instance) {
    const isVisible = visibilityAt(mesh, instance);
    if (isVisible === undefined) continue;
    --left;
    if (isVisible) out.push(instance);
  }
  return out;
}

/** Undefined if there is no such instance, which only an error tells. */
function visibilityAt(mesh: BatchedMesh, instance: number): boolean | undefined {
  try {
    return mesh.getVisibleAt(instance);
  } catch {
    return undefined;
  }
}

function geometryAt(mesh: BatchedMesh, geometryId: number): BufferGeometry {
  const { vertexStart, vertexCount, start, count } = rangeOf(mesh, geometryId);
  const out = new BufferGeometry();
  const rows = Uint32Array.from({ length: vertexCount }, (_, i) => vertexStart + i);
  for (const [name, attribute] of Object.entries(mesh.geometry.attributes))
    out.setAttribute(name, pick(attribute, rows));
  const { index } = mesh.geometry;
  if (!index) return out;
  const corners = Uint32Array.from(
    { length: count },
    (_, i) => index.getX(start + i) - vertexStart,
  );
  return out.setIndex(new BufferAttribute(indexArray(corners, vertexCount), 1));
}

const rangeOf = (mesh: BatchedMesh, geometryId: number) =>
  mesh.getGeometryRangeAt(geometryId) as NonNullable<ReturnType<BatchedMesh['getGeometryRangeAt']>>;

/** As the mesh keeps its geometries: with an index, or without. */
export const likeBatched = (mesh: BatchedMesh, geometry: BufferGeometry): BufferGeometry =>
  mesh.geometry.index ? geometry : geometry.toNonIndexed();

/** Refuses a geometry that does not fit where the one before it is. */
export function checkRoom(mesh: BatchedMesh, geometryId: number, geometry: BufferGeometry): void {
  const { count } = geometry.getAttribute('position');
  const { reservedVertexCount } = rangeOf(mesh, geometryId);
  if (count <= reservedVertexCount) return;
  throw new AbflatError(
    'InvalidMesh',
    `the mesh ${JSON.stringify(mesh.name || mesh.uuid)}: with its seams, geometry ${geometryId} of the BatchedMesh has ${count} vertices, and there is room for ${reservedVertexCount}. ` +
      'Reserve more with addGeometry(geometry, reservedVertexCount), unwrap it before it is added, or set assign: false.',
  );
}

/** Puts a geometry in its range; `name`: the attribute that is new. */
export function assignBatched(
  mesh: BatchedMesh,
  geometryId: number,
  geometry: BufferGeometry,
  name: string,
): void {
  const all = mesh.geometry;
  const vertexCount = all.getAttribute('position').count;
  if (!all.hasAttribute(name))
    all.setAttribute(name, new BufferAttribute(new Float32Array(2 * vertexCount), 2));
  mesh.setGeometryAt(geometryId, geometry);
}
