// The layout of several meshes that were joined, as theirs again.

import type { Layout } from '../types/index.js';
import type { Part } from './decl.js';
import { drawnFaces, startsOf } from './join.js';

/** For faces and vertices without a chart. */
export const NONE = -1;

/** Tiles are numbered in rows of ten. */
const COLUMNS = 10;

/** A layout of the drawn faces of all parts, in that order. */
export interface Placed {
  /** Within the tile, 0 to 1. */
  uv: Float64Array;
  vertexMap: Uint32Array;
  indices: Uint32Array;
  chartOfTriangle: Int32Array;
  tileOfTriangle: Int32Array;
}

/** The result for one mesh. */
export interface PartLayout {
  /** 2 per vertex, in texels. */
  uvs: Float64Array;
  /** The input vertex of each. */
  xrefs: Uint32Array;
  indices: Uint32Array;
  tileOfVertex: Int32Array;
  chartOfVertex: Int32Array;
  tileOfFace: Int32Array;
  chartOfFace: Int32Array;
  materialOfFace: Uint32Array;
}

export function placedOf(
  { uv, vertexMap, indices }: Layout<unknown>,
  chartOfTriangle: Uint32Array,
): Placed {
  const within = uv.slice();
  const tiles = new Int32Array(chartOfTriangle.length);
  const charts = Int32Array.from(chartOfTriangle); // 2^32 - 1 becomes NONE
  const isMoved = new Uint8Array(uv.length / 2);
  for (let t = 0; t < tiles.length; ++t) {
    const corners = indices.subarray(3 * t, 3 * t + 3);
    const column = tileOf(uv, corners, 0);
    const row = tileOf(uv, corners, 1);
    tiles[t] = charts[t] === NONE ? NONE : column + COLUMNS * row;
    for (const vertex of corners) {
      if (isMoved[vertex]) continue;
      isMoved[vertex] = 1;
      within[2 * vertex] = (uv[2 * vertex] as number) - column;
      within[2 * vertex + 1] = (uv[2 * vertex + 1] as number) - row;
    }
  }
  return { uv: within, vertexMap, indices, chartOfTriangle: charts, tileOfTriangle: tiles };
}

/** A chart that fills its tile has corners on both of its borders. */
const tileOf = (uv: Float64Array, corners: Uint32Array, axis: 0 | 1) =>
  Math.floor(corners.reduce((sum, vertex) => sum + (uv[2 * vertex + axis] as number), 0) / 3);

/** `side`: texels of an atlas. */
export function splitLayout(parts: readonly Part[], placed: Placed, side: number): PartLayout[] {
  const starts = startsOf(parts);
  let first = 0;
  return parts.map((part, i) => {
    const layout = layoutOf(part, starts[i] as number, placed, first, side);
    first += drawnFaces(part).length;
    return layout;
  });
}

/** `start`: the first vertex of the part, `first`: its first triangle. */
function layoutOf(
  part: Part,
  start: number,
  placed: Placed,
  first: number,
  side: number,
): PartLayout {
  const { indices: given, isDrawn, materials } = part;
  const faces = isDrawn.length;
  const indices = new Uint32Array(given.length);
  const chartOfFace = new Int32Array(faces).fill(NONE);
  const tileOfFace = new Int32Array(faces).fill(NONE);
  const xrefs: number[] = [];
  const uvs: number[] = [];
  const chartOfVertex: number[] = [];
  const tileOfVertex: number[] = [];
  const known = new Map<string | number, number>();
  const add = (key: string | number, xref: number, u: number, v: number, face: number): number => {
    const old = known.get(key);
    if (old !== undefined) return old;
    const vertex = xrefs.length;
    known.set(key, vertex);
    xrefs.push(xref);
    uvs.push(side * u, side * v);
    chartOfVertex.push(chartOfFace[face] as number);
    tileOfVertex.push(tileOfFace[face] as number);
    return vertex;
  };
  let triangle = first;
  for (let face = 0; face < faces; ++face) {
    if (!isDrawn[face]) continue;
    chartOfFace[face] = placed.chartOfTriangle[triangle] as number;
    tileOfFace[face] = placed.tileOfTriangle[triangle] as number;
    for (let k = 0; k < 3; ++k) {
      const at = placed.indices[3 * triangle + k] as number;
      const xref = (placed.vertexMap[at] as number) - start;
      const [u, v] = placed.uv.subarray(2 * at, 2 * at + 2) as unknown as [number, number];
      indices[3 * face + k] = add(at, xref, u, v, face);
    }
    ++triangle;
  }
  for (let face = 0; face < faces; ++face) {
    if (isDrawn[face]) continue;
    for (let k = 0; k < 3; ++k) {
      const vertex = given[3 * face + k] as number;
      indices[3 * face + k] = add(`not drawn ${vertex}`, vertex, 0, 0, face);
    }
  }
  return {
    indices,
    chartOfFace,
    tileOfFace,
    uvs: Float64Array.from(uvs),
    xrefs: Uint32Array.from(xrefs),
    chartOfVertex: Int32Array.from(chartOfVertex),
    tileOfVertex: Int32Array.from(tileOfVertex),
    materialOfFace: materials ?? new Uint32Array(faces),
  };
}
