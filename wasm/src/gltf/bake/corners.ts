// The corners of an atlas, as bake takes them: each a vertex of its own, in the order of the file.

import type { Accessor, Primitive } from '@gltf-transform/core';
import type { BakeLayout, BakeMesh, Layout } from '../../types/index.js';
import { cornersOf, type DocumentPart } from '../document-mesh.js';
import { lookOf, type MapName, type MaterialLook } from './material-look.js';

type Coordinates = Pick<Layout<unknown>, 'uv' | 'indices'>;

/** An atlas before the document has it. */
export interface AtlasCorners {
  parts: DocumentPart[];
  /** Rows of the primitive at the corners of each part. */
  rows: Uint32Array[];
  positions: Float64Array;
  layout: BakeLayout;
}

export function atlasCorners(
  parts: DocumentPart[],
  { uv, indices }: Coordinates,
  turnedFaces: readonly number[],
): AtlasCorners {
  const turned = new Set(turnedFaces);
  const rows = parts.map(({ primitive, vertexCount }) => cornersOf(primitive, vertexCount));
  const layout = { uv: new Float64Array(2 * indices.length), indices: indices.map((_, c) => c) };
  for (const { firstTriangle, triangleCount, isMirrored } of parts)
    for (let f = firstTriangle; f < firstTriangle + triangleCount; ++f) {
      const isSwapped = isMirrored !== turned.has(f);
      for (let k = 0; k < 3; ++k) {
        const at = 3 * f + k;
        const vertex = indices[isSwapped ? other(at, f) : at] as number;
        layout.uv.set(uv.subarray(2 * vertex, 2 * vertex + 2), 2 * at);
      }
      if (turned.has(f)) layout.indices.subarray(3 * f + 1, 3 * f + 3).reverse();
    }
  return { parts, rows, layout, positions: gathered(parts, rows, 'POSITION', 3) };
}

/** The same corner of a triangle whose second and third corners have swapped places. */
const other = (corner: number, face: number) => {
  const k = corner - 3 * face;
  return k === 0 ? corner : 3 * face + 3 - k;
};

/** The mesh with the texcoords of each material's texture for a map. */
export function meshFor(
  { parts, rows, positions }: AtlasCorners,
  map: MapName,
  materials: readonly unknown[],
): BakeMesh {
  const looks = parts.map(({ primitive }) => lookOf(primitive.getMaterial()));
  const texcoords = joinedRows(parts, rows, 2, (_, i) => {
    const use = (looks[i] as MaterialLook).textures[map];
    return use && `TEXCOORD_${use.set}`;
  });
  // glTF measures v from the top.
  for (let i = 1; i < texcoords.length; i += 2) texcoords[i] = 1 - (texcoords[i] as number);
  const perTriangle = (value: (primitive: Primitive, part: number) => number) => {
    const out = new Uint32Array(positions.length / 9);
    for (const [i, { primitive, firstTriangle, triangleCount }] of parts.entries())
      out.fill(value(primitive, i), firstTriangle, firstTriangle + triangleCount);
    return out;
  };
  const mesh: BakeMesh = {
    positions,
    indices: Uint32Array.from({ length: positions.length / 3 }, (_, c) => c),
    texcoords,
    materials: perTriangle((primitive) => materials.indexOf(primitive.getMaterial())),
  };
  if (map === 'baseColor' && haveColours({ parts }))
    return { ...mesh, colours: coloursAt(parts, rows) };
  if (map !== 'normal') return mesh;
  return {
    ...mesh,
    normals: gathered(parts, rows, 'NORMAL', 3),
    // Without normals they mean nothing.
    tangents: joinedRows(parts, rows, 4, (primitive) =>
      primitive.getAttribute('NORMAL') ? 'TANGENT' : undefined,
    ),
    parts: perTriangle((_, i) => i),
  };
}

const COLOURS = 'COLOR_0';

/** Whether a vertex has a colour of its own. */
export const haveColours = ({ parts }: Pick<AtlasCorners, 'parts'>) =>
  parts.some(({ primitive }) => primitive.getAttribute(COLOURS));

/** 1 where there is none. */
function coloursAt(parts: DocumentPart[], rows: Uint32Array[]): Float64Array {
  const out = new Float64Array(4 * cornersIn(rows)).fill(1);
  let at = 0;
  for (const [i, { primitive }] of parts.entries()) {
    const attribute = primitive.getAttribute(COLOURS);
    for (const row of rows[i] as Uint32Array) {
      if (attribute) putColour(attribute, row, out, at);
      at += 4;
    }
  }
  return out;
}

function putColour(attribute: Accessor, row: number, out: Float64Array, at: number): void {
  const values = attribute.getElement(row, [] as number[]);
  for (const [d, value] of values.entries())
    if (Number.isFinite(value)) out[at + d] = Math.min(Math.max(value, 0), 1);
}

const cornersIn = (rows: Uint32Array[]) => rows.reduce((sum, { length }) => sum + length, 0);

const gathered = (parts: DocumentPart[], rows: Uint32Array[], name: string, size: number) =>
  joinedRows(parts, rows, size, () => name);

/** The rows of an attribute at all corners; 0 where there is none, or it is not finite. */
function joinedRows(
  parts: DocumentPart[],
  rows: Uint32Array[],
  size: number,
  nameOf: (primitive: Primitive, part: number) => string | undefined,
): Float64Array {
  const out = new Float64Array(size * cornersIn(rows));
  let at = 0;
  for (const [i, { primitive }] of parts.entries()) {
    const name = nameOf(primitive, i);
    const attribute = name === undefined ? null : primitive.getAttribute(name);
    for (const row of rows[i] as Uint32Array) {
      if (attribute?.getElementSize() === size) putRow(attribute, row, out, at);
      at += size;
    }
  }
  return out;
}

function putRow(attribute: Accessor, row: number, out: Float64Array, at: number): void {
  const values = attribute.getElement(row, [] as number[]);
  for (const [d, value] of values.entries()) out[at + d] = Number.isFinite(value) ? value : 0;
}
