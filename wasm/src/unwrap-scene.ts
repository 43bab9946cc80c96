// Unwraps all meshes of a three.js scene into one atlas.

import type { BufferGeometry, Mesh, Object3D } from 'three';
import { AbflatError } from './base/errors.js';
import { fieldOf, ownFields } from './messages/fields.js';
import { neededFor } from './messages/needed-arrays.js';
import { checkAbflat, checkBoolean, checkString, optionsOf } from './messages/validate.js';
import { checkWeights, densitiesFor, type Weights } from './messages/weights.js';
import { checkPages, layPages, type PageOptions, pagesNote, type Sized } from './pages.js';
import { type PresetOptions, withPreset } from './preset.js';
import { assignBatched, checkRoom, isBatched, likeBatched } from './three/batched.js';
import { withPartOf } from './three/put-layout.js';
import { type SceneMesh, type ScenePart, sceneMesh } from './three/scene-mesh.js';
import { type Subject, sharingNotes, subjectsBelow } from './three/scene-objects.js';
import type { AnyAbflat, UnwrapResult } from './types/index.js';
import type { UnwrapGeometryOptions } from './unwrap-geometry.js';

/** Numbers of faces and vertices mean nothing in a scene. */
type OfOneGeometry =
  | 'seamEdges'
  | 'fixedFaces'
  | 'fixedCharts'
  | 'faceDensities'
  | 'pins'
  | 'known'
  | 'keepsPlaces';

export interface UnwrapSceneOptions
  extends PresetOptions,
    Omit<UnwrapGeometryOptions, OfOneGeometry> {
  /** Name of the attribute for the new coordinates. Default: `uv1`, which light maps read. */
  attribute?: string;
  /** `uv`: what geometries have in `readAttribute` stays exactly as it is. */
  fixedFaces?: 'uv';
  /**
   * Texel densities of meshes relative to the others, from 0.001 to 1000, as a Map or a function; 1
   * where there is none. 0 leaves a mesh out. Meshes that share texels have the largest of theirs.
   */
  weights?: Weights<Mesh>;
  /**
   * Meshes that share a geometry each get one of their own, with texels of its own, as light maps
   * need. Default: false, they go on sharing one, and true with a preset.
   */
  ownTexels?: boolean;
  /**
   * So many atlases of equal size, at one texel density. Each mesh lies on one of them as a whole,
   * and pages are filled about alike. Default: 1.
   */
  pages?: number;
  /** Whether meshes get their new geometries. Default: true. */
  assign?: boolean;
}

export interface UnwrappedScene {
  /** One for each page. */
  results: UnwrapResult[];
  /** The first of them, which is all without `pages`. */
  result: UnwrapResult;
  meshes: UnwrappedMesh[];
}

/** What a mesh of the scene gets. */
export interface UnwrappedMesh {
  mesh: Mesh;
  /** Which geometry of a BatchedMesh this is; not there for other meshes. */
  geometryId?: number;
  /** With the new coordinates. */
  geometry: BufferGeometry;
  /** The one that the mesh had, which may be disposed of if nothing else uses it. */
  previous: BufferGeometry;
  /** The number of its atlas among `results`. */
  page: number;
  /** Its triangles in the arrays of that result, which are those that it draws, in order. */
  firstTriangle: number;
  triangleCount: number;
  /** How much longer lengths are in the world, where its layout is sized: a mean over the surface. */
  worldScale: number;
}

/**
 * All visible meshes of an object and those below it in one atlas, or in several with `pages`, at
 * one texel density in world space. Meshes are apart even where they touch. Once everything has
 * succeeded, meshes get new geometries, with what unwrapGeometry keeps; those that shared one go on
 * sharing one unless `ownTexels` is set.
 */
export async function unwrapScene(
  abflat: AnyAbflat<'unwrap'>,
  object: Object3D,
  settings: UnwrapSceneOptions = {},
): Promise<UnwrappedScene> {
  checkAbflat(abflat, 'unwrap');
  const own = optionsOf(settings);
  const { weights, assign = true, ownTexels = own.preset !== undefined, pages, ...named } = own;
  const { attribute = 'uv1', readAttribute = usualSource(own), ...others } = ownFields(named);
  check(object, { ...named, weights, assign, ownTexels, attribute, readAttribute });
  const options = withPreset(others);
  checkPages(pages, options);
  const subjects = subjectsBelow(object, weights, ownTexels);
  const scene = sceneMesh(subjects, readAttribute);
  if (scene.indices.length === 0)
    throw new AbflatError(
      'EmptyMesh',
      'No visible mesh at or below the object has triangles to unwrap.',
    );
  const partsOf = new Map<UnwrapResult, ScenePart[]>();
  const lay = async ({ parts, ...mesh }: SceneMesh, more: PageOptions = {}) => {
    const densities = densitiesFor(parts);
    const all = { ...options, ...more };
    const found = await abflat.unwrap(neededFor(all, mesh), {
      ...all,
      ...(densities && { faceDensities: densities }),
      transfer: true,
    });
    partsOf.set(found, parts);
    return found;
  };
  const results =
    pages === undefined
      ? [await lay(scene)]
      : await layPages(sizedOf(subjects, scene), pages, options, (each, more) =>
          lay(sceneMesh(each.flat(), readAttribute), more),
        );
  const result = results[0] as UnwrapResult;
  result.report.notes.unshift(
    ...pagesNote(pages ?? 1, results.length, 'meshes'),
    ...sharingNotes(subjects, ownTexels),
  );
  const meshes = results.flatMap((each, page) =>
    (partsOf.get(each) as ScenePart[]).flatMap((part) =>
      unwrappedOf(part, page, withPartOf(each, part, attribute)),
    ),
  );
  if (assign) assignAll(meshes, attribute);
  return { results, result, meshes };
}

/** What lies on one page as a whole: all geometries of a BatchedMesh, which has one material. */
function sizedOf(subjects: Subject[], { parts }: SceneMesh): Sized<Subject[]>[] {
  const groups = new Map<unknown, Sized<Subject[]>>();
  for (const [i, subject] of subjects.entries()) {
    const { area, weight } = parts[i] as ScenePart;
    const key = subject.geometryId === undefined ? subject : subject.meshes[0];
    const group = groups.get(key) ?? { thing: [], size: 0 };
    group.thing.push(subject);
    group.size += area * weight * weight;
    groups.set(key, group);
  }
  return [...groups.values()];
}

/** All of them, or none if one has no room. */
function assignAll(meshes: readonly UnwrappedMesh[], attribute: string): void {
  for (const { mesh, geometry, geometryId } of meshes)
    if (isBatched(mesh)) checkRoom(mesh, geometryId as number, geometry);
  for (const { mesh, geometry, geometryId } of meshes)
    if (isBatched(mesh)) assignBatched(mesh, geometryId as number, geometry, attribute);
    else mesh.geometry = geometry;
}

/** What is kept comes from the attribute that is written. */
const usualSource = ({ fixedFaces, attribute = 'uv1' }: UnwrapSceneOptions) =>
  fixedFaces === undefined ? 'uv' : attribute;

function check(object: unknown, options: UnwrapSceneOptions): void {
  const { weights, assign, ownTexels, attribute, readAttribute, fixedFaces } = ownFields(options);
  const invalid = (message: string) => new AbflatError('InvalidOption', message);
  if (!fieldOf(object, 'isObject3D'))
    throw new AbflatError('InvalidMesh', 'unwrapScene needs an Object3D, such as a scene.');
  checkString('attribute', attribute);
  checkString('readAttribute', readAttribute);
  checkBoolean('assign', assign);
  checkBoolean('ownTexels', ownTexels);
  checkWeights(weights);
  if (fixedFaces !== undefined && fixedFaces !== 'uv')
    throw invalid("fixedFaces must be 'uv' for a scene.");
  const unknown = OF_ONE_GEOMETRY.find((name) => Object.hasOwn(options, name));
  if (unknown) throw invalid(`unwrapScene does not take ${unknown}, which is for one geometry.`);
}

const OF_ONE_GEOMETRY = [
  'seamEdges',
  'fixedCharts',
  'faceDensities',
  'pins',
  'known',
  'keepsPlaces',
] as const satisfies OfOneGeometry[];

function unwrappedOf(part: ScenePart, page: number, made: BufferGeometry): UnwrappedMesh[] {
  const { firstTriangle, triangleCount, worldScale, geometry: previous, geometryId } = part;
  return part.meshes.map((mesh) => ({
    mesh,
    ...(geometryId !== undefined && { geometryId }),
    geometry: isBatched(mesh) ? likeBatched(mesh, made) : made,
    previous,
    page,
    firstTriangle,
    triangleCount,
    worldScale,
  }));
}
