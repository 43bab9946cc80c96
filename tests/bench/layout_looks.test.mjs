// Measures of how a layout looks, on layouts whose looks are known.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chartedLayout } from '../support/charted-layout.mjs';
import { faultsOf } from '../support/layout-expectations.mjs';
import { looksOfLayout } from '../support/layout-looks.mjs';
import { ordinaryShapes } from '../support/ordinary-shapes.mjs';
import { box } from '../support/shape-builders.mjs';

const near = (value, expected) =>
  assert.ok(Math.abs(value - expected) < 1e-9, `${value} is not ${expected}`);

/** Gives each corner of each face the texcoord that `uvOf(point, face)` says. */
function laidOut({ points, faces }, uvOf) {
  const texcoords = [];
  const corners = faces.map((face, f) =>
    face.map((v) => [v, texcoords.push(uvOf(points[v], f)) - 1]),
  );
  return { positions: points, texcoords, faces: corners };
}

const turnBy = (degrees, [u, v]) => {
  const [c, s] = [Math.cos, Math.sin].map((f) => f((degrees * Math.PI) / 180));
  return [c * u - s * v, s * u + c * v];
};

/** Each side of a cube of n x n squares a side as a square of its own, turned and stretched. */
function sidesOfCube(n, { degrees = 0, stretch = 1 } = {}) {
  const cube = box([1, 1, 1], n);
  const normalOf = (f) => {
    const corners = cube.faces[f].map((v) => cube.points[v]);
    const axis = [0, 1, 2].find((d) => corners.every((p) => p[d] === corners[0][d]));
    return { axis, end: corners[0][axis] };
  };
  return laidOut(cube, (p, f) => {
    const { axis, end } = normalOf(f);
    const [x, y] = axis === 1 ? [p[2], p[0]] : [p[axis === 0 ? 2 : 0], p[1]];
    return turnBy(degrees, [stretch * (3 * axis + (end ? x : -x)), 3 * end + y]);
  });
}

test('a cube in six squares', () => {
  for (const n of [1, 4]) {
    const looks = looksOfLayout(sidesOfCube(n));
    assert.deepEqual([looks.charts, looks.thin, looks.small], [6, 0, 0]);
    near(looks.seam, 24 / Math.sqrt(6));
    near(looks.smooth, 0);
    near(looks.flat, 0);
    near(looks.crease, 1);
    near(looks.axis, 1);
    near(looks.upright, 1);
    near(looks.sd, 1);
    near(looks.stretched, 0);
    // An edge sees three quarters of all directions, half of them above both of its sides.
    assert.ok(Math.abs(looks.exposed / (12 / Math.sqrt(6)) - 1) < 0.02);
  }
});

test('turning a layout changes only how it lies, whatever the scale', () => {
  const straight = looksOfLayout(sidesOfCube(2));
  const turned30 = looksOfLayout(sidesOfCube(2, { degrees: 30 }));
  near(turned30.axis, 0);
  near(turned30.upright, Math.cos(Math.PI / 6));
  for (const key of ['charts', 'seam', 'smooth', 'crease', 'exposed', 'sd'])
    near(turned30[key], straight[key]);
});

test('stretching one way', () => {
  const looks = looksOfLayout(sidesOfCube(2, { stretch: 4 }));
  // Lengths 2 and 1/2 at equal area.
  near(looks.sd, (2 * (4 + 1 / 4)) / 4);
  near(looks.stretched, 1);
  near(looksOfLayout(sidesOfCube(2, { stretch: 1.2 })).stretched, 0);
});

test('a cut across the squares of a flat side is in plain sight', () => {
  const layout = sidesOfCube(2);
  const first = layout.faces[0];
  for (const [, t] of first) layout.texcoords[t] = layout.texcoords[t].map((x) => x + 40);
  const looks = looksOfLayout(layout);
  assert.equal(looks.charts, 7);
  near(looks.flat, 1 / Math.sqrt(6));
  near(looks.smooth, 1 / Math.sqrt(6));
  near(looks.crease, 12 / 13);
});

test('expectations are met by a layout as expected, and each is missed by another', () => {
  const { points, faces, expect } = ordinaryShapes().find(
    ({ name }) => name === 'open cylinder of 16 sides in 1 row',
  );
  const unrolled = laidOut({ points, faces }, () => [0, 0]);
  const side = Math.hypot(...points[faces[0][0]].map((x, d) => x - points[faces[0][1]][d]));
  const set = (uvOf) => {
    for (const [f, face] of unrolled.faces.entries())
      for (const [i, [, t]] of face.entries())
        unrolled.texcoords[t] = uvOf(side * (f + (i === 1 || i === 2 ? 1 : 0)), i < 2 ? 0 : 2, f);
    return faultsOf(expect, chartedLayout(unrolled), atlas);
  };
  const atlas = { packingCuts: 0, texelDensity: 100, uncutTexelDensity: 100 };
  const missed = (faults) => Object.keys(faults).filter((key) => faults[key] !== '');
  assert.deepEqual(missed(set((u, v) => [u, v])), []);
  assert.deepEqual(missed(set((u, v) => turnBy(45, [u, v]))), ['level']);
  assert.deepEqual(missed(set((u, v, f) => [u + (f > 7 ? 40 : 0), v])), ['charts']);
  atlas.packingCuts = 1;
  atlas.texelDensity = 104;
  assert.deepEqual(missed(set((u, v, f) => [u + (f > 7 ? 40 : 0), v])), ['charts']);
  atlas.texelDensity = 110;
  assert.deepEqual(missed(set((u, v, f) => [u + (f > 7 ? 40 : 0), v])), []);
  atlas.packingCuts = 0;
  assert.deepEqual(missed(set((u, v) => [2 * u, v])), ['sd']);
});

test('polygons that are not convex count with their own area', () => {
  const step = [
    [2, 1],
    [0, 1],
    [0, 0],
    [1, 0],
    [1, -3],
    [2, -3],
  ];
  const surface = { points: step.map(([x, y]) => [x, y, 0]), faces: [[0, 1, 2, 3, 4, 5]] };
  const { triangles } = chartedLayout(laidOut(surface, ([x, y]) => [x, y]));
  near(
    triangles.reduce((sum, { area }) => sum + area, 0),
    5,
  );
});
