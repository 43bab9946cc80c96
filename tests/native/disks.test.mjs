// Disks from harmless to hostile: the automatic t must always give a valid layout, a fixed t either
// a valid layout or the reason.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { generatedDisk, toObj } from '../support/disks.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { FOLDED_DISKS, judge, MILD_DISKS, sharedMesh, withoutShared } from '../support/shared.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const COUNT = isInstrumented ? 10 : 60;
const BOUNDS = isInstrumented ? [1.5, 0.98] : [2, 1.5, 1.05, 1, 0.98];
/** Flattens and checks that exit code, report and judge (if available) agree. */
async function flattened(at, input, t) {
  const args = ['flatten', input, '-o', 'out.obj', '--t', String(t), '--report', 'r.json'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  if (code === 4) {
    assert.equal(report.error.code, 'InfeasibleBound', stderr);
    return { code, report };
  }
  const [chart] = report.charts;
  assert.ok(code === 0 || code === 1, stderr);
  assert.equal(report.valid, code === 0);
  assert.equal(chart.problem === '', chart.valid);
  for (const key of ['angularDistortion', 'lengthDistortion', 'symmetricDirichlet'])
    if (chart.valid) assert.ok(Number.isFinite(chart[key]), key);
  if (!withoutShared) {
    const measured = judge(input.startsWith('/') ? input : at(input), at('out.obj'), 2);
    if (chart.valid) assert.deepEqual(measured.failures, []);
  }
  return { code, report };
}

describe(`${COUNT} generated disks`, () => {
  for (let n = 0; n < COUNT; n++) {
    const disk = generatedDisk(n);
    test(disk.name, async (t) => {
      const at = tempFolder(t);
      writeFileSync(at('in.obj'), toObj(disk));
      const { code, report } = await flattened(at, 'in.obj', 'auto');
      assert.equal(code, 0, report.charts?.[0].problem);
      assert.notEqual(report.charts[0].solver, 'tutte');
      // One fixed t per disk, varying from disk to disk.
      await flattened(at, 'in.obj', [2, 1.5, 1.05, 1, 0.98][n % 5]);
    });
  }
});

for (const file of [...MILD_DISKS, ...FOLDED_DISKS])
  test(`${file} at fixed and automatic t`, { skip: withoutShared }, async (t) => {
    assert.ok(existsSync(sharedMesh(file)));
    const at = tempFolder(t);
    for (const bound of BOUNDS) await flattened(at, sharedMesh(file), bound);
    const { code } = await flattened(at, sharedMesh(file), 'auto');
    assert.equal(code, 0);
  });
