// The steps of each command grow little faster than the mesh. Steps are basic blocks of the core, so
// that results are the same on every machine and do not depend on time.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';
import { BUILD } from '../../scripts/lib/paths.mjs';

const PROGRAM = join(BUILD, 'steps/tests/abflat_scaling');
/** So far apart that it hardly counts where between them something else begins to be worth trying. */
const FACES = 12000;
const TIMES = 8;
const EXPONENT = 1.3;
/** Steps that a mesh of any size may take in addition: clearing tables, first attempts. */
const FREE_STEPS = 2e6;

const rows = JSON.parse(
  execFileSync(PROGRAM, [String(FACES), String(TIMES)], { encoding: 'utf8', maxBuffer: 1e8 }),
);

/** The stages of a command as one: what is tried in which of them depends on the size. */
function commandsOf(family) {
  const sums = new Map();
  for (const { stage, faces, steps } of rows.filter((row) => row.family === family)) {
    const command = stage.replace(/^(unwrap|flatten) .*/, '$1');
    const sum = sums.get(command) ?? { command, faces, steps: [0, 0] };
    sums.set(command, { ...sum, steps: sum.steps.map((count, i) => count + steps[i]) });
  }
  return [...sums.values()];
}

for (const family of new Set(rows.map((row) => row.family)))
  test(`${family}: steps grow no faster than n^${EXPONENT}`, () => {
    for (const { command, faces, steps } of commandsOf(family)) {
      const most = FREE_STEPS + steps[0] * (faces[1] / faces[0]) ** EXPONENT;
      const exponent = Math.log(steps[1] / steps[0]) / Math.log(faces[1] / faces[0]);
      assert.ok(
        steps[1] <= most,
        `${command}: ${steps.join(' -> ')} steps for ${faces.join(' -> ')} faces, n^${exponent.toFixed(2)}`,
      );
    }
  });
