// The vertices of an FBX: three.js gives every corner its own.

import type { Document, Primitive } from '@gltf-transform/core';
import { type BufferAttribute, Matrix3, type Matrix4, type Mesh, Vector3 } from 'three';
import { weld } from '../mesh/weld';

/** Values of each corner. */
interface Column {
  semantic: string;
  /** Name of the morph target that it belongs to. */
  target: string | null;
  size: number;
  values: Float32Array;
}

const TYPES: Record<number, 'VEC2' | 'VEC3' | 'VEC4'> = { 2: 'VEC2', 3: 'VEC3', 4: 'VEC4' };

/** `moved`: from the coordinates of the geometry to those of the glTF's mesh. */
export function columnsOf({ geometry }: Mesh, moved: Matrix4 | null): Column[] {
  const { attributes, morphAttributes } = geometry;
  const columns: Column[] = [];
  const add = (
    semantic: string,
    attribute: { array: ArrayLike<number>; itemSize: number },
    change?: (values: Float32Array) => void,
    target: string | null = null,
  ) => {
    const values = Float32Array.from(attribute.array);
    change?.(values);
    columns.push({ semantic, target, size: attribute.itemSize, values });
  };
  const linear = moved && new Matrix3().setFromMatrix4(moved);
  add('POSITION', attributes.position, moved ? each((v) => v.applyMatrix4(moved)) : undefined);
  if (attributes.normal) {
    const turned = moved && new Matrix3().getNormalMatrix(moved);
    add(
      'NORMAL',
      attributes.normal,
      each((v) => unit(turned ? v.applyMatrix3(turned) : v)),
    );
  }
  for (let set = 0; attributes[setName(set)]; ++set)
    add(`TEXCOORD_${set}`, attributes[setName(set)], fromTop);
  if (attributes.color) add('COLOR_0', attributes.color);
  if (attributes.skinIndex) add('JOINTS_0', attributes.skinIndex);
  if (attributes.skinWeight) add('WEIGHTS_0', attributes.skinWeight);
  for (const attribute of (morphAttributes.position ?? []) as BufferAttribute[])
    add(
      'POSITION',
      attribute,
      linear ? each((v) => v.applyMatrix3(linear)) : undefined,
      attribute.name,
    );
  return columns;
}

const setName = (set: number) => (set === 0 ? 'uv' : `uv${set}`);

/** That of glTF points down. */
function fromTop(values: Float32Array): void {
  for (let i = 1; i < values.length; i += 2) values[i] = 1 - values[i];
}

const each = (change: (v: Vector3) => Vector3) => (values: Float32Array) => {
  const v = new Vector3();
  for (let i = 0; i < values.length; i += 3) change(v.fromArray(values, i)).toArray(values, i);
};

const unit = (v: Vector3) => (v.lengthSq() > 0 ? v.normalize() : v.set(0, 0, 1));

/** A primitive with some corners, of which those that are alike in everything share a vertex. */
export function primitiveOf(document: Document, columns: Column[], corners: number[]): Primitive {
  const buffer = document.getRoot().listBuffers()[0];
  const first = weld(rowsOf(columns, corners), width(columns));
  const numbers = new Map<number, number>();
  const indices = Uint32Array.from(first, (row) => {
    const known = numbers.get(row) ?? numbers.size;
    numbers.set(row, known);
    return known;
  });
  const vertices = [...numbers.keys()].map((row) => corners[row]);
  const accessor = () => document.createAccessor().setBuffer(buffer);
  const primitive = document.createPrimitive().setIndices(
    // The largest index would restart a primitive.
    accessor().setArray(vertices.length < 2 ** 16 ? new Uint16Array(indices) : indices),
  );
  for (const { semantic, target, size, values } of columns) {
    const array = gathered(values, size, vertices);
    const own = accessor()
      .setType(TYPES[size])
      .setArray(semantic === 'JOINTS_0' ? new Uint16Array(array) : array);
    if (target === null) primitive.setAttribute(semantic, own);
    else primitive.addTarget(document.createPrimitiveTarget(target).setAttribute(semantic, own));
  }
  return primitive;
}

const width = (columns: Column[]) => columns.reduce((sum, { size }) => sum + size, 0);

function rowsOf(columns: Column[], corners: number[]): Float64Array {
  const all = width(columns);
  const rows = new Float64Array(corners.length * all);
  let before = 0;
  for (const { size, values } of columns) {
    for (const [row, corner] of corners.entries())
      for (let d = 0; d < size; ++d) rows[row * all + before + d] = values[corner * size + d];
    before += size;
  }
  return rows;
}

function gathered(values: Float32Array, size: number, at: number[]): Float32Array<ArrayBuffer> {
  const out = new Float32Array(size * at.length);
  for (const [row, corner] of at.entries())
    for (let d = 0; d < size; ++d) out[size * row + d] = values[size * corner + d];
  return out;
}
