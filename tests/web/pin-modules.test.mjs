// Pins without a page: which vertices they are, and what is made of a chart that one of them bends.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

/** Two squares side by side, of two triangles each; the second one is twice as high in space. */
const ATLAS = {
  uv: Float64Array.of(...[0, 0, 0.4, 0, 0.4, 0.4, 0, 0.4], ...[0.5, 0, 0.9, 0, 0.9, 0.4, 0.5, 0.4]),
  unpacked: new Float64Array(16),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
  chartOfTriangle: Uint32Array.of(0, 0, 1, 1),
};
const POSITIONS = Float64Array.of(
  ...[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
  ...[0, 0, 5, 1, 0, 5, 1, 2, 5, 0, 2, 5],
);
const NONE = new Set();

test('a vertex is pinned once, whatever corner is named, and its pin is removed', async () => {
  const { toggled, othersInChart } = await load('selection/pin-set');
  const one = toggled(new Uint32Array(), ATLAS, 2);
  assert.deepEqual([...one], [2]);
  const two = toggled(toggled(one, ATLAS, 8), ATLAS, 0);
  assert.deepEqual([...two], [2, 8, 0]);
  assert.deepEqual(othersInChart(two, ATLAS, 2), [0]);
  assert.deepEqual(othersInChart(two, ATLAS, 4), [0], 'another corner of the same vertex');
  assert.deepEqual(othersInChart(two, ATLAS, 8), []);
  assert.deepEqual([...toggled(two, ATLAS, 2)], [8, 0]);
  assert.deepEqual([...toggled(two, ATLAS, 4)], [8, 0], 'by another corner of the same vertex');
});

test('the nearest vertex within reach is found, but not in a hidden chart', async () => {
  const { cornerNear, pinNear } = await load('selection/pin-set');
  const at = [0.46, 0.02];
  assert.equal(ATLAS.indices[cornerNear(ATLAS, NONE, at, 0.1)], 4);
  assert.equal(ATLAS.indices[cornerNear(ATLAS, new Set([1]), at, 0.1)], 1);
  assert.equal(cornerNear(ATLAS, NONE, at, 0.03), null);
  const pins = Uint32Array.of(1, 6);
  assert.equal(pinNear(pins, ATLAS, NONE, at, 0.1), 6);
  assert.equal(pinNear(pins, ATLAS, new Set([1]), at, 0.1), 1);
  assert.equal(pinNear(pins, ATLAS, NONE, at, 0.03), null);
});

test('a chart by itself has its own vertices, corners and outline', async () => {
  const { chartMeshes } = await load('arrange/chart-mesh');
  const [mesh] = chartMeshes(ATLAS, POSITIONS, [1]);
  assert.deepEqual([...mesh.vertices], [4, 5, 6, 7]);
  assert.deepEqual([...mesh.corners], [6, 7, 8, 9, 10, 11]);
  assert.deepEqual([...mesh.indices], [0, 1, 2, 0, 2, 3]);
  assert.deepEqual([...mesh.texcoords], [...ATLAS.uv.slice(8)]);
  assert.deepEqual([...mesh.positions], [...POSITIONS.slice(12)]);
  const edges = [];
  for (let i = 0; i < mesh.outline.length; i += 2)
    edges.push([...mesh.outline.slice(i, i + 2)].sort().join());
  assert.deepEqual(edges.sort(), ['0,1', '0,3', '1,2', '2,3']);
});

test('a bent chart moves by its weights, and unpacked it has the area of its surface', async () => {
  const { bent, chartMeshes } = await load('arrange/chart-mesh');
  const [mesh] = chartMeshes(ATLAS, POSITIONS, [1]);
  // The pin turns as it goes: i times as far for the second vertex, twice as far for the third.
  const weights = Float64Array.of(0, 0, 0, 1, 2, 0, 0, 0);
  const { uv, unpacked } = bent(ATLAS, mesh, weights, [0.01, 0.02]);
  assert.deepEqual([...uv.slice(0, 8)], [...ATLAS.uv.slice(0, 8)]);
  const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-7, `${a} is ${b}`);
  [0.5, 0, 0.9 - 0.02, 0.01, 0.9 + 0.02, 0.4 + 0.04, 0.5, 0.4].forEach((x, i) => {
    near(uv[8 + i], x);
    assert.equal(uv[8 + i], Math.fround(uv[8 + i]));
  });
  const areaOf = (points) => {
    const [ax, ay, bx, by, cx, cy, dx, dy] = points.slice(8);
    return ((cx - ax) * (dy - by) - (cy - ay) * (dx - bx)) / 2;
  };
  near(areaOf(unpacked), 2);
  near(unpacked[10] / uv[10], unpacked[13] / uv[13]);
});

test('a chart that was moved meanwhile is bent where it is now', async () => {
  const { bent, chartMeshes } = await load('arrange/chart-mesh');
  const [mesh] = chartMeshes(ATLAS, POSITIONS, [1]);
  const weights = Float64Array.of(0, 0, 1, 0, 1, 0, 0, 0);
  const moved = { ...ATLAS, uv: ATLAS.uv.map((x, i) => (i >= 8 ? x + 0.25 : x)) };
  const [still, now] = [ATLAS, moved].map((atlas) => bent(atlas, mesh, weights, [0.1, 0]).uv);
  now.forEach((x, i) => {
    assert.ok(Math.abs(x - still[i] - (i >= 8 ? 0.25 : 0)) < 1e-7);
  });
});

test('what the shader gets for corners is what the outline gets', async () => {
  const { chartMeshes } = await load('arrange/chart-mesh');
  const { bentOutline, cornerWeights } = await load('view/bending');
  const [mesh] = chartMeshes(ATLAS, POSITIONS, [1]);
  const bending = { chart: 1, mesh, weights: Float64Array.of(1, 0, 0, 1, 2, 0, 0.5, 0.25) };
  const corners = new Float32Array(24).fill(9);
  cornerWeights(bending, corners);
  assert.deepEqual([...corners.slice(0, 12)], Array(12).fill(0));
  assert.deepEqual([...corners.slice(12)], [1, 0, 0, 1, 2, 0, 1, 0, 2, 0, 0.5, 0.25]);
  const by = [0.1, 0.2];
  const ends = bentOutline(bending, by, ([u, v]) => [10 * u, 10 * v]);
  mesh.outline.forEach((v, i) => {
    const [a, b] = bending.weights.slice(2 * v, 2 * v + 2);
    const [u0, v0] = mesh.texcoords.slice(2 * v, 2 * v + 2);
    const u = 10 * (u0 + a * by[0] - b * by[1]);
    assert.ok(Math.abs(ends[3 * i] - u) < 1e-5);
    assert.ok(Math.abs(ends[3 * i + 1] - 10 * (v0 + b * by[0] + a * by[1])) < 1e-5);
  });
});
