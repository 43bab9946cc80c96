// The page's modules that need no page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

/** A square of two triangles, tilted. */
const SQUARE = {
  positions: Float64Array.of(0, 0, 0, 2, 0, 1, 2, 2, 1, 0, 2, 0),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
};

test('boundary edges are those with one triangle, in its direction', async () => {
  const { boundaryEdges } = await load('mesh/mesh');
  const edges = [...boundaryEdges(SQUARE.indices)];
  const pairs = edges.flatMap((v, i) => (i % 2 === 0 ? [`${v}-${edges[i + 1]}`] : []));
  assert.deepEqual(pairs.sort(), ['0-1', '1-2', '2-3', '3-0']);
});

test('a plane faces along its normal, a closed surface nowhere', async () => {
  const { facing } = await load('mesh/mesh');
  const plane = facing(SQUARE);
  const length = Math.hypot(1, 2);
  [-1 / length, 0, 2 / length].forEach((x, d) => {
    assert.ok(Math.abs(plane.direction[d] - x) < 1e-12);
  });
  assert.ok(Math.abs(plane.clarity - 1) < 1e-12);
  const closed = facing({
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1),
    indices: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
  });
  assert.ok(closed.clarity < 1e-12);
});

test('checker cells do not depend on the unit of the layout or of the mesh', async () => {
  const { checkerCells, inCells } = await load('mesh/checker');
  const cellsOf = (mesh) => inCells(mesh.uv, checkerCells(mesh));
  const uv = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1);
  const cells = cellsOf({ ...SQUARE, uv });
  const larger = cellsOf({ ...SQUARE, uv: uv.map((x) => 1000 * x - 7) });
  const smaller = cellsOf({ ...SQUARE, positions: SQUARE.positions.map((x) => x / 50), uv });
  cells.forEach((x, i) => {
    assert.ok(Math.abs(x - larger[i]) < 1e-3);
    assert.ok(Math.abs(x - smaller[i]) < 1e-3);
  });
});

test('crossings are found where they are, and only there', async () => {
  const { crossings } = await load('mesh/crossings');
  const bowTie = Float64Array.of(0, 0, 2, 2, 2, 0, 0, 2);
  const loop = Uint32Array.of(0, 1, 1, 2, 2, 3, 3, 0);
  assert.deepEqual([...crossings(bowTie, loop, 10)], [1, 1]);
  const square = Float64Array.of(0, 0, 2, 0, 2, 2, 0, 2);
  assert.equal(crossings(square, loop, 10).length, 0);
});

test('numbers keep three digits, a bounded length, and commas', async () => {
  const { measure, brief, distortion, duration, bound } = await load('words/format');
  assert.equal(distortion(3.77e-31), '0');
  assert.equal(distortion(0.0025234, brief), '0.0025');
  assert.equal(measure(0.0025234), '0.00252');
  assert.equal(measure(1.6777), '1.68');
  assert.equal(measure(12345.6), '12,346');
  assert.deepEqual([4720.4, 352.2].map(measure), ['4,720', '352']);
  assert.equal(brief(4720.4), '4,720');
  assert.equal(measure(0.00001234), '1.23e-5');
  assert.equal(measure(Number.NaN), 'not finite');
  assert.equal(duration(0.0361), '36\u202fms');
  assert.equal(duration(1.256), '1.26\u202fs');
  assert.equal(bound(0.968), '0.968');
  for (let x = 1e-9; x < 1e12; x *= 3.7) {
    assert.ok(measure(x).length <= 9, measure(x));
    assert.ok(brief(x).length <= 7, brief(x));
    assert.ok(Math.abs(Number(brief(x).replace(',', '')) - x) <= 0.06 * x, brief(x));
  }
});

test('notes: why a layout is not valid, what was done, which vertices are tightened', async () => {
  const { notes } = await load('details/notes');
  assert.deepEqual(notes({ problem: '', fallbacks: [], bounds: [], delaunay: null }), []);
  const chart = {
    problem: 'the boundary crosses itself',
    fallbacks: ['the active set stalled; interior point'],
    delaunay: null,
    bounds: [
      { vertex: 3, t: 1.25 },
      { vertex: 9, t: 1.125 },
    ],
  };
  assert.deepEqual(notes(chart), [
    'The boundary crosses itself.',
    'The active set stalled; interior point.',
    '2 boundary vertices were tightened, down to t\u00a0=\u00a01.125.',
  ]);
});

test('the farthest points of a mesh bound it in every direction, and are few', async () => {
  const { farthest } = await load('drawing/outline');
  const count = 4000;
  const points = Float32Array.from(
    { length: 3 * count },
    (_, i) => Math.sin(i * i * 0.7) * (1 + (i % 3)),
  );
  points.set([50, 50, 50]); // no triangle has it
  const indices = Uint32Array.from({ length: count - 1 }, (_, i) => i + 1);
  const hull = farthest(points, indices);
  assert.ok(hull.length <= 3 * 128);
  const most = (p, from, d) => {
    let found = -Infinity;
    for (let i = from; i < p.length; i += 3)
      found = Math.max(found, p[i] * d[0] + p[i + 1] * d[1] + p[i + 2] * d[2]);
    return found;
  };
  for (let i = 0; i < 60; ++i) {
    const d = [Math.sin(i), Math.cos(2 * i), Math.sin(5 * i + 1)];
    const [bound, all] = [most(hull, 0, d), most(points, 3, d)];
    assert.ok(bound <= all && bound > 0.95 * all, `${bound} of ${all}`);
  }
  assert.equal(farthest(new Float32Array(), new Uint32Array()).length, 0);
});
