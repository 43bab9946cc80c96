// Whatever the package is called with, it returns a result or says in a sentence why not, takes
// nothing that it was not given, and still works afterwards. Bugs found by fuzzing stay fixed.
// `node tests/fuzz/javascript/replay.mjs SEED` shows the calls of a failure.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Calls } from '../fuzz/javascript/fuzz-calls.mjs';
import { ROOT } from './support/paths.mjs';

const SEEDS = 400;

let calls;
before(async () => {
  calls = await Calls.start();
});
after(() => calls.end());

async function runAgain(finding) {
  const { failure, results } = await calls.run(finding);
  if (failure) assert.fail(`${JSON.stringify(finding)}: ${failure.message}`);
  return results;
}

test(`${SEEDS} seeds of random calls`, async () => {
  let results = 0;
  for (let seed = 0; seed < SEEDS; ++seed) results += await runAgain({ seed });
  assert.ok(results > SEEDS / 8, `only ${results} calls have a result`);
});

const folder = join(ROOT, 'tests/fuzz/findings/javascript');
for (const name of existsSync(folder) ? readdirSync(folder).sort() : [])
  test(`${name} stays mended`, () =>
    runAgain(JSON.parse(readFileSync(join(folder, name), 'utf8'))));
