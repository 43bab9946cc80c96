// A layout back into the document that its mesh came from.

import type { Accessor, Document, Primitive } from '@gltf-transform/core';
import { normalized } from '../normalized.js';
import { indexArray, pickRows } from '../rows.js';
import type { Layout } from '../types.js';
import { cornersOf, type DocumentMesh, type DocumentPart, turned } from './document-mesh.js';
import { TRIANGLES } from './triangles.js';

export interface SetTexcoordsOptions {
  /** The coordinates become TEXCOORD_`texcoord`. Default: 0. */
  texcoord?: number;
  /** Scale and move them into [0, 1] x [0, 1]: for layouts in the unit of the mesh, as of `flatten`. Default: false. */
  normalize?: boolean;
}

/**
 * Gives every primitive of a document mesh the coordinates of its layout. Vertices keep their numbers; one that
 * has several coordinates is copied to the end, with all its attributes and morph targets. Tangents are copied like the rest and belong
 * to the coordinates before.
 */
export function setTexcoords(
  { document, parts }: Pick<DocumentMesh, 'document' | 'parts'>,
  layout: Pick<Layout<unknown>, 'uv' | 'indices' | 'vertexMap'>,
  { texcoord = 0, normalize = false }: SetTexcoordsOptions = {},
): void {
  const blocks = blocksOf(parts);
  const uv = normalize ? normalized(layout.uv) : layout.uv;
  const rowOf = placeVertices(blocks, layout.vertexMap, uv);
  const replaced = new Set<Accessor>();
  for (const block of blocks) {
    const attributes = new Copies(block, replaced);
    const coordinates = document
      .createAccessor()
      .setType('VEC2')
      .setBuffer(block.position.getBuffer())
      .setArray(block.texcoords);
    for (const part of block.parts) {
      setCoordinates(part.primitive, coordinates, texcoord, replaced);
      attributes.replace(part.primitive, coordinates);
      const first = 3 * part.firstTriangle;
      const corners = layout.indices.slice(first, first + 3 * part.triangleCount);
      const rows = corners.map((vertex) => rowOf[vertex] as number);
      setIndices(document, part, part.isMirrored ? turned(rows) : rows, block, replaced);
    }
  }
  for (const accessor of replaced) if (!isUsed(accessor)) accessor.dispose();
}

/** Parts with the same vertices. */
interface Block {
  position: Accessor;
  firstVertex: number;
  vertexCount: number;
  parts: DocumentPart[];
  /** The row before of each row. */
  rows: Uint32Array;
  texcoords: Float32Array<ArrayBuffer>;
}

function blocksOf(parts: DocumentPart[]): Block[] {
  const blocks = new Map<number, Block>();
  for (const part of parts) {
    const { firstVertex, vertexCount, primitive } = part;
    const known = blocks.get(firstVertex);
    if (known) known.parts.push(part);
    else
      blocks.set(firstVertex, {
        position: primitive.getAttribute('POSITION') as Accessor,
        firstVertex,
        vertexCount,
        parts: [part],
        rows: new Uint32Array(),
        texcoords: new Float32Array(),
      });
  }
  return [...blocks.values()];
}

/** Completes the blocks and tells the row, inside its block, of each vertex of the layout. */
function placeVertices(
  blocks: Block[],
  vertexMap: Uint32Array,
  uv: Float64Array | Float32Array,
): Uint32Array {
  const rowOf = new Uint32Array(vertexMap.length);
  const verticesOf = byBlock(blocks, vertexMap);
  blocks.forEach((block, b) => {
    const { firstVertex, vertexCount } = block;
    const isPlaced = new Uint8Array(vertexCount);
    const copied: number[] = [];
    const vertices = verticesOf[b] as number[];
    for (const vertex of vertices) {
      const row = (vertexMap[vertex] as number) - firstVertex;
      rowOf[vertex] = isPlaced[row] ? vertexCount + copied.length : row;
      if (isPlaced[row]) copied.push(row);
      isPlaced[row] = 1;
    }
    block.rows = Uint32Array.from({ length: vertexCount + copied.length }, (_, i) =>
      i < vertexCount ? i : (copied[i - vertexCount] as number),
    );
    block.texcoords = new Float32Array(2 * block.rows.length);
    for (const vertex of vertices) {
      const row = 2 * (rowOf[vertex] as number);
      block.texcoords[row] = uv[2 * vertex] as number;
      // That of glTF points down.
      block.texcoords[row + 1] = 1 - (uv[2 * vertex + 1] as number);
    }
  });
  return rowOf;
}

/** The vertices of the layout that each block has. */
function byBlock(blocks: Block[], vertexMap: Uint32Array): number[][] {
  const blockOf = new Uint32Array(
    blocks.reduce((most, block) => Math.max(most, block.firstVertex + block.vertexCount), 0),
  );
  blocks.forEach(({ firstVertex, vertexCount }, b) => {
    blockOf.fill(b, firstVertex, firstVertex + vertexCount);
  });
  const vertices: number[][] = blocks.map(() => []);
  vertexMap.forEach((from, vertex) => {
    vertices[blockOf[from] as number]?.push(vertex);
  });
  return vertices;
}

/** Copies of a block's attributes with its new rows, one of each. */
class Copies {
  readonly #made = new Map<Accessor, Accessor>();
  readonly #own = new Set<Accessor>();

  constructor(
    private readonly block: Block,
    private readonly replaced: Set<Accessor>,
  ) {}

  /** All attributes and morph targets but `except`. */
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

/** A set that is missing below the new one takes the same: glTF allows no gaps. */
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

/** Triangles, by indices where they differ from those before. */
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
