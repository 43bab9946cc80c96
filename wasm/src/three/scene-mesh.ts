// The meshes of a scene as one mesh in world space.

import type { BufferGeometry, Material, Mesh } from 'three';
import { AbflatError } from '../base/errors.js';
import { areaOf, type Placement, put, putNormal } from '../base/placement.js';
import type { MeshArrays } from '../types/index.js';
import { meshOf } from './geometry.js';
import { nameOf, type Subject } from './scene-objects.js';

/** The part of the mesh that one geometry makes up. */
export interface ScenePart extends Subject {
  firstVertex: number;
  vertexCount: number;
  /** The corners of the geometry that are drawn, of all. */
  firstCorner: number;
  cornerCount: number;
  /** The first of them in the mesh. */
  firstTriangle: number;
  triangleCount: number;
  /** How much longer lengths are in the world, as a mean over the surface. */
  worldScale: number;
  /** In the world. */
  area: number;
}

export interface SceneMesh extends MeshArrays {
  positions: Float64Array;
  indices: Uint32Array;
  materials: Uint32Array;
  vertexObjects: Uint32Array;
  parts: ScenePart[];
}

interface Piece {
  part: ScenePart;
  positions: Float64Array;
  indices: Uint32Array;
  texcoords?: Float64Array;
  normals?: Float64Array;
  materials: Uint32Array;
}

/** Each geometry is an object. `uvName`: the attribute with texcoords. */
export function sceneMesh(subjects: Subject[], uvName: string): SceneMesh {
  const numbers = new Map<Material | undefined, number>([[undefined, 0]]);
  let [firstVertex, firstTriangle] = [0, 0];
  const pieces = subjects.map((subject) => {
    const piece = pieceOf(subject, { uvName, firstVertex, firstTriangle, numbers });
    firstVertex += piece.part.vertexCount;
    firstTriangle += piece.part.triangleCount;
    return piece;
  });
  const positions = new Float64Array(3 * firstVertex);
  const indices = new Uint32Array(3 * firstTriangle);
  const materials = new Uint32Array(firstTriangle);
  const vertexObjects = new Uint32Array(firstVertex);
  for (const [i, { part, ...piece }] of pieces.entries()) {
    positions.set(piece.positions, 3 * part.firstVertex);
    indices.set(piece.indices, 3 * part.firstTriangle);
    materials.set(piece.materials, part.firstTriangle);
    vertexObjects.fill(i, part.firstVertex, part.firstVertex + part.vertexCount);
  }
  return {
    positions,
    indices,
    ...joined(pieces, 'texcoords', new Float64Array(2 * firstVertex).fill(Number.NaN)),
    ...joined(pieces, 'normals', new Float64Array(3 * firstVertex)),
    materials,
    vertexObjects,
    parts: pieces.map(({ part }) => part),
  };
}

/** An attribute that some pieces have; nothing if none has it. */
function joined(
  pieces: Piece[],
  name: 'texcoords' | 'normals',
  all: Float64Array,
): Pick<MeshArrays, typeof name> {
  if (!pieces.some((piece) => piece[name])) return {};
  const size = name === 'texcoords' ? 2 : 3;
  for (const { part, [name]: own } of pieces) if (own) all.set(own, size * part.firstVertex);
  return { [name]: all };
}

interface At {
  uvName: string;
  firstVertex: number;
  firstTriangle: number;
  /** Of materials, as far as they are known. */
  numbers: Map<Material | undefined, number>;
}

function pieceOf(subject: Subject, { uvName, numbers, ...first }: At): Piece {
  const { geometry, meshes, usage } = subject;
  const mesh = meshes[0] as Mesh;
  const own = meshOf(geometry, uvName, nameOf(mesh)) as MeshArrays & {
    positions: Float64Array;
    indices: Uint32Array;
  };
  const { firstCorner, cornerCount } = drawnOf(geometry, own.indices.length);
  const drawn = own.indices.subarray(firstCorner, firstCorner + cornerCount);
  checkIndices(mesh, drawn, own.positions.length / 3);
  const positions = placed(mesh, own.positions, usage.placement);
  const area = areaOf(positions, drawn);
  const part: ScenePart = {
    ...subject,
    ...first,
    vertexCount: positions.length / 3,
    firstCorner,
    cornerCount,
    triangleCount: cornerCount / 3,
    worldScale: Math.sqrt(area / areaOf(own.positions, drawn)) || 1,
    area,
  };
  return {
    part,
    positions,
    indices: turnedIf(
      usage.placement.isMirrored,
      drawn.map((vertex) => first.firstVertex + vertex),
    ),
    texcoords: own.texcoords as Float64Array | undefined,
    normals: own.normals && placedNormals(own.normals as Float64Array, usage.placement),
    materials: materialsOf(mesh, part, own.materials as Uint32Array | undefined, numbers),
  };
}

/** The corners that `drawRange` leaves. */
function drawnOf({ drawRange }: BufferGeometry, count: number) {
  const firstCorner = Math.min(Math.max(drawRange.start, 0), count);
  const wanted = Math.min(Math.max(drawRange.count, 0), count - firstCorner);
  return { firstCorner, cornerCount: wanted - (wanted % 3) };
}

function checkIndices(mesh: Mesh, indices: Uint32Array, vertexCount: number): void {
  const wrong = indices.findIndex((vertex) => vertex >= vertexCount);
  if (wrong < 0) return;
  throw new AbflatError(
    'InvalidMesh',
    `${nameOf(mesh)}: triangle ${Math.floor(wrong / 3)} refers to vertex ${indices[wrong]}, but there are only ${vertexCount} vertices.`,
  );
}

function placed(mesh: Mesh, positions: Float64Array, { matrix }: Placement): Float64Array {
  const out = new Float64Array(positions.length);
  eachOf(positions, (point, at) => put(point, matrix, out, at));
  const wrong = out.findIndex((x) => !Number.isFinite(x));
  if (wrong < 0) return out;
  throw new AbflatError(
    'InvalidMesh',
    `${nameOf(mesh)}: vertex ${Math.floor(wrong / 3)} has a coordinate that is not finite.`,
  );
}

function placedNormals(normals: Float64Array, placement: Placement): Float64Array {
  const out = new Float64Array(normals.length);
  eachOf(normals, (normal, at) => putNormal(normal, placement, out, at));
  return out;
}

type Triple = [number, number, number];

/** Calls `see` for x, y and z of each vertex, in the same array. */
function eachOf(values: Float64Array, see: (triple: Triple, at: number) => void): void {
  const triple: Triple = [0, 0, 0];
  for (let i = 0; i < values.length; i += 3) {
    for (let d = 0; d < 3; ++d) triple[d] = values[i + d] as number;
    see(triple, i);
  }
}

/** Reverses the winding of triangles, in place. */
export function turnedIf(isMirrored: boolean, triangles: Uint32Array): Uint32Array {
  if (isMirrored)
    for (let c = 0; c < triangles.length; c += 3) triangles.subarray(c + 1, c + 3).reverse();
  return triangles;
}

/** Of the drawn triangles. `groups`: 1 more than the index of each one's material; 0 for none. */
function materialsOf(
  { material }: Mesh,
  { firstCorner, triangleCount }: ScenePart,
  groups: Uint32Array | undefined,
  numbers: At['numbers'],
): Uint32Array {
  const numberOf = (each: Material | undefined) => {
    if (!numbers.has(each)) numbers.set(each, numbers.size);
    return numbers.get(each) as number;
  };
  if (!Array.isArray(material)) return new Uint32Array(triangleCount).fill(numberOf(material));
  const first = Math.floor(firstCorner / 3);
  return Uint32Array.from({ length: triangleCount }, (_, i) =>
    numberOf(material[(groups?.[first + i] ?? 0) - 1]),
  );
}
