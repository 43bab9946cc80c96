// Which charts an area touches, which have something in common, and edges that are made level.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

/** Squares of two triangles each, a chart each, with their lower left corners at these points. */
function squares(corners, side = 1) {
  const uv = corners.flatMap(([u, v]) => [
    ...[u, v, u + side, v],
    ...[u + side, v + side, u, v + side],
  ]);
  const indices = corners.flatMap((_, i) => [0, 1, 2, 0, 2, 3].map((v) => v + 4 * i));
  const chartOfTriangle = corners.flatMap((_, i) => [i, i]);
  return {
    uv: Float64Array.from(uv),
    indices: Uint32Array.from(indices),
    chartOfTriangle: Uint32Array.from(chartOfTriangle),
  };
}

const NONE = new Set();
const sorted = (set) => [...set].sort((a, b) => a - b);
const ROW = squares([
  [0, 0],
  [2, 0],
  [4, 0],
]);

test('an area selects what it touches: around it, within it, or across it', async () => {
  const { chartsInArea } = await load('arrange/charts-in-area');
  const box = (left, bottom, right, top) => [
    [left, bottom],
    [right, bottom],
    [right, top],
    [left, top],
  ];
  const found = (area, hidden = NONE) => sorted(chartsInArea(ROW, area, hidden));
  assert.deepEqual(found(box(-1, -1, 3.5, 2)), [0, 1], 'around');
  assert.deepEqual(found(box(4.4, 0.1, 4.6, 0.2)), [2], 'within a triangle');
  assert.deepEqual(found(box(2.4, -1, 2.6, 2)), [1], 'across, without any corner in the other');
  assert.deepEqual(found(box(1.2, 0, 1.8, 1)), [], 'between');
  assert.deepEqual(found(box(-1, -1, 9, 9), new Set([1])), [0, 2], 'hidden charts are left out');
  // A lasso around the first and the last goes below the one in the middle.
  const lasso = [
    ...[
      [-1, -1],
      [6, -1],
      [6, 2],
    ],
    ...[
      [3.5, 2],
      [3.5, -0.5],
      [1.5, -0.5],
      [1.5, 2],
      [-1, 2],
    ],
  ];
  assert.deepEqual(found(lasso), [0, 2]);
});

test('charts of the same shape may be turned, mirrored and of another size', async () => {
  const { sameShapes } = await load('arrange/same-shape');
  /** The corners of a chart of two triangles. */
  const corners = [
    [0, 0],
    [3, 0],
    [3.5, 1],
    [0, 2],
  ];
  const turned = corners.map(([x, y]) => [10 - 2 * y, 2 * x]);
  const mirrored = corners.map(([x, y]) => [20 - x, y]).reverse();
  const other = corners.map(([x, y]) => [30 + x, 1.5 * y]);
  const all = [corners, turned, mirrored, other];
  const arrays = {
    uv: Float64Array.from(all.flat(2)),
    indices: Uint32Array.from(all.flatMap((_, i) => [0, 1, 2, 0, 2, 3].map((v) => v + 4 * i))),
    chartOfTriangle: Uint32Array.from(all.flatMap((_, i) => [i, i])),
  };
  assert.deepEqual(sorted(sameShapes(arrays, [0])), [0, 1, 2]);
  assert.deepEqual(sorted(sameShapes(arrays, [3])), [3]);
  assert.deepEqual(sorted(sameShapes(arrays, [2, 3])), [0, 1, 2, 3]);
});

test('flipped, overlapping and stretched charts are found, and those with a part in common', async () => {
  const { chartsWithParts, flippedCharts, overlappingCharts, stretchedCharts } =
    await load('selection/choosing');
  const mirrored = { ...ROW, uv: ROW.uv.slice() };
  for (let i = 0; i < 8; i += 2) mirrored.uv[i] *= -1;
  assert.deepEqual(sorted(flippedCharts(ROW)), []);
  assert.deepEqual(sorted(flippedCharts(mirrored)), [0]);
  const chart = (firstFace, symmetricDirichlet, problem = '') => ({
    ...{ firstFace, symmetricDirichlet, problem, valid: problem === '' },
  });
  const charts = [
    chart(0, 1.01),
    chart(7, 1.2, 'it touches or overlaps the chart containing face 0 in the atlas'),
    chart(3, 1.05),
    chart(9, 1),
  ];
  const outcome = { result: { report: { charts } }, stacks: [[2, 3]] };
  assert.deepEqual(sorted(overlappingCharts(outcome)), [0, 1, 2, 3]);
  assert.deepEqual(sorted(overlappingCharts({ ...outcome, stacks: undefined })), [0, 1]);
  assert.deepEqual(sorted(stretchedCharts(outcome, 1.02)), [1, 2]);
  const parts = [4, 4, 4, 5, 6, 5];
  assert.deepEqual(sorted(chartsWithParts(ROW, parts, new Set([0]))), [0, 1]);
  assert.deepEqual(sorted(chartsWithParts(ROW, parts, new Set([2]))), [1, 2]);
});

test('parts that share a point are connected, also where it is there twice', async () => {
  const { connectedParts } = await load('mesh/connected-parts');
  const positions = Float64Array.of(
    ...[0, 0, 0, 1, 0, 0, 0, 1, 0],
    ...[5, 0, 0, 6, 0, 0, 5, 1, 0],
    ...[1, 0, 0, 2, 0, 0, 1, 1, 0],
  );
  const indices = Uint32Array.of(0, 1, 2, 3, 4, 5, 8, 7, 6);
  const [a, b, c] = connectedParts({ positions, indices });
  assert.equal(a, c);
  assert.notEqual(a, b);
});

test('a line becomes level or upright, whichever is nearer, about its middle', async () => {
  const { levelled } = await load('arrange/level-edge');
  const { isStill, moved } = await load('arrange/motion');
  for (let i = 0; i < 24; ++i) {
    const angle = (i * Math.PI) / 12 + 0.1;
    const [from, to] = [
      [0.3, 0.4],
      [0.3 + Math.cos(angle), 0.4 + Math.sin(angle)],
    ];
    const motion = levelled(from, to);
    const [[x0, y0], [x1, y1]] = [moved(motion, from), moved(motion, to)];
    assert.ok(Math.min(Math.abs(x1 - x0), Math.abs(y1 - y0)) < 1e-12, `${angle}`);
    assert.ok(motion.a >= Math.SQRT1_2 - 1e-9, 'by no more than an eighth of a turn');
    assert.ok(
      Math.abs(x0 + x1 - from[0] - to[0]) < 1e-12 && Math.abs(y0 + y1 - from[1] - to[1]) < 1e-12,
    );
  }
  assert.ok(isStill(levelled([0, 0], [0, -2])));
});

test('the edge of an outline that is near is found; inner edges are none', async () => {
  const { OutlinePicker } = await load('selection/outline-picker');
  const picker = new OutlinePicker(ROW);
  assert.equal(picker.ends.length / 2, 12);
  const any = () => true;
  const at = (point, reach = 0.2, isMeant = any) => picker.edgeNear(point, reach, isMeant);
  const bottom = at([2.5, 0.05]);
  assert.equal(picker.chartOf(bottom), 1);
  assert.deepEqual(picker.sideOf(bottom), [
    [2, 0],
    [3, 0],
  ]);
  assert.equal(at([2.5, 0.5]), null, 'the diagonal is no edge of the outline');
  assert.equal(
    at([1.5, 0.5], 0.6, (edge) => picker.chartOf(edge) === 2),
    null,
  );
  assert.deepEqual(picker.pointNear([9, 9], 0), [1, 1]);
});
