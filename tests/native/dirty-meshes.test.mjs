// Surfaces as generators and scanners leave them: what they are made of, and that they unwrap.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dirtyMesh, KINDS_OF_DIRT } from '../support/dirty-meshes.mjs';
import { unwrapJudged } from '../support/unwrap-judged.mjs';

const FACES = 3000;

/** How many edges have one face, two, three, ...: `[undefined, ones, twos, ...]`. */
function edgesByFaces({ faces }) {
  const count = new Map();
  for (const face of faces)
    for (const [k, a] of face.entries()) {
      const b = face[(k + 1) % 3];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      count.set(key, (count.get(key) ?? 0) + 1);
    }
  const out = [];
  for (const n of count.values()) out[n] = (out[n] ?? 0) + 1;
  return out;
}

test('each kind of dirt is what it says', () => {
  const clean = dirtyMesh(FACES, 'clean');
  assert.ok(edgesByFaces(clean)[2] > 0.999 * 1.5 * clean.faces.length);
  assert.ok(Math.abs(clean.faces.length / FACES - 1) < 0.1);
  assert.deepEqual(dirtyMesh(FACES, 'staircase').faces, clean.faces);
  const fins = edgesByFaces(dirtyMesh(FACES, 'fins'));
  assert.ok(fins[3] > 50 && fins[4] > 50);
  assert.ok(edgesByFaces(dirtyMesh(FACES, 'sheets'))[3] > 10);
  assert.ok(edgesByFaces(dirtyMesh(FACES, 'duplicates'))[3] > 100);
  const specks = dirtyMesh(FACES, 'specks');
  assert.equal(specks.faces.length - clean.faces.length, 8 * Math.ceil(clean.faces.length / 400));
});

for (const kind of [...KINDS_OF_DIRT, 'all'])
  test(`dirt of kind ${kind} unwraps`, async (t) => {
    const { report } = await unwrapJudged(t, dirtyMesh(FACES, kind), '--resolution', '512');
    assert.ok(report.valid);
  });

/** Charts, seams and how full the tile is, for one kind of dirt on the same figure. */
async function measured(t, kind) {
  const { report } = await unwrapJudged(t, dirtyMesh(20_000, kind), '--resolution', '512');
  return {
    charts: report.charts.length,
    joints: report.repair.nonManifoldEdges.length,
    seams: report.seams.relativeLength,
    utilization: report.atlas.utilization,
  };
}

test('steps of voxels cost hardly any charts and seams', async (t) => {
  const [clean, steps] = [await measured(t, 'clean'), await measured(t, 'staircase')];
  assert.ok(steps.charts <= 2 * clean.charts, `${steps.charts} and ${clean.charts}`);
  assert.ok(steps.seams <= 1.5 * clean.seams, `${steps.seams} and ${clean.seams}`);
});

test('a surface goes on below its fins', async (t) => {
  const { charts, joints } = await measured(t, 'fins');
  assert.ok(charts < joints / 4, `${charts} charts, ${joints} edges of more than two faces`);
});

test('specks find a place between the charts', async (t) => {
  const [clean, specks] = [await measured(t, 'clean'), await measured(t, 'specks')];
  assert.ok(specks.utilization > 0.7 * clean.utilization);
});
