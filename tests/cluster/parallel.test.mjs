// The recipe for GNU parallel: parts together are the whole, and one that failed is done again.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { PROGRAM } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { filesOf, manifestOf, plainRun, RECIPES, run, writeMeshes } from './support/batches.mjs';

const isThere = spawnSync('parallel', ['--version'], { encoding: 'utf8' }).stdout?.includes('GNU');
const skip = isThere ? false : 'there is no GNU parallel';
const RECIPE = join(RECIPES, 'parallel.sh');

test('parts, of which one fails at first', { skip }, async (t) => {
  const at = tempFolder(t);
  writeMeshes(at('meshes'), 16);
  const whole = await plainRun(at('meshes'), at('whole'));
  // Part 1 cannot start the program the first time.
  writeFileSync(
    at('abflat'),
    `#!/bin/sh\ncase "$*" in *1/3*) [ -e '${at('seen')}' ] || { : > '${at('seen')}'; exit 70; } ;; esac\nexec '${PROGRAM}' "$@"\n`,
  );
  chmodSync(at('abflat'), 0o755);
  const recipe = () =>
    run(RECIPE, ['3', at('meshes'), at('out'), '--padding', '4'], {
      env: { ABFLAT: at('abflat') },
    });
  const first = await recipe();
  assert.equal(first.code, 75, first.stderr);
  assert.match(first.stderr, /some parts failed/);
  const again = await recipe();
  assert.equal(again.code, 1, again.stderr); // a mesh is broken
  const jobs = readFileSync(at('out/joblog'), 'utf8').trim().split('\n').slice(1);
  const codes = jobs.map((line) => line.split('\t')[6]);
  assert.deepEqual(codes.sort(), ['0', '0', '0', '70']);
  assert.deepEqual(
    manifestOf(at('out')).map(({ name, status }) => [name, status]),
    whole.lines.map(({ name, status }) => [name, status]),
  );
  assert.deepEqual(filesOf(at('out')), whole.files);
});
