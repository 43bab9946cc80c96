// Runs abflat_replay, which does not need a fuzzer.

import assert from 'node:assert/strict';
import { dirname, join } from 'node:path';
import { run } from '../../scripts/lib/run.mjs';
import { PROGRAM } from '../support/run-abflat.mjs';

const REPLAY = join(dirname(PROGRAM), 'tests/abflat_replay');

/** Fails if a property does not hold; returns the last lines of output. */
export async function replay(...args) {
  const { code, output } = await run(REPLAY, args, { capture: true, seconds: 3000 });
  const said = output
    .split(/[\r\n]/)
    .slice(-5)
    .join('\n');
  assert.equal(code, 0, said);
  return said;
}

/** Random meshes with random options; runs with different seeds have different ones. */
export async function replayRandom(target, count, seed) {
  const said = await replay(target, '--random', String(count), '--seed', String(seed));
  const results = Number(said.match(/(\d+) with a result/)?.[1]);
  assert.ok(results > count / 4, said);
}
