// Which figures the benchmark against published results marks, and which of its runs it picks.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import {
  mostStretched,
  publishedOptCuts,
  publishedUnwrappers,
  withoutOptions,
  worseThanOptCuts,
  worseThanPartUv,
} from './support/published.mjs';

const partUv = { seconds: 10, charts: 6, seam: 11, area: 1.2, areaOverall: 1.1, angular: 0.99 };

test('as good as PartUV is not worse; each column is marked by itself', () => {
  const equal = { ...partUv, seconds: 1, angular: 0.976 };
  assert.deepEqual(worseThanPartUv(equal, partUv), []);
  const worse = { seconds: 1.1, charts: 7, seam: 11.1, area: 1.21, areaOverall: 1.11 };
  for (const [key, value] of Object.entries({ ...worse, angular: 0.974 }))
    assert.deepEqual(worseThanPartUv({ ...equal, [key]: value }, partUv), [key]);
});

test('beside OptCuts seams may be a fifth longer, at no more energy, in a 50th of its time', () => {
  const optCuts = { seconds: 50, charts: 1, seam3: 5, sd: 1.025 };
  const good = { seconds: 0.9, charts: 4, seam3: 5.9, sd: 1.025 };
  assert.deepEqual(worseThanOptCuts(good, optCuts), []);
  for (const [key, value] of Object.entries({ seconds: 1.1, seam3: 6.1, sd: 1.0251 }))
    assert.deepEqual(worseThanOptCuts({ ...good, [key]: value }, optCuts), [key]);
});

test('the largest bound is taken that is stretched no more; else what is stretched least', () => {
  const runs = [
    { maxStretch: 1.02, sd: 1.02 },
    { maxStretch: 1.03, sd: 1.024 },
    { maxStretch: 1.025, sd: 1.026 },
  ];
  assert.equal(mostStretched(runs, { sd: 1.025 }).maxStretch, 1.03);
  assert.equal(mostStretched(runs, { sd: 1.022 }).maxStretch, 1.02);
  assert.equal(mostStretched(runs, { sd: 1.001 }).maxStretch, 1.02);
});

test('options are left out with their values', () => {
  const args = ['--balance', '0.2', '--threads', '1', '--max-stretch=1.02', '--udim'];
  const rest = withoutOptions(args, ['--balance', '--max-stretch']);
  assert.deepEqual(rest, ['--threads', '1', '--udim']);
});

test('every published row has a number in every column', () => {
  const unwrappers = publishedUnwrappers();
  const optCuts = publishedOptCuts();
  for (const { source } of [unwrappers, optCuts]) assert.match(source, /SIGGRAPH/);
  for (const { mesh, rows } of unwrappers.tables) {
    assert.equal(rows[0].program, 'PartUV', mesh);
    for (const row of rows)
      for (const column of Object.keys(partUv)) assert.ok(row[column] > 0, `${mesh} ${column}`);
  }
  for (const { mesh, ...row } of optCuts.rows)
    for (const column of ['seconds', 'charts', 'seam3', 'sd'])
      assert.ok(row[column] > 0, `${mesh} ${column}`);
});

test('without the meshes it says what is skipped', (context) => {
  const folder = tempFolder(context)();
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    ['tests/bench/published_bench.mjs'],
    { cwd: ROOT, encoding: 'utf8', env: { ...process.env, ABFLAT_PUBLISHED_MESHES: folder } },
  );
  assert.equal(status, 0, stdout + stderr);
  assert.match(stdout, /skipped: .*homer\.obj, which does not exist/);
});
