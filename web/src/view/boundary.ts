import { Color } from 'three';
import type { Palette } from '../colors/palette';
import type { VertexBounds } from '../mesh/vertex-bounds';
import type { FlatDrawing } from '../model/drawing';

/** The vertices of a disk's boundary, and where they are in both views: xyz each. */
export interface Boundary {
  vertices: Uint32Array;
  mesh: Float32Array;
  layout: Float32Array;
}

export function boundaryOf({ boundary, mesh, layout }: FlatDrawing): Boundary {
  return { vertices: boundary, mesh: starts(mesh.edges), layout: starts(layout.edges) };
}

/** Where each edge begins. */
function starts(edges: Float32Array): Float32Array {
  const points = new Float32Array(edges.length / 2);
  for (let e = 0; 6 * e < edges.length; ++e) points.set(edges.subarray(6 * e, 6 * e + 3), 3 * e);
  return points;
}

export interface BoundMarks {
  mesh: Float32Array;
  layout: Float32Array;
  tints: Float32Array;
}

export const NO_BOUND_MARKS: BoundMarks = {
  mesh: new Float32Array(),
  layout: new Float32Array(),
  tints: new Float32Array(),
};

/** The vertices that have a bound of their own, in its colour. */
export function boundMarks(
  { vertices, mesh, layout }: Boundary,
  bounds: VertexBounds,
  palette: Palette,
): BoundMarks {
  const all = new Map(bounds.map(({ vertex, t }) => [vertex, t]));
  const places = [...vertices.keys()].filter((i) => all.has(vertices[i]));
  const at = (points: Float32Array) =>
    Float32Array.from(places.flatMap((i) => [...points.subarray(3 * i, 3 * i + 3)]));
  const tints = places.flatMap((i) => boundColor(all.get(vertices[i]) ?? 0, palette).toArray());
  return { mesh: at(mesh), layout: at(layout), tints: Float32Array.from(tints) };
}

/** From convex or less to free. */
function boundColor(t: number, { twoSided: [less, , more] }: Palette): Color {
  return new Color().lerpColors(more, less, Math.min(1, Math.max(0, t - 1)));
}
