// Blocks, rooms, drilled plates, turned parts, window frames, scans: at the default the layout is
// valid, however vertices are numbered, and no chart is stretched more than allowed without a word.
// ABFLAT_ORDINARY_RUNS=400 makes more of each kind.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { judgeFile } from '../support/exact-atlas.mjs';
import { PARTS } from '../support/made-parts.mjs';
import { Random, surfaceText } from '../support/random-surfaces.mjs';
import { disguised, RIGHT_ANGLED } from '../support/right-angles.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const RUNS = Number(process.env.ABFLAT_ORDINARY_RUNS ?? (isInstrumented ? 3 : 16));
const FIRST = Number(process.env.ABFLAT_ORDINARY_SEED ?? 0);
const MAX_STRETCH = 1.02;
/** Of the excess over 1. */
const RUINED = 10;

/** What is wrong with the result; empty if nothing is. */
async function faultOf(at, output) {
  const args = ['unwrap', 'in.obj', '-o', output, '--report', 'r.json', '-q'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  if (code !== 0) return `exit ${code}: ${stderr}`;
  const { isValid, ...faults } = judgeFile(at(output));
  if (!isValid) return JSON.stringify(faults);
  const { charts, notes } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  const most = Math.max(...charts.map((chart) => chart.symmetricDirichlet));
  if (most > 1 + RUINED * (MAX_STRETCH - 1)) return `a chart has a stretch of ${most}`;
  const isSaid = notes.some((note) => note.includes('stretched by more'));
  return isSaid === most > MAX_STRETCH ? '' : `stretch ${most}, but ${JSON.stringify(notes)}`;
}

for (const [kind, make] of Object.entries({ ...RIGHT_ANGLED, ...PARTS }))
  test(`${kind} unwrap at the default`, async (t) => {
    for (let seed = FIRST; seed < FIRST + RUNS; seed++) {
      const at = tempFolder(t);
      const random = new Random(seed);
      writeFileSync(at('in.obj'), surfaceText(disguised(random, make(random))));
      const fault = await faultOf(at, seed % 3 === 2 ? 'out.glb' : 'out.obj');
      assert.equal(fault, '', `seed ${seed}`);
    }
  });
