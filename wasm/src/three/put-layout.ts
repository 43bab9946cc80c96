// Gives a geometry its part of a layout.

import type { BufferGeometry } from 'three';
import type { Layout } from '../types/index.js';
import { withUv } from './geometry.js';
import { type ScenePart, turnedIf } from './scene-mesh.js';

type SceneLayout = Pick<Layout<unknown>, 'uv' | 'indices' | 'vertexMap'>;

/**
 * A new geometry with the coordinates of its part as the attribute `name`. Corners that are not
 * drawn stay, and have the coordinates of a drawn one with their vertex, or else 0.
 */
export function withPartOf(layout: SceneLayout, part: ScenePart, name: string): BufferGeometry {
  const { geometry, firstVertex, firstTriangle, triangleCount, usage } = part;
  const corners = turnedIf(
    usage.placement.isMirrored,
    layout.indices.slice(3 * firstTriangle, 3 * (firstTriangle + triangleCount)),
  );
  const used = [...new Set(corners)].sort((a, b) => a - b);
  const rowOf = new Map(used.map((vertex, row) => [vertex, row]));
  const vertices = used.map((vertex) => (layout.vertexMap[vertex] as number) - firstVertex);
  const uv = used.flatMap((vertex) => [...layout.uv.subarray(2 * vertex, 2 * vertex + 2)]);
  const indices = allCorners(part, vertices);
  indices.set(
    corners.map((vertex) => rowOf.get(vertex) as number),
    part.firstCorner,
  );
  while (uv.length < 2 * vertices.length) uv.push(0);
  const vertexMap = Uint32Array.from(vertices);
  return withUv(geometry, { uv: Float64Array.from(uv), indices, vertexMap }, name);
}

/** Rows of all corners. Adds vertices that no drawn corner has. */
function allCorners({ geometry, firstCorner, cornerCount }: ScenePart, vertices: number[]) {
  const { index } = geometry;
  const count = index?.count ?? geometry.getAttribute('position').count;
  const indices = new Uint32Array(count - (count % 3));
  if (indices.length === cornerCount) return indices;
  const first = new Map<number, number>();
  vertices.forEach((vertex, row) => {
    if (!first.has(vertex)) first.set(vertex, row);
  });
  for (let c = 0; c < indices.length; ++c) {
    if (c >= firstCorner && c < firstCorner + cornerCount) continue;
    const vertex = index ? index.getX(c) : c;
    if (!first.has(vertex)) first.set(vertex, vertices.push(vertex) - 1);
    indices[c] = first.get(vertex) as number;
  }
  return indices;
}
