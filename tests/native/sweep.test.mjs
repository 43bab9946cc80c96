// The sweep command: the same mesh for several t.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseCsv } from '../support/csv.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import { grid, TETRAHEDRON } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

test('a table has one row for each t, also for one that is not possible', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  const run = await runAbflat(['sweep', 'in.obj', '--t', '2,1,auto,0.2'], { cwd: at() });
  assert.deepEqual([run.code, run.stderr], [0, '']);
  const rows = run.stdout.trimEnd().split('\n').slice(1);
  assert.deepEqual(
    rows.map((row) => row.trim().split(/\s+/)[0]),
    ['2', '1', 'auto', '0.2'],
  );
  for (const row of rows.slice(0, 3)) assert.match(row, /valid$/);
  assert.match(rows[3], /t must be at least/);
});

test('CSV: distortion grows as t falls', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  const run = await runAbflat(['sweep', 'in.obj', '--csv', 'out.csv'], { cwd: at() });
  assert.deepEqual([run.code, run.stdout, run.stderr], [0, '', '']);
  const rows = parseCsv(readFileSync(at('out.csv'), 'utf8'));
  assert.deepEqual(
    rows.map((row) => row.t),
    ['2', '1.05', '1', '0.968'],
  );
  const angular = rows.map((row) => Number(row['angular distortion']));
  for (let i = 1; i < angular.length; i++) assert.ok(angular[i] >= angular[i - 1]);
  assert.ok(rows.every((row) => row.valid === 'true' && row.problem === ''));
});

test('balances are combined with every t; alone with auto; stretch falls as they grow', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(8));
  const swept = async (...args) =>
    parseCsv((await runAbflat(['sweep', 'in.obj', ...args, '--csv', '-'], { cwd: at() })).stdout);
  const rows = await swept('--balance', '0,0.25,0.5,1');
  assert.deepEqual(
    rows.map((row) => [row.t, row.balance]),
    ['0', '0.25', '0.5', '1'].map((balance) => ['auto', balance]),
  );
  const stretch = rows.map((row) => Number(row['symmetric Dirichlet']));
  const angular = rows.map((row) => Number(row['angular distortion']));
  for (let i = 1; i < rows.length; i++) {
    assert.ok(stretch[i] < stretch[i - 1], `${stretch}`);
    assert.ok(angular[i] > angular[i - 1], `${angular}`);
  }
  assert.ok(rows.every((row) => row.valid === 'true'));
  assert.deepEqual(
    (await swept('--t', '2,1', '--balance', '0,1')).map((row) => [row.t, row.balance]),
    [
      ['2', '0'],
      ['2', '1'],
      ['1', '0'],
      ['1', '1'],
    ],
  );
});

test('wrong lists, meshes and targets have their exit codes', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(3));
  writeFileSync(at('closed.off'), TETRAHEDRON);
  const code = async (...args) => (await runAbflat(['sweep', ...args], { cwd: at() })).code;
  assert.equal(await code('in.obj', '--t', '1,,2'), 2);
  assert.equal(await code('in.obj', '--t', '1,wide'), 2);
  assert.equal(await code('in.obj', '--t', '0'), 2);
  for (const list of ['', '1.5', '-0.1', 'auto', '0,,1'])
    assert.equal(await code('in.obj', `--balance=${list}`), 2, list);
  assert.equal(await code('missing.obj'), 3);
  assert.equal(await code('closed.off', '--csv', 'out.csv'), 4);
  assert.equal(existsSync(at('out.csv')), false);
  assert.equal(await code('in.obj', '--csv', 'no/such/folder.csv'), 5);
});

/** Table 2 of the paper to the digits that an exact solution has. */
const EXACT = {
  'nefertiti.off': [
    [0.0017, 0.0132],
    [0.00216, 0.0175],
    [0.00252, 0.0181],
    [0.00298, 0.0192],
  ],
  'body.off': [
    [0.01135, 1.6502],
    [0.01139, 1.6675],
    [0.01144, 1.6776],
    [0.01147, 1.6918],
  ],
};

for (const [file, wanted] of Object.entries(EXACT))
  test(`${file}: table 2 of the paper`, { skip: withoutShared }, async () => {
    const run = await runAbflat(['sweep', sharedMesh(file), '--csv', '-']);
    assert.equal(run.code, 0, run.stderr);
    for (const [i, row] of parseCsv(run.stdout).entries()) {
      assert.equal(Number(row['angular distortion']).toFixed(5), wanted[i][0].toFixed(5));
      assert.equal(Number(row['length distortion']).toFixed(4), wanted[i][1].toFixed(4));
    }
  });
