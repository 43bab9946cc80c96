// Flattens generated and real disks, and checks what is reported.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { generatedDisk, toObj } from './disks.mjs';
import { runAbflat } from './run-abflat.mjs';
import { judge, withoutShared } from './shared.mjs';
import { tempFolder } from './temp-folder.mjs';

/** Flattens and checks that exit code, report and judge (if available) agree. */
export async function flattened(at, input, t) {
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

/** Tests with the generated disks of these numbers. */
export const testGeneratedDisks = (begin, end) =>
  describe(`generated disks ${begin} to ${end - 1}`, () => {
    for (let n = begin; n < end; n++) {
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
