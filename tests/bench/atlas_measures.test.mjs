// The measures that the atlas benchmark prints, in cases where their values are known.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { measureAtlas } from './support/atlas_measures.mjs';

const near = (value, wanted) => assert.ok(Math.abs(value - wanted) < 1e-12, `${value}, ${wanted}`);

/** A unit square of two triangles, with no fold along its diagonal. */
const positions = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
];
const whole = [
  { vertices: [0, 1, 2], texcoords: [0, 1, 2] },
  { vertices: [0, 2, 3], texcoords: [0, 2, 3] },
];

test('an isometry of any scale has energy 1 and no seam', () => {
  const texcoords = positions.map(([x, y]) => [0.1 - 0.3 * y, 0.2 + 0.3 * x]);
  const { seamLength, symmetricDirichlet, lost } = measureAtlas({
    triangles: whole,
    positions,
    texcoords,
  });
  assert.equal(seamLength, 0);
  assert.equal(lost, 0);
  near(symmetricDirichlet, 1);
});

test('a stretch by 2 has the energy of its singular values', () => {
  const texcoords = positions.map(([x, y]) => [2 * x, y]);
  const { symmetricDirichlet } = measureAtlas({ triangles: whole, positions, texcoords });
  // At the area-preserving scale: sqrt(2) and 1 / sqrt(2).
  near(symmetricDirichlet, (2 + 0.5 + 0.5 + 2) / 4);
});

test('a seam is as long as the edge that was cut; triangles without area are counted', () => {
  const texcoords = [...positions.map(([x, y]) => [x, y]), [0, 2], [1, 3], [0, 3]];
  const [first] = whole;
  const cut = [first, { vertices: [0, 2, 3], texcoords: [4, 5, 6] }];
  near(measureAtlas({ triangles: cut, positions, texcoords }).seamLength, Math.SQRT2);
  const lost = [first, { vertices: [0, 2, 3], texcoords: [0, 0, 0] }];
  assert.equal(measureAtlas({ triangles: lost, positions, texcoords }).lost, 1);
});
