// The geometries of three.js as OBJ files: with vertices duplicated along seams, and with fans and
// points at poles.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import * as three from 'three';
import { BUILD } from '../../../scripts/lib/paths.mjs';

const FOLDER = join(BUILD, 'bench');

const bottle = (n) =>
  Array.from(
    { length: n + 1 },
    (_, i) => new three.Vector2(1 + 0.4 * Math.sin((6 * i) / n), (4 * i) / n),
  );

/** For each family, a geometry with about `2 * n * n` triangles. */
const FAMILIES = {
  sphere: (n) => new three.SphereGeometry(1, Math.round(1.41 * n), Math.round(0.71 * n)),
  torus: (n) => new three.TorusGeometry(1, 0.4, Math.round(0.71 * n), Math.round(1.41 * n)),
  knot: (n) => new three.TorusKnotGeometry(1, 0.3, 4 * n, Math.max(3, n >> 2)),
  tube: (n) =>
    new three.TubeGeometry(
      new three.CatmullRomCurve3(
        [0, 1, 2, 3].map((i) => new three.Vector3(i, Math.sin(2 * i), Math.cos(3 * i))),
      ),
      2 * n,
      0.2,
      Math.max(3, n >> 1),
    ),
  cylinder: (n) => new three.CylinderGeometry(1, 1, 2, Math.round(1.41 * n), Math.round(0.71 * n)),
  cone: (n) => new three.ConeGeometry(1, 2, Math.round(1.41 * n), Math.round(0.71 * n)),
  capsule: (n) => new three.CapsuleGeometry(1, 1, n >> 2, n, n >> 1),
  lathe: (n) => new three.LatheGeometry(bottle(n), n),
  box: (n) => {
    const k = Math.max(1, Math.round(0.41 * n));
    return new three.BoxGeometry(1, 1, 1, k, k, k);
  },
  plane: (n) => new three.PlaneGeometry(1, 1, n, n),
  ring: (n) => new three.RingGeometry(0.5, 1, Math.round(1.41 * n), Math.round(0.71 * n)),
  circle: (n) => new three.CircleGeometry(1, 2 * n * n),
  icosahedron: (n) => new three.IcosahedronGeometry(1, Math.max(0, Math.round(n / 3.16) - 1)),
};

export const PRIMITIVES = Object.keys(FAMILIES);

/** Writes a geometry of about `faces` triangles; returns its path and number of faces. */
export function writePrimitive(family, faces) {
  const geometry = FAMILIES[family](Math.max(3, Math.round(Math.sqrt(faces / 2))));
  const { array } = geometry.attributes.position;
  const index =
    geometry.index?.array ?? Uint32Array.from({ length: array.length / 3 }, (_, i) => i);
  const lines = [];
  for (let i = 0; i < array.length; i += 3)
    lines.push(`v ${array[i]} ${array[i + 1]} ${array[i + 2]}`);
  for (let i = 0; i < index.length; i += 3)
    lines.push(`f ${index[i] + 1} ${index[i + 1] + 1} ${index[i + 2] + 1}`);
  mkdirSync(FOLDER, { recursive: true });
  const path = join(FOLDER, `${family}-${faces}.obj`);
  writeFileSync(path, `${lines.join('\n')}\n`);
  return { path, faces: index.length / 3 };
}
