import type { Vector3 } from 'three';

export interface Ray {
  origin: Vector3;
  direction: Vector3;
}

/** Triangles in 3D: `points` has xyz per vertex. */
export interface Solid {
  points: Float32Array;
  indices: Uint32Array;
}

export interface Hit {
  triangle: number;
  /** In lengths of the ray's direction. */
  distance: number;
}

/** The first triangle that a ray meets, from either side (Möller and Trumbore). */
export function firstHit({ points: p, indices }: Solid, { origin, direction }: Ray): Hit | null {
  const { x: ox, y: oy, z: oz } = origin;
  const { x: dx, y: dy, z: dz } = direction;
  let triangle = -1;
  let nearest = Infinity;
  for (let c = 0; c < indices.length; c += 3) {
    const i = 3 * indices[c];
    const j = 3 * indices[c + 1];
    const k = 3 * indices[c + 2];
    const ax = p[j] - p[i];
    const ay = p[j + 1] - p[i + 1];
    const az = p[j + 2] - p[i + 2];
    const bx = p[k] - p[i];
    const by = p[k + 1] - p[i + 1];
    const bz = p[k + 2] - p[i + 2];
    const hx = dy * bz - dz * by;
    const hy = dz * bx - dx * bz;
    const hz = dx * by - dy * bx;
    const scale = 1 / (ax * hx + ay * hy + az * hz); // infinite where the ray lies in the plane
    const sx = ox - p[i];
    const sy = oy - p[i + 1];
    const sz = oz - p[i + 2];
    const u = scale * (sx * hx + sy * hy + sz * hz);
    if (!(u >= 0 && u <= 1)) continue;
    const qx = sy * az - sz * ay;
    const qy = sz * ax - sx * az;
    const qz = sx * ay - sy * ax;
    const v = scale * (dx * qx + dy * qy + dz * qz);
    if (!(v >= 0 && u + v <= 1)) continue;
    const distance = scale * (bx * qx + by * qy + bz * qz);
    if (!(distance > 0 && distance < nearest)) continue;
    nearest = distance;
    triangle = c / 3;
  }
  return triangle < 0 ? null : { triangle, distance: nearest };
}
