// Writes a layout back into the document that its mesh came from.

import type { Accessor, Document, Primitive } from '@gltf-transform/core';
import { AbflatError } from '../base/errors.js';
import { normalized } from '../base/normalized.js';
import { indexArray, pickRows } from '../base/rows.js';
import { ownFields } from '../messages/fields.js';
import type { Layout } from '../types/index.js';
import { cornersOf, type DocumentMesh, type DocumentPart, turned } from './document-mesh.js';
import { freeTexcoord } from './texture-sets.js';
import { TRIANGLES } from './triangles.js';

export interface SetTexcoordsOptions {
  /**
   * The coordinates become TEXCOORD_`texcoord`; `auto`: the result of `freeTexcoord`. Default: 0.
   */
  texcoord?: number | 'auto';
  /**
   * Scale and move them into [0, 1] x [0, 1]: for layouts in the unit of the mesh, such as those of
   * `flatten`. Default: false.
   */
  normalize?: boolean;
  /**
   * Triangles that the layout has turned (`report.repair.turnedFaces`), ascending; they are turned
   * in the document, too. Default: none.
   */
  turnedFaces?: readonly number[];
}

/**
 * Gives every primitive of a document mesh the coordinates of its layout. A layout of the same
 * triangles with coincident vertices merged works too. Vertices keep their numbers; one with
 * several coordinates is copied to the end, with all its attributes and morph targets. Tangents are
 * copied like the rest and belong to the old coordinates.
 */
export function setTexcoords(
  { document, parts }: Pick<DocumentMesh, 'document' | 'parts'>,
  { uv, indices }: Pick<Layout<unknown>, 'uv' | 'indices'>,
  options: SetTexcoordsOptions = {},
): void {
  const { texcoord = 0, normalize = false, turnedFaces = [] } = ownFields(options);
  checkTriangles(parts, indices);
  const coordinates = normalize ? normalized(uv) : uv;
  const set = texcoord === 'auto' ? freeTexcoord(document) : texcoord;
  const replaced = new Set<Accessor>();
  const turned = new Set(turnedFaces);
  for (const block of blocksOf(parts)) {
    const corners = placeCorners(block, indices, turned);
    const attributes = new Copies(block, replaced);
    const made = document
      .createAccessor()
      .setType('VEC2')
      .setBuffer(block.position.getBuffer())
      .setArray(texcoordsOf(block, coordinates));
    for (const [i, part] of block.parts.entries()) {
      setCoordinates(part.primitive, made, set, replaced);
      attributes.replace(part.primitive, made);
      setIndices(document, part, corners[i] as Uint32Array, block, replaced);
    }
  }
  for (const accessor of replaced) if (!isUsed(accessor)) accessor.dispose();
}

/** A layout has the triangles of its document. */
export function checkTriangles(parts: readonly DocumentPart[], indices: Uint32Array): void {
  const triangles = parts.reduce((sum, { triangleCount }) => sum + triangleCount, 0);
  if (indices.length === 3 * triangles) return;
  throw new AbflatError(
    'InvalidMesh',
    `The layout has ${indices.length / 3} triangles, but the document has ${triangles}.`,
  );
}

/** Parts with the same vertices. */
interface Block {
  position: Accessor;
  vertexCount: number;
  parts: DocumentPart[];
  /**
   * For each row, including copies: the original row, and the vertex of the layout, which is NONE
   * if no triangle uses the row.
   */
  rows: Uint32Array;
  vertices: Uint32Array;
}

const NONE = 2 ** 32 - 1;

function blocksOf(parts: DocumentPart[]): Block[] {
  const blocks = new Map<number, Block>();
  for (const part of parts) {
    const { firstVertex, vertexCount, primitive } = part;
    const known = blocks.get(firstVertex);
    if (known) known.parts.push(part);
    else
      blocks.set(firstVertex, {
        position: primitive.getAttribute('POSITION') as Accessor,
        vertexCount,
        parts: [part],
        rows: Uint32Array.from({ length: vertexCount }, (_, row) => row),
        vertices: new Uint32Array(vertexCount).fill(NONE),
      });
  }
  return [...blocks.values()];
}

/**
 * Completes a block's rows, one for each pair of original row and layout vertex that occurs.
 * Returns the rows of each part's corners.
 */
function placeCorners(
  block: Block,
  indices: Uint32Array,
  turnedFaces: ReadonlySet<number>,
): Uint32Array[] {
  const { vertexCount, vertices } = block;
  const copies = new Map<string, number>();
  const [rows, copied]: [number[], number[]] = [[], []];
  const rowFor = (row: number, vertex: number) => {
    if (vertices[row] === NONE) vertices[row] = vertex;
    if (vertices[row] === vertex) return row;
    const pair = `${row} ${vertex}`;
    const known = copies.get(pair);
    if (known !== undefined) return known;
    const made = vertexCount + rows.length;
    copies.set(pair, made);
    rows.push(row);
    copied.push(vertex);
    return made;
  };
  const corners = block.parts.map(({ primitive, firstTriangle, isMirrored }) => {
    const before = cornersOf(primitive, vertexCount);
    if (isMirrored) turned(before);
    for (let c = 0; c < before.length; c += 3)
      if (turnedFaces.has(firstTriangle + c / 3)) turned(before.subarray(c, c + 3));
    const placed = before.map((row, c) => rowFor(row, indices[3 * firstTriangle + c] as number));
    return isMirrored ? turned(placed) : placed;
  });
  block.rows = Uint32Array.from([...block.rows, ...rows]);
  block.vertices = Uint32Array.from([...vertices, ...copied]);
  return corners;
}

/** glTF measures v from the top. */
function texcoordsOf({ vertices }: Block, uv: ArrayLike<number>): Float32Array<ArrayBuffer> {
  const texcoords = new Float32Array(2 * vertices.length);
  vertices.forEach((vertex, row) => {
    if (vertex === NONE) return;
    texcoords[2 * row] = uv[2 * vertex] as number;
    texcoords[2 * row + 1] = 1 - (uv[2 * vertex + 1] as number);
  });
  return texcoords;
}

/** Copies of a block's attributes with its new rows, one copy per attribute. */
class Copies {
  readonly #made = new Map<Accessor, Accessor>();
  readonly #own = new Set<Accessor>();

  constructor(
    private readonly block: Block,
    private readonly replaced: Set<Accessor>,
  ) {}

  /** All attributes and morph targets except `except`. */
  replace(primitive: Primitive, except: Accessor): void {
    const { rows, vertexCount } = this.block;
    if (rows.length === vertexCount) return;
    for (const owner of [primitive, ...primitive.listTargets()])
      for (const name of owner.listSemantics()) {
        const attribute = owner.getAttribute(name) as Accessor;
        if (attribute !== except && !this.#own.has(attribute))
          owner.setAttribute(name, this.#copy(attribute));
      }
  }

  #copy(attribute: Accessor): Accessor {
    const known = this.#made.get(attribute);
    if (known) return known;
    const array = attribute.getArray() as NonNullable<ReturnType<Accessor['getArray']>>;
    const picked = pickRows(array, this.block.rows, { size: attribute.getElementSize() });
    const made = attribute.clone().setArray(picked);
    this.#made.set(attribute, made);
    this.#own.add(made);
    this.replaced.add(attribute);
    return made;
  }
}

/** Missing sets below the new one get the same coordinates: glTF allows no gaps. */
function setCoordinates(
  primitive: Primitive,
  coordinates: Accessor,
  texcoord: number,
  replaced: Set<Accessor>,
): void {
  const before = primitive.getAttribute(`TEXCOORD_${texcoord}`);
  if (before) replaced.add(before);
  primitive.setAttribute(`TEXCOORD_${texcoord}`, coordinates);
  for (let i = texcoord - 1; i >= 0; --i)
    if (!primitive.getAttribute(`TEXCOORD_${i}`))
      primitive.setAttribute(`TEXCOORD_${i}`, coordinates);
}

/** Writes the triangles as indices, unless the primitive already draws them. */
function setIndices(
  document: Document,
  { primitive, vertexCount }: DocumentPart,
  rows: Uint32Array,
  block: Block,
  replaced: Set<Accessor>,
): void {
  const before = primitive.getIndices();
  const isKept =
    primitive.getMode() === TRIANGLES &&
    (before !== null || block.rows.length === vertexCount) &&
    same(cornersOf(primitive, vertexCount), rows);
  if (isKept) return;
  const made = before?.clone() ?? document.createAccessor().setType('SCALAR');
  const bytes = before?.getComponentSize();
  primitive.setIndices(
    made.setBuffer(block.position.getBuffer()).setArray(indexArray(rows, block.rows.length, bytes)),
  );
  primitive.setMode(TRIANGLES);
  if (before) replaced.add(before);
}

const same = (a: Uint32Array, b: Uint32Array) =>
  a.length === b.length && a.every((x, i) => x === b[i]);

const isUsed = (accessor: Accessor) =>
  accessor.listParents().some(({ propertyType }) => propertyType !== 'Root');
