// Delaunay layouts, checked with integers on the texcoords exactly as they are in the file.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { runAbflat } from '../support/run-abflat.mjs';
import { judge, sharedMesh, withoutShared } from '../support/shared.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** Every double of a layout is an integer multiple of 1 / UNITS. */
const UNITS = 2 ** 200;

/** Texcoords as integers, and triangles as triples of texcoord numbers. */
function readLayout(path) {
  const points = [];
  const triangles = [];
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const [key, ...words] = line.trim().split(/\s+/);
    if (key === 'vt') points.push(words.slice(0, 2).map((word) => BigInt(Number(word) * UNITS)));
    if (key === 'f') triangles.push(words.map((word) => Number(word.split('/')[1]) - 1));
  }
  return { points, triangles };
}

/** Above 0 if d lies inside the circle through a, b, c, which are in counter-clockwise order. */
function inCircle(a, b, c, d) {
  const rows = [a, b, c].map(([x, y]) => [x - d[0], y - d[1]]);
  const lift = rows.map(([x, y]) => x * x + y * y);
  const minor = (i, j) => rows[i][0] * rows[j][1] - rows[i][1] * rows[j][0];
  return lift[0] * minor(1, 2) + lift[1] * minor(2, 0) + lift[2] * minor(0, 1);
}

function countEdges({ points, triangles }) {
  const opposite = new Map();
  for (const v of triangles)
    for (let k = 0; k < 3; k++)
      opposite.set(`${v[k]} ${v[(k + 1) % 3]}`, { face: v, apex: v[(k + 2) % 3] });
  let edges = 0;
  let violated = 0;
  for (const [key, { face }] of opposite) {
    const [from, to] = key.split(' ').map(Number);
    const other = opposite.get(`${to} ${from}`);
    if (!other || from > to) continue;
    edges++;
    if (inCircle(...face.map((v) => points[v]), points[other.apex]) > 0n) violated++;
  }
  return { edges, violated };
}

async function flattened(at, input, ...options) {
  const args = ['flatten', input, '-o', 'out.obj', '--report', 'r.json', ...options];
  const run = await runAbflat(args, { cwd: at() });
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  return { run, report, counted: countEdges(readLayout(at('out.obj'))) };
}

async function checkDelaunay(at, input) {
  const plain = await flattened(at, input);
  assert.equal(plain.report.charts[0].delaunay, null);
  const { run, report, counted } = await flattened(at, input, '--delaunay');
  assert.deepEqual([run.code, run.stderr], [0, '']);
  const [{ delaunay, angularDistortion }] = report.charts;
  assert.deepEqual(delaunay.resisting, []);
  assert.equal(delaunay.edges, counted.edges);
  assert.equal(delaunay.violatedBefore, plain.counted.violated);
  assert.deepEqual([delaunay.violated, counted.violated], [0, 0]);
  const before = plain.report.charts[0].angularDistortion;
  assert.ok(Math.abs(delaunay.angularDistortionBefore - before) < 1e-9);
  assert.ok(angularDistortion >= before - 1e-9);
}

for (const name of ['head', 'three-balls', 'alpha-band', 'hemisphere'])
  test(`the sample ${name} becomes Delaunay`, async (t) => {
    const at = tempFolder(t);
    await runAbflat(['sample', name, '-o', 'in.obj'], { cwd: at() });
    await checkDelaunay(at, 'in.obj');
  });

for (const file of [
  'nefertiti.off',
  'hemisphere.obj',
  'body.off',
  'cathead.obj',
  'mannequin.off',
  'camel-cut.obj',
])
  test(`${file} becomes Delaunay`, { skip: withoutShared }, async (t) => {
    const at = tempFolder(t);
    await checkDelaunay(at, sharedMesh(file));
    const measured = judge(sharedMesh(file), at('out.obj'));
    assert.deepEqual(measured.failures, []);
  });

test('a free boundary under the adjacent condition stays below a full turn', {
  skip: withoutShared,
}, async (t) => {
  const at = tempFolder(t);
  const free = await flattened(at, sharedMesh('cow-cut.off'), '--t', '2');
  const bounded = await flattened(at, sharedMesh('cow-cut.off'), '--t', '2', '--adjacent');
  assert.ok(free.report.charts[0].maxBoundaryAngle > 2 * Math.PI);
  assert.ok(bounded.report.charts[0].maxBoundaryAngle < 2 * Math.PI);
});
