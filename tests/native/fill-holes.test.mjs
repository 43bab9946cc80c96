// abflat unwrap: holes of charts are filled for flattening, or joined to the outer boundary by seams.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { chartsOf, complaints, parseObj } from '../support/atlas.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { judge, withoutShared } from '../support/shared.mjs';
import * as surfaces from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** No cuts for packing. */
const WHOLE = ['--min-utilization', '0'];

/** The report and the text of a run that is fine, including by the judge. */
async function unwrapped(t, surface, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), surfaces.objText(surface));
  const args = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json', ...WHOLE, ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  const text = readFileSync(at('out.obj'), 'utf8');
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.deepEqual(complaints(text), []);
  assert.equal(report.valid, true);
  assert.equal(chartsOf(parseObj(text)).count, report.charts.length);
  if (withoutShared) t.diagnostic(`not judged: ${withoutShared}`);
  else {
    const judged = judge(at('in.obj'), at('out.obj'));
    assert.deepEqual(judged.failures, []);
    assert.ok(Math.abs(judged.symmetricDirichlet - report.symmetricDirichlet) < 1e-3);
  }
  return report;
}

const held = ({ charts }) => charts.reduce((sum, { filledHoles }) => sum + filledHoles, 0);

for (const count of [1, 3, 6])
  test(`a sheet with ${count} windows is one chart without a seam`, async (t) => {
    const sheet = surfaces.windows(count);
    const filled = await unwrapped(t, sheet);
    assert.equal(filled.charts.length, 1);
    assert.equal(filled.seams.edges, 0);
    assert.equal(filled.seams.relativeLength, 0);
    assert.equal(filled.seams.filledHoles, count);
    assert.ok(filled.symmetricDirichlet < 1 + 1e-6);
    assert.ok(filled.angularDistortion < 1e-9);
    const cut = await unwrapped(t, sheet, '--fill-holes', 'never', '--seams', 'none');
    assert.equal(cut.charts.length, 1);
    assert.equal(cut.seams.filledHoles, 0);
    assert.ok(cut.seams.relativeLength > 0);
    assert.ok(filled.atlas.utilization > 0.98 * cut.atlas.utilization);
  });

test('windows that are far from star-shaped are filled, too', async (t) => {
  const isGone = (x, y) =>
    (x >= 5 && x < 35 && y >= 5 && y < 12) || (x >= 5 && x < 12 && y >= 5 && y < 35);
  const bent = (u, v) => [Math.sin(u), v, Math.cos(u)];
  const report = await unwrapped(t, surfaces.sheet(40, 40, bent, isGone));
  assert.equal(report.seams.edges, 0);
  assert.ok(report.symmetricDirichlet < 1.001);
});

test('the small end of a tube is filled where the tube is nearly flat, and cut open where not', async (t) => {
  const bowl = await unwrapped(
    t,
    surfaces.tube(0.3, (v) => 0.1 + 0.9 * v),
  );
  assert.equal(bowl.seams.filledHoles, 1);
  assert.equal(bowl.seams.edges, 0);
  assert.ok(bowl.symmetricDirichlet < 1.04);
  for (const seams of ['auto', 'none']) {
    const tube = await unwrapped(t, surfaces.tube(3), '--seams', seams);
    assert.equal(tube.charts.length, 1);
    assert.equal(tube.seams.filledHoles, 0);
    assert.ok(tube.symmetricDirichlet < 1.001);
  }
});

test('a hole in a tube costs no seam of its own', async (t) => {
  const isGone = (x, y) => x >= 20 && x < 24 && y >= 12 && y < 16;
  const whole = await unwrapped(t, surfaces.tube(3));
  const pierced = await unwrapped(t, surfaces.tube(3, undefined, isGone));
  assert.equal(pierced.charts.length, 1);
  assert.ok(pierced.seams.relativeLength < 1.02 * whole.seams.relativeLength);
});

test('always fills what stretches, never nothing', async (t) => {
  const tube = surfaces.tube(1.5);
  const always = await unwrapped(t, tube, '--seams', 'none', '--fill-holes', 'always');
  assert.equal(held(always), 1);
  assert.equal(always.seams.filledHoles, 1);
  assert.equal(always.seams.edges, 0);
  assert.ok(always.symmetricDirichlet > 1.04);
  const never = await unwrapped(t, surfaces.windows(2), '--seams', 'none', '--fill-holes', 'never');
  assert.equal(held(never), 0);
  assert.ok(never.seams.edges > 0);
});

test('islands with holes stay whole', async (t) => {
  const at = tempFolder(t);
  const text = surfaces.objText(surfaces.windows(2));
  const islands = text
    .replaceAll(/^v (\S+) (\S+) .*$/gm, '$&\nvt $1 $2')
    .replaceAll(/^f (\d+) (\d+) (\d+)$/gm, 'f $1/$1 $2/$2 $3/$3');
  writeFileSync(at('in.obj'), islands);
  const args = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json', '--seams', 'uv'];
  assert.equal((await runAbflat(args, { cwd: at() })).code, 0);
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.equal(report.seams.edges, 0);
  assert.equal(report.seams.filledHoles, 2);
});

test('small charts lie in the holes of large ones', async (t) => {
  const isGone = (x, y) => x >= 4 && x < 36 && y >= 4 && y < 36;
  const frame = surfaces.sheet(40, 40, (u, v) => [u, v, 0], isGone);
  const inner = surfaces.sheet(4, 4, (u, v) => [u / 2, v / 2, 0]);
  const alone = await unwrapped(t, frame);
  const both = await unwrapped(
    t,
    surfaces.together([
      [frame, [0, 0, 0]],
      [inner, [5, 0, 0]],
    ]),
  );
  assert.equal(both.charts.length, 2);
  assert.ok(both.atlas.utilization > 1.5 * alone.atlas.utilization);
});
