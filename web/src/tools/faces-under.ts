import type { FaceSurface } from '../surface/face-surface';
import { NO_FACE } from '../surface/surface-graph';
import type { Pixel, Sight } from '../view/sight';

/** Css pixels between the rays of a brush. What lies between them is reached from face to face. */
const STEP = 4;

/** The faces that are seen within a radius around a pixel. */
export function facesUnder(
  surface: FaceSurface,
  sight: Sight,
  at: Pixel,
  radius: number,
): Set<number> {
  const found = new Set<number>();
  const isNear = ({ x, y }: Pixel) => Math.hypot(x - at.x, y - at.y) <= radius;
  const steps = Math.floor(radius / STEP);
  for (let i = -steps; i <= steps; ++i)
    for (let j = -steps; j <= steps; ++j) {
      const pixel = { x: at.x + STEP * i, y: at.y + STEP * j };
      const hit = isNear(pixel) && surface.solid.firstHit(sight.ray(pixel));
      if (hit) growFrom(hit.triangle, surface, sight, isNear, found);
    }
  return found;
}

/** Adds the face of a triangle, and those beyond its edges that show the same side and are near. */
function growFrom(
  triangle: number,
  surface: FaceSurface,
  sight: Sight,
  isNear: (at: Pixel) => boolean,
  found: Set<number>,
): void {
  const start = surface.faceOf(triangle);
  if (found.has(start)) return;
  found.add(start);
  const side = seen(triangle, surface, sight)?.side;
  const isUnder = (f: number) => {
    const there = seen(f, surface, sight);
    return there?.side === side && there !== null && isNear(there.middle);
  };
  const { sides } = surface.graph;
  const left = [start];
  for (let face = left.pop(); face !== undefined; face = left.pop())
    for (const edge of surface.edgesOf(face))
      for (const next of [sides[2 * edge], sides[2 * edge + 1]]) {
        if (next === NO_FACE || found.has(next)) continue;
        if (!surface.trianglesOf(next).some(isUnder)) continue;
        found.add(next);
        left.push(next);
      }
}

/** Which side of a triangle is seen, and where; null if a part of it is behind the eye. */
function seen(triangle: number, { solid }: FaceSurface, sight: Sight) {
  const [a, b, c] = [0, 1, 2].map((k) =>
    sight.pixel(solid.points, solid.indices[3 * triangle + k]),
  );
  if (!a || !b || !c) return null;
  return {
    side: Math.sign((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)),
    middle: { x: (a.x + b.x + c.x) / 3, y: (a.y + b.y + c.y) / 3 },
  };
}
