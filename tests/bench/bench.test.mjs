// The benchmark itself, on its smallest mesh, and what makes its --check fail.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { describe, test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { complaints } from './support/results.mjs';

const bench = (...args) =>
  spawnSync(process.execPath, ['tests/bench/bench.mjs', ...args], { cwd: ROOT, encoding: 'utf8' });

describe('results are valid and take no more Newton steps than recorded', () => {
  for (const t of [2, 1])
    test(`10 k faces at t = ${t}`, () => {
      const args = ['--sizes', '10k', '--scans', 'none', '--t', `${t}`, '--repeat', '1', '--check'];
      const { status, stdout, stderr } = bench(...args);
      assert.equal(status, 0, stdout + stderr);
      assert.match(stdout, /^head-10k +10040 /m);
      assert.match(stdout, /all results are valid, no iteration count grew/);
    });
});

test('invalid results and grown counts are complained about, and nothing else', () => {
  const recorded = { 'head-10k t=2': 3 };
  const row = { mesh: 'head-10k', t: 2, valid: true, iterations: 3, solve: 1e9 };
  assert.deepEqual(complaints([row, { ...row, iterations: 2 }], recorded), []);
  assert.deepEqual(complaints([{ ...row, mesh: 'head-1k', iterations: 99 }], recorded), []);
  assert.match(complaints([{ ...row, iterations: 4 }], recorded)[0], /4 Newton steps, 3 are/);
  assert.match(complaints([{ ...row, valid: false }], recorded)[0], /not valid/);
});

test('options that make no sense are refused with the list of options', () => {
  for (const args of [['--sizes', 'big'], ['--t', '0'], ['--scans', 'nose+1'], ['--fast']]) {
    const { status, stderr } = bench(...args);
    assert.equal(status, 1, args.join(' '));
    assert.match(stderr, /--sizes 10k,100k/);
  }
});
