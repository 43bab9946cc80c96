// Which meshes of a scene are drawn, and where.

import { type BufferGeometry, type InstancedMesh, Matrix4, type Mesh, type Object3D } from 'three';
import { type Matrix, type Usage, usedAt } from '../base/placement.js';
import { type Weights, weightOf } from '../messages/weights.js';
import { batchedOf, isBatched } from './batched.js';

/** A geometry as it is laid out, and the meshes that get the layout. */
export interface Subject {
  meshes: Mesh[];
  geometry: BufferGeometry;
  usage: Usage;
  /** The texel density wanted for it, relative to that of others. */
  weight: number;
  /** Of a BatchedMesh: which of its geometries this is. */
  geometryId?: number;
}

/** For messages. */
export const nameOf = (mesh: Mesh) =>
  mesh.name ? `the mesh ${JSON.stringify(mesh.name)}` : `the mesh ${mesh.uuid}`;

/** What is drawn of each geometry; once for all of its meshes, or once for each. */
export function subjectsBelow(
  object: Object3D,
  weights: Weights<Mesh> | undefined,
  ownTexels: boolean,
): Subject[] {
  object.updateWorldMatrix(true, true);
  const subjects = new Map<Mesh | BufferGeometry, Subject>();
  object.traverseVisible((child) => {
    if (!(child as Partial<Mesh>).isMesh) return;
    const mesh = child as Mesh;
    const weight = weightOf(mesh, weights, () => nameOf(mesh));
    if (weight === 0) return;
    if (isBatched(mesh)) {
      for (const { geometryId, geometry, places } of batchedOf(mesh)) {
        const usage = usageOf(places) as Usage;
        subjects.set(geometry, { meshes: [mesh], geometry, usage, weight, geometryId });
      }
      return;
    }
    const key = ownTexels ? mesh : mesh.geometry;
    const known = subjects.get(key);
    const usage = usageOf(placesOf(mesh), known?.usage);
    if (!usage) return; // no instance
    subjects.set(key, {
      meshes: [...(known?.meshes ?? []), mesh],
      geometry: mesh.geometry,
      usage,
      weight: Math.max(weight, known?.weight ?? 0),
    });
  });
  return [...subjects.values()];
}

/** Undefined if there are no places. */
const usageOf = (places: (Matrix | undefined)[], known?: Usage) =>
  places.reduce((before: Usage | undefined, matrix) => usedAt(matrix, before), known);

/** Undefined stands for a place where vertices stay as they are, as bones move those of a skin. */
function placesOf(mesh: Mesh): (Matrix | undefined)[] {
  if ('isSkinnedMesh' in mesh) return [undefined];
  if (!('isInstancedMesh' in mesh)) return [mesh.matrixWorld.elements];
  const instances = mesh as InstancedMesh;
  return Array.from({ length: instances.count }, (_, i) => {
    const own = new Matrix4();
    instances.getMatrixAt(i, own);
    return own.premultiply(mesh.matrixWorld).elements;
  });
}

/** Which geometries are in several places, in one note. */
export function sharingNotes(subjects: readonly Subject[], ownTexels: boolean): string[] {
  const shared = subjects.filter(({ usage }) => usage.places > 1);
  if (shared.length === 0) return [];
  const places = shared.reduce((sum, { usage }) => sum + usage.places, 0);
  const what = ownTexels ? 'instances' : 'meshes and instances';
  const of = shared.length === 1 ? '1 geometry and its' : `${shared.length} geometries and their`;
  const scales = shared.some(({ usage }) => usage.hasScales)
    ? '. Their scales differ, so each layout is sized for the largest'
    : '';
  const advice = ownTexels
    ? '. Instances share the geometry of their mesh, so only separate meshes can have texels of their own'
    : '. With the option ownTexels each mesh gets texels of its own';
  return [`${places} ${what} share ${of} texels${scales}${advice}`];
}
