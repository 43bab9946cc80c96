import { pointsAround } from '../seams/brush';
import type { Solid } from '../surface/solid';
import type { Pixel } from '../view/sight';
import type { ViewName, Views } from '../view/views';
import { RADIUS } from './brush';

/** The vertices of the boundary that a brush touches. `solid`: the mesh on screen, if there is one. */
export function boundaryUnder(
  views: Views,
  solid: Solid | null,
  view: ViewName,
  at: Pixel,
): Set<number> {
  const { boundary } = views;
  if (!boundary) return new Set();
  const { vertices } = boundary;
  if (view === 'layout') {
    const isNear = (i: number) => {
      const { x, y } = views.layoutPixel(boundary, i);
      return Math.hypot(x - at.x, y - at.y) <= RADIUS;
    };
    return new Set(vertices.filter((_, i) => isNear(i)));
  }
  if (!solid) return new Set();
  const near = pointsAround(solid, views.mesh.sight, at, boundary.mesh, RADIUS);
  return new Set(near.map((i) => vertices[i]));
}
