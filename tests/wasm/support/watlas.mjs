// Documents for glTF-Transform's `unwrap`, and their layouts as numbers.

import assert from 'node:assert/strict';
import * as THREE from 'three';
import { judge } from '../../support/exact-atlas.mjs';
import { accessor } from '../../support/gltf.mjs';

/** A torus knot as three.js makes it, with all its attributes. */
export function knotPrimitive(document, tubularSegments) {
  const { attributes, index } = new THREE.TorusKnotGeometry(1, 0.4, tubularSegments, 8);
  return document
    .createPrimitive()
    .setAttribute('POSITION', accessor(document, 'VEC3', attributes.position.array))
    .setAttribute('NORMAL', accessor(document, 'VEC3', attributes.normal.array))
    .setAttribute('TEXCOORD_0', accessor(document, 'VEC2', attributes.uv.array))
    .setIndices(accessor(document, 'SCALAR', index.array));
}

export function scaleRows(attribute, factor) {
  attribute.setArray(attribute.getArray().map((x) => x * factor));
}

/** Three vertices for each triangle, in the order of the indices. */
export function corners(primitive) {
  const indices = primitive.getIndices()?.getArray();
  return indices
    ? [...indices]
    : Array.from({ length: primitive.getAttribute('POSITION').getCount() }, (_, i) => i);
}

/** The triangles of a set, [[u, v], ...], by the numbers of its accessor. */
export function uvTriangles(primitive, set = 0) {
  const uv = primitive.getAttribute(`TEXCOORD_${set}`).getArray();
  const at = corners(primitive).map((vertex) => [uv[2 * vertex], uv[2 * vertex + 1]]);
  return Array.from({ length: at.length / 3 }, (_, t) => at.slice(3 * t, 3 * t + 3));
}

export function area(triangles) {
  return triangles.reduce(
    (sum, [a, b, c]) =>
      sum + Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2,
    0,
  );
}

export const uvArea = (primitive, set) => area(uvTriangles(primitive, set));

/** Asserts that no triangle is flipped, flat or outside, and that none overlap. */
export function assertLaidOut(triangles, what) {
  const { flipped, flat, outside, overlaps } = judge(triangles);
  assert.deepEqual(
    { flipped, flat, outside, overlaps },
    { flipped: [], flat: [], outside: [], overlaps: [] },
    what,
  );
}
