import { Vector3 } from 'three';

/**
 * The point to look at, and the distance from which points (xyz each) fill a perspective view.
 * `front`: unit vector to the eye, not vertical. `across`, `up`: half the view's width and height
 * at distance 1.
 */
export function fitInView(
  points: Float32Array,
  front: Vector3,
  across: number,
  up: number,
): { target: Vector3; distance: number } {
  const right = new Vector3(0, 1, 0).cross(front).normalize();
  const top = front.clone().cross(right);
  const horizontal = fitAxis(points, front, right, across);
  const vertical = fitAxis(points, front, top, up);
  return {
    target: right.multiplyScalar(horizontal.middle).addScaledVector(top, vertical.middle),
    distance: Math.max(horizontal.distance, vertical.distance),
  };
}

/** An eye at `distance`, moved to `middle` along an axis, sees a point p if |p.axis - middle| <= slope (distance - p.front). */
function fitAxis(
  points: Float32Array,
  front: Vector3,
  axis: Vector3,
  slope: number,
): { middle: number; distance: number } {
  const point = new Vector3();
  let high = -Infinity;
  let low = -Infinity;
  for (let i = 0; i < points.length; i += 3) {
    point.fromArray(points, i);
    const [along, towards] = [point.dot(axis), slope * point.dot(front)];
    high = Math.max(high, along + towards);
    low = Math.max(low, towards - along);
  }
  if (high === -Infinity) return { middle: 0, distance: 1 };
  return { middle: (high - low) / 2, distance: (high + low) / (2 * slope) };
}
