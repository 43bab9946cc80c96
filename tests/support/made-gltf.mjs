// An OBJ with everything that a glTF can take over, and what a glTF says about the same faces.

import { randomNumbers } from './disks.mjs';
import { elementsOf, trianglesOf } from './glb.mjs';

/** One pixel of opaque green. */
export const PNG = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M/wHwAEBgIApD5fRAAAAABJRU5ErkJggg==',
  'base64',
);

/**
 * A side of quads and two lids with `n` corners, at coordinates that are exact in single precision.
 */
export function drum(n = 7, rows = 4, seed = 1) {
  const random = randomNumbers(seed);
  const point = (i, j) => {
    const turn = (2 * Math.PI * i) / n;
    return [Math.cos(turn), Math.sin(turn), j].map(
      (x) => Math.round(1024 * (x + 0.1 * random())) / 1024,
    );
  };
  const at = (i, j) => j * n + (i % n);
  const ring = Array.from({ length: n }, (_, i) => i);
  return {
    positions: Array.from({ length: n * (rows + 1) }, (_, k) => point(k % n, Math.floor(k / n))),
    faces: [
      ring.map((i) => at(n - 1 - i, 0)),
      ...Array.from({ length: n * rows }, (_, k) => {
        const [i, j] = [k % n, Math.floor(k / n)];
        return [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      }),
      ring.map((i) => at(i, rows)),
    ],
  };
}

/**
 * Corners of a glTF by mesh and material, in order, each as one list of triangles: { name of the
 * mesh, material, triangles: [[{ POSITION, NORMAL, ... }, ...]] }.
 */
export function partsOf(model) {
  return model.json.meshes.flatMap(({ name, primitives }) =>
    primitives.map((primitive) => {
      const columns = Object.entries(primitive.attributes).map(([key, accessor]) => [
        key,
        elementsOf(model, accessor),
      ]);
      const corner = (v) => Object.fromEntries(columns.map(([key, rows]) => [key, rows[v]]));
      return {
        name,
        material: model.json.materials[primitive.material],
        triangles: trianglesOf(model, primitive).map((triangle) => triangle.map(corner)),
      };
    }),
  );
}

/**
 * Calls `check(corner of the glTF, corner of the face)` for every corner of the triangles that make
 * up `faces`, one face after another; faces are lists of corners with a `position`. Returns the
 * number of triangles left over.
 */
export function forCorners(triangles, faces, check) {
  let next = 0;
  for (const face of faces)
    for (let k = 2; k < face.length; k++)
      for (const corner of triangles[next] ? triangles[next++] : []) {
        const place = face.find(({ position }) => `${position}` === `${corner.POSITION}`);
        if (!place) return Number.POSITIVE_INFINITY;
        check(corner, place);
      }
  const wanted = faces.reduce((sum, face) => sum + face.length - 2, 0);
  return triangles.length - wanted;
}
