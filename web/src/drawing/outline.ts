import { hull } from '../base/hull';
import { usedVertices } from '../mesh/mesh';

/**
 * Of the points (xyz each) named by `indices`, those that bound the others when seen along any
 * direction in the plane of `front` and `right`, or of `front` and `top`: the corners of the convex
 * hulls of both projections.
 */
export function outline(
  points: Float32Array,
  indices: Uint32Array,
  { front, right, top }: Record<'front' | 'right' | 'top', readonly number[]>,
): Float32Array {
  const used = usedVertices(points.length / 3, indices);
  const along = ([x, y, z]: readonly number[]) => {
    const values = new Float64Array(used.length);
    for (let i = 0; i < used.length; ++i) {
      const v = 3 * used[i];
      values[i] = points[v] * x + points[v + 1] * y + points[v + 2] * z;
    }
    return values;
  };
  const depth = along(front);
  const corners = [right, top].flatMap((axis) => hull(along(axis), depth));
  return Float32Array.from(
    corners.flatMap((i) => [...points.subarray(3 * used[i], 3 * used[i] + 3)]),
  );
}

/** Number of directions, evenly spread (a Fibonacci spiral). */
const DIRECTIONS = 128;
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

/**
 * Of the points (xyz each) named by `indices`, those that are farthest in one of many directions.
 */
export function farthest(points: Float32Array, indices: Uint32Array): Float32Array {
  const used = usedVertices(points.length / 3, indices);
  const found = new Set<number>();
  if (used.length === 0) return new Float32Array();
  for (let i = 0; i < DIRECTIONS; ++i) {
    const y = 1 - (2 * i + 1) / DIRECTIONS;
    const [x, z] = [Math.cos(i * GOLDEN_ANGLE), Math.sin(i * GOLDEN_ANGLE)];
    const across = Math.sqrt(1 - y * y);
    found.add(farthestAlong(points, used, across * x, y, across * z));
  }
  return Float32Array.from([...found].flatMap((v) => [...points.subarray(3 * v, 3 * v + 3)]));
}

function farthestAlong(p: Float32Array, used: Uint32Array, x: number, y: number, z: number) {
  let farthest = used[0];
  let most = -Infinity;
  for (let i = 0; i < used.length; ++i) {
    const v = used[i];
    const along = p[3 * v] * x + p[3 * v + 1] * y + p[3 * v + 2] * z;
    if (along <= most) continue;
    most = along;
    farthest = v;
  }
  return farthest;
}
