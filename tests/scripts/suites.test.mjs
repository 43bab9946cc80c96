// Totals are read from what the test runners actually print.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { run } from '../../scripts/lib/run.mjs';
import { catchTotals, tapTotals } from '../../scripts/lib/suites.mjs';

let folder;

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-suites-'));
});
after(() => rmSync(folder, { recursive: true }));

test('Catch2: all passed', () => {
  const text = 'Filters: x\nAll tests passed (1234 assertions in 56 test cases)\n';
  assert.deepEqual(catchTotals(text), { passed: 56, failed: 0, skipped: 0 });
  const one = 'All tests passed (1 assertion in 1 test case)\n';
  assert.deepEqual(catchTotals(one), { passed: 1, failed: 0, skipped: 0 });
});

test('Catch2: failures and skipped cases', () => {
  const v2 = 'test cases: 12 | 10 passed | 2 failed\nassertions: 99 | 97 passed | 2 failed\n';
  assert.deepEqual(catchTotals(v2), { passed: 10, failed: 2, skipped: 0 });
  const v3 = 'test cases:  4 | 1 passed | 1 failed | 2 skipped\nassertions: 2 | 1 passed\n';
  assert.deepEqual(catchTotals(v3), { passed: 1, failed: 1, skipped: 2 });
});

test('Catch2: a program that died before its summary has no totals', () => {
  assert.deepEqual(catchTotals('Segmentation fault\n'), { passed: 0, failed: 0, skipped: 0 });
});

test('node: TAP of a real run', async () => {
  const file = join(folder, 'sample.test.mjs');
  writeFileSync(
    file,
    `import { test } from 'node:test';
     test('passes', () => {});
     test('passes too', async (t) => { await t.test('inner', () => {}); });
     test('fails', () => { throw new Error('on purpose'); });
     test('skipped', { skip: true }, () => {});
     test('later', { todo: true }, () => {});`,
  );
  const args = ['--test', '--test-reporter=tap', file];
  const { code, output } = await run(process.execPath, args, {
    capture: true,
    env: { NODE_TEST_CONTEXT: undefined },
  });
  assert.equal(code, 1);
  assert.deepEqual(tapTotals(output), { passed: 3, failed: 1, skipped: 2 });
});
