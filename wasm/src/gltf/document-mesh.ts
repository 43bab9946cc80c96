// A glTF-Transform document as one mesh.

import type { Accessor, Document, Material, Mesh, Primitive } from '@gltf-transform/core';
import { AbflatError } from '../base/errors.js';
import { type Placement, put, putNormal } from '../base/placement.js';
import { checkMemory } from '../messages/validate.js';
import type { MeshArrays } from '../types/index.js';
import { Placements } from './placement.js';
import { isOfTriangles, trianglesOf } from './triangles.js';

/** The part of the mesh that one primitive makes up. */
export interface DocumentPart {
  mesh: Mesh;
  primitive: Primitive;
  /**
   * Primitives of a mesh that share their positions also share vertices, unless their texcoords
   * differ.
   */
  firstVertex: number;
  vertexCount: number;
  firstTriangle: number;
  triangleCount: number;
  /**
   * The second and third corners of its triangles are swapped in the mesh, because its node mirrors
   * it.
   */
  isMirrored: boolean;
}

export interface DocumentMesh extends MeshArrays {
  positions: Float64Array;
  indices: Uint32Array;
  /** One set with v measured from the bottom, if any primitive has it. */
  texcoords?: Float64Array;
  /** Shading normals of the vertices, if any primitive has them. */
  normals?: Float64Array;
  materials: Uint32Array;
  /** If there are several meshes: they are objects, which are apart where they touch. */
  vertexObjects?: Uint32Array;
  document: Document;
  parts: DocumentPart[];
  /** What to know about how it was read, one sentence each; `unwrap` adds them to its reports. */
  notes: string[];
}

/** A primitive and the mesh that it is part of. */
export interface Member {
  mesh: Mesh;
  primitive: Primitive;
}

/** All triangle primitives that have positions. */
export function membersOf(document: Document): Member[] {
  const members = new Map<Primitive, Member>();
  for (const mesh of document.getRoot().listMeshes())
    for (const primitive of mesh.listPrimitives())
      if (isOfTriangles(primitive.getMode()) && primitive.getAttribute('POSITION'))
        members.set(primitive, { mesh, primitive });
  return [...members.values()];
}

/**
 * The triangles of a document, or only those of `members`, as one mesh in scene coordinates, with
 * the coordinates of TEXCOORD_`texcoord`. Each mesh is where the node that makes it largest puts it.
 */
export function documentMesh(
  document: Document,
  members = membersOf(document),
  texcoord = 0,
): DocumentMesh {
  const placements = new Placements(document);
  const gathered: Gathered = { positions: [], triangles: [], parts: [] };
  const materialOf = (part: DocumentPart) =>
    document
      .getRoot()
      .listMaterials()
      .indexOf(part.primitive.getMaterial() as Material) + 1;
  const blocks = new Map<Accessor, DocumentPart[]>();
  for (const member of members) {
    const position = member.primitive.getAttribute('POSITION') as Accessor;
    const placement = placements.of(member.mesh);
    const known = blocks.get(position) ?? [];
    blocks.set(position, known);
    const shared = known.find(
      ({ mesh, primitive }) =>
        mesh === member.mesh && fits(primitive, member.primitive, `TEXCOORD_${texcoord}`),
    );
    known.push(gather(document, member, placement, shared, gathered));
  }
  const { parts } = gathered;
  const positions = joined(Float64Array, gathered.positions);
  const texcoords = texcoordsOf(parts, positions.length / 3, `TEXCOORD_${texcoord}`);
  const normals = normalsOf(parts, positions.length / 3, placements);
  const vertexObjects = objectsOf(parts, positions.length / 3);
  return {
    positions,
    indices: joined(Uint32Array, gathered.triangles),
    ...(texcoords && { texcoords }),
    ...(normals && { normals }),
    materials: joined(
      Uint32Array,
      parts.map((part) => new Uint32Array(part.triangleCount).fill(materialOf(part))),
    ),
    ...(vertexObjects && { vertexObjects }),
    document,
    parts,
    notes: placements.notes(parts.map(({ mesh }) => mesh)),
  };
}

interface Gathered {
  positions: Float64Array[];
  triangles: Uint32Array[];
  parts: DocumentPart[];
}

/** Adds a primitive. `shared`: a part with the same vertices. */
function gather(
  document: Document,
  { mesh, primitive }: Member,
  placement: Placement,
  shared: DocumentPart | undefined,
  { positions, triangles, parts }: Gathered,
): DocumentPart {
  const fail = failureOf(document, mesh, primitive);
  const position = primitive.getAttribute('POSITION') as Accessor;
  const vertexCount = position.getCount();
  checkAttributes(primitive, vertexCount, fail);
  const firstVertex = shared?.firstVertex ?? total(positions) / 3;
  if (!shared) positions.push(placed(position, placement, fail));
  const corners = cornersOf(primitive, vertexCount, fail);
  const firstTriangle = total(triangles) / 3;
  triangles.push(inMesh(corners, firstVertex, placement.isMirrored));
  const part = {
    mesh,
    primitive,
    firstVertex,
    vertexCount,
    firstTriangle,
    triangleCount: corners.length / 3,
    isMirrored: placement.isMirrored,
  };
  parts.push(part);
  return part;
}

/** One set, NaN for vertices without it; undefined if no primitive has it. */
function texcoordsOf(
  parts: DocumentPart[],
  vertexCount: number,
  set: string,
): Float64Array | undefined {
  const known = parts.filter(({ primitive }) => primitive.getAttribute(set));
  if (known.length === 0) return undefined;
  const texcoords = new Float64Array(2 * vertexCount).fill(Number.NaN);
  for (const { primitive, firstVertex } of known) {
    const attribute = primitive.getAttribute(set) as Accessor;
    const at: number[] = [];
    for (let row = 0; row < attribute.getCount(); ++row) {
      const [u, v] = attribute.getElement(row, at) as [number, number];
      texcoords.set([u, 1 - v], 2 * (firstVertex + row));
    }
  }
  return texcoords;
}

/** 0 for vertices without a normal; undefined if no primitive has them. */
function normalsOf(
  parts: DocumentPart[],
  vertexCount: number,
  placements: Placements,
): Float64Array | undefined {
  const known = parts.filter(({ primitive }) => primitive.getAttribute('NORMAL'));
  if (known.length === 0) return undefined;
  const normals = new Float64Array(3 * vertexCount);
  for (const { mesh, primitive, firstVertex } of known) {
    const attribute = primitive.getAttribute('NORMAL') as Accessor;
    const placement = placements.of(mesh);
    const at: number[] = [];
    for (let row = 0; row < attribute.getCount(); ++row)
      putNormal(attribute.getElement(row, at), placement, normals, 3 * (firstVertex + row));
  }
  return normals;
}

/** The mesh of each vertex; undefined if there is only one. */
function objectsOf(parts: DocumentPart[], vertexCount: number): Uint32Array | undefined {
  const numbers = new Map([...new Set(parts.map(({ mesh }) => mesh))].map((mesh, i) => [mesh, i]));
  if (numbers.size < 2) return undefined;
  const objects = new Uint32Array(vertexCount);
  for (const { mesh, firstVertex, vertexCount: count } of parts)
    objects.fill(numbers.get(mesh) as number, firstVertex, firstVertex + count);
  return objects;
}

type Fail = (what: string) => AbflatError;

/** For messages. */
export function meshName(document: Document, mesh: Mesh): string {
  const number = document.getRoot().listMeshes().indexOf(mesh);
  const name = mesh.getName() ? ` (${JSON.stringify(mesh.getName())})` : '';
  return `mesh ${number}${name}`;
}

/** Makes errors that name the mesh and the primitive. */
function failureOf(document: Document, mesh: Mesh, primitive: Primitive): Fail {
  const place = `${meshName(document, mesh)}, primitive ${mesh.listPrimitives().indexOf(primitive)}`;
  return (what) => new AbflatError('InvalidMesh', `${place}: ${what}`);
}

function checkAttributes(primitive: Primitive, vertexCount: number, fail: Fail): void {
  const check = (owner: Pick<Primitive, 'listSemantics' | 'getAttribute'>, of: string) => {
    for (const name of owner.listSemantics()) {
      const attribute = owner.getAttribute(name) as Accessor;
      const array = attribute.getArray();
      if (!array) throw fail(`${name}${of} has no data`);
      checkMemory(`${name}${of}`, array);
      if (attribute.getCount() !== vertexCount)
        throw fail(
          `${name}${of} has ${attribute.getCount()} elements, but POSITION has ${vertexCount}`,
        );
    }
  };
  const indices = primitive.getIndices()?.getArray();
  if (indices) checkMemory('The array of indices', indices);
  check(primitive, '');
  primitive.listTargets().forEach((target, i) => {
    check(target, ` of morph target ${i}`);
  });
}

function placed(position: Accessor, { matrix }: Placement, fail: Fail): Float64Array {
  const count = position.getCount();
  const out = new Float64Array(3 * count);
  const point: number[] = [];
  for (let v = 0; v < count; ++v) put(position.getElement(v, point), matrix, out, 3 * v);
  const wrong = out.findIndex((x) => !Number.isFinite(x));
  if (wrong >= 0) throw fail(`vertex ${Math.floor(wrong / 3)} has a coordinate that is not finite`);
  return out;
}

/** Three vertices of the primitive per triangle. */
export function cornersOf(primitive: Primitive, vertexCount: number, fail?: Fail): Uint32Array {
  const indices = primitive.getIndices();
  const array = indices?.getArray() ?? Uint32Array.from({ length: vertexCount }, (_, i) => i);
  const restart = indices ? 2 ** (8 * indices.getComponentSize()) - 1 : Number.NaN;
  const corners = trianglesOf(primitive.getMode(), array, restart);
  const wrong = corners.findIndex((vertex) => vertex >= vertexCount);
  if (wrong >= 0 && fail)
    throw fail(
      `triangle ${Math.floor(wrong / 3)} refers to vertex ${corners[wrong]}, but there are only ${vertexCount} vertices`,
    );
  return corners;
}

function inMesh(corners: Uint32Array, firstVertex: number, isMirrored: boolean): Uint32Array {
  const out = corners.map((vertex) => firstVertex + vertex);
  return isMirrored ? turned(out) : out;
}

/** Reverses the winding of triangles, in place. */
export function turned(triangles: Uint32Array): Uint32Array {
  for (let c = 0; c < triangles.length; c += 3) triangles.subarray(c + 1, c + 3).reverse();
  return triangles;
}

/** Whether one texcoord per vertex is enough for both. */
function fits(a: Primitive, b: Primitive, set: string): boolean {
  const [first, second] = [a.getAttribute(set), b.getAttribute(set)];
  return !first || !second || first === second;
}

const total = (arrays: { length: number }[]) => arrays.reduce((sum, { length }) => sum + length, 0);

function joined<T extends Float64Array | Uint32Array>(
  Kind: new (length: number) => T,
  arrays: T[],
): T {
  const out = new Kind(total(arrays));
  let at = 0;
  for (const array of arrays) {
    out.set(array, at);
    at += array.length;
  }
  return out;
}
