// How symmetric the seams of a layout are, found only from places and texcoords.

import { dot, lengthOf, minus } from './charted-layout.mjs';

/** Seams whose images lie nearer to a seam than this, relative to the size, count as mirrored. */
const REACH = 0.012;
/** Distance between the points of a seam that are looked at, relative to the size. */
const STEP = 0.004;

const along = (a, b, t) => a.map((x, d) => x + t * (b[d] - x));

/** A plane is { normal, distance }, with dot(normal, p) = distance. */
export const imageIn = ({ normal, distance }, p) => {
  const twice = 2 * (dot(normal, p) - distance);
  return p.map((x, d) => x - twice * normal[d]);
};

function sizeOf(triangles) {
  const points = triangles.flatMap(({ xyz }) => xyz);
  const extents = [0, 1, 2].map((d) => {
    const [low, high] = points.reduce(
      ([least, most], p) => [Math.min(least, p[d]), Math.max(most, p[d])],
      [Infinity, -Infinity],
    );
    return high - low;
  });
  return Math.max(...extents);
}

/** Points along the cuts, each with the length that it stands for. */
function pointsOf(cuts, step) {
  const out = [];
  for (const { a, b, length } of cuts) {
    const count = Math.max(1, Math.ceil(length / step));
    for (let i = 0; i < count; i++)
      out.push({ at: along(a, b, (i + 0.5) / count), length: length / count });
  }
  return out;
}

/** Whether one of the points is nearer to a place than `reach`. */
function nearness(points, reach) {
  const cells = new Map();
  const cellOf = (p) => p.map((x) => Math.floor(x / reach));
  for (const { at } of points) {
    const key = cellOf(at).join();
    if (!cells.has(key)) cells.set(key, []);
    cells.get(key).push(at);
  }
  const around = [-1, 0, 1];
  return (p) => {
    const [x, y, z] = cellOf(p);
    return around.some((i) =>
      around.some((j) =>
        around.some((k) =>
          (cells.get([x + i, y + j, z + k].join()) ?? []).some(
            (q) => lengthOf(minus(p, q)) < reach,
          ),
        ),
      ),
    );
  };
}

/** Of the length of the cuts of a charted layout: the share near whose images there are cuts. */
export function mirroredShare({ triangles, cuts }, plane) {
  const size = sizeOf(triangles);
  const points = pointsOf(cuts, STEP * size);
  const isNear = nearness(points, REACH * size);
  const total = (of) => of.reduce((sum, { length }) => sum + length, 0);
  const mirrored = points.filter(({ at }) => isNear(imageIn(plane, at)));
  return points.length > 0 ? total(mirrored) / total(points) : 1;
}
