// The measures of published evaluations, in cases where their values are known, and what follows
// from them.

import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { layoutOf, measureLayout } from './support/layout_measures.mjs';

const near = (value, wanted, what) =>
  assert.ok(Math.abs(value - wanted) < 1e-9, `${what}: ${value}, not ${wanted}`);

/**
 * n x n unit squares in the plane, two triangles each, with texcoords given by a map of the plane.
 */
function grid(n, map) {
  const at = (i, j) => i + j * (n + 1);
  const positions = Array.from({ length: (n + 1) ** 2 }, (_, k) => [
    k % (n + 1),
    Math.floor(k / (n + 1)),
    0,
  ]);
  const faces = [];
  for (let j = 0; j < n; j++)
    for (let i = 0; i < n; i++) {
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      faces.push([a, b, c], [a, c, d]);
    }
  return layoutOf({
    positions,
    texcoords: positions.map(map),
    faces: faces.map((face) => face.map((v) => [v, v])),
  });
}

/**
 * Gives the faces for which `isOther` holds separate texcoords, shifted to the right by `shift` and
 * scaled by `scale`.
 */
function torn({ triangles, positions, texcoords }, isOther, shift, scale = 1) {
  const copies = texcoords.map(([u, v]) => [scale * u + shift, scale * v]);
  return {
    positions,
    texcoords: [...texcoords, ...copies],
    triangles: triangles.map((triangle, f) =>
      isOther(f)
        ? { ...triangle, texcoords: triangle.texcoords.map((t) => t + texcoords.length) }
        : triangle,
    ),
  };
}

describe('one chart', () => {
  test('an isometry of any scale distorts nothing', () => {
    const measured = measureLayout(grid(4, ([x, y]) => [0.5 - 0.1 * y, 0.1 * x]));
    const wanted = { area: 1, areaOverall: 1, angular: 1, sd: 1, turning: 0 };
    for (const [key, value] of Object.entries(wanted)) near(measured[key], value, key);
    assert.equal(measured.charts, 1);
    near(measured.seam, 1.6, 'outline as packed');
    near(measured.seam3, 4, 'outline of a square on the surface');
    near(measured.compactness, Math.PI / 4, 'compactness of a square');
  });

  test('a shear tilts the directions of the layout by its angle, and keeps areas', () => {
    const shear = 0.75;
    const { angular, area } = measureLayout(grid(3, ([x, y]) => [0.1 * (x + shear * y), 0.1 * y]));
    near(angular, 1 - shear / Math.hypot(1, shear), 'angular');
    near(area, 1, 'area');
  });

  test('a stretch along an axis is seen by the energy alone', () => {
    const { angular, area, sd } = measureLayout(grid(3, ([x, y]) => [0.2 * x, 0.1 * y]));
    near(angular, 1, 'angular');
    near(area, 1, 'area');
    near(sd, 1.25, 'energy');
  });

  test('what is twice as large on one half is more and less than the mean', () => {
    // Widths of 1 and 2 over those of 1: areas of 2/3 and 4/3 of the mean.
    const { area, areaOverall } = measureLayout(
      grid(4, ([x, y]) => [0.05 * (x + Math.max(0, x - 2)), 0.05 * y]),
    );
    near(area, (3 / 2 + 4 / 3) / 2, 'area');
    near(areaOverall, area, 'areaOverall');
  });
});

describe('several charts', () => {
  const whole = grid(4, ([x, y]) => [0.05 * x, 0.05 * y]);

  test('a seam counts on both sides, and runs straight', () => {
    const { charts, seam, seam3, turning } = measureLayout(torn(whole, (f) => f >= 16, 0.5));
    assert.equal(charts, 2);
    near(seam, 0.05 * (16 + 8), 'seam');
    near(seam3, (16 + 8) / 4, 'seam3');
    near(turning, 0, 'turning');
  });

  test('a chart of another scale keeps its own areas, not those of the mesh', () => {
    const { area, areaOverall } = measureLayout(torn(whole, (f) => f >= 16, 0.5, 2));
    near(area, 1, 'area');
    // 1 and 4 times the area: 2/5 and 8/5 of the mean.
    near(areaOverall, (5 / 2 + 8 / 5) / 2, 'areaOverall');
  });

  test('a toothed seam turns at each tooth', () => {
    // One triangle of each square of the first row: the seam alternates between diagonals and
    // sides, and touches the boundary in between.
    const toothed = torn(whole, (f) => f > 7 || f % 2 === 1, 0.5);
    const length = 4 * Math.SQRT2 + 3;
    const { seam3, turning } = measureLayout(toothed);
    near(seam3, (16 + 2 * length) / 4, 'seam3');
    near(turning, (3 * ((3 * Math.PI) / 4)) / (length / 4), 'turning');
  });

  test('texcoords of the same values are one', () => {
    const apart = torn(whole, (f) => f % 3 === 0, 0);
    assert.deepEqual(measureLayout(apart), measureLayout(whole));
  });
});

test('a polygon is as its triangles', () => {
  const positions = [
    [0, 0, 0],
    [3, 0, 0],
    [3, 2, 0],
    [0, 2, 0],
  ];
  const texcoords = positions.map(([x, y]) => [x / 4, y / 4]);
  const corners = positions.map((_, i) => [i, i]);
  const three = (...of) => of.map((i) => corners[i]);
  const quad = layoutOf({ positions, texcoords, faces: [corners] });
  const two = layoutOf({ positions, texcoords, faces: [three(0, 1, 2), three(0, 2, 3)] });
  assert.deepEqual(measureLayout(quad), measureLayout(two));
});
