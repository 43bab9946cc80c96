// The steps of each stage grow little faster than the mesh. Steps are basic blocks of the core, so
// that results are the same on every machine and do not depend on time.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';
import { BUILD } from '../../scripts/lib/paths.mjs';

const PROGRAM = join(BUILD, 'steps/tests/abflat_scaling');
/**
 * Large enough to be past the size at which things are tried and then given up for something else.
 */
const FACES = 6000;
const TIMES = 4;
const EXPONENT = 1.3;
/** Steps that a mesh of any size may take in addition: clearing tables, first attempts. */
const FREE_STEPS = 2e6;

const rows = JSON.parse(
  execFileSync(PROGRAM, [String(FACES), String(TIMES)], { encoding: 'utf8', maxBuffer: 1e8 }),
);

for (const family of new Set(rows.map((row) => row.family)))
  test(`${family}: steps grow no faster than n^${EXPONENT}`, () => {
    for (const { stage, faces, steps } of rows.filter((row) => row.family === family)) {
      const most = FREE_STEPS + steps[0] * (faces[1] / faces[0]) ** EXPONENT;
      const exponent = Math.log(steps[1] / steps[0]) / Math.log(faces[1] / faces[0]);
      assert.ok(
        steps[1] <= most,
        `${stage}: ${steps.join(' -> ')} steps for ${faces.join(' -> ')} faces, n^${exponent.toFixed(2)}`,
      );
    }
  });
