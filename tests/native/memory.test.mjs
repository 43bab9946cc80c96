// Peak memory of a run, from its own report: the difference between two sizes, so that what every
// run needs does not count.

import assert from 'node:assert/strict';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import * as surfaces from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const MEGABYTE = 2 ** 20;

/** Bytes at the peak, not counting the texts that are read and written. */
async function peakOf(at, text, ...options) {
  writeFileSync(at('in.obj'), text);
  const args = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json', ...options];
  const run = await runAbflat(args, { cwd: at() });
  assert.deepEqual([run.code, run.stderr], [0, '']);
  const { peakMemory } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  return peakMemory.write * MEGABYTE - statSync(at('in.obj')).size - statSync(at('out.obj')).size;
}

const identicalFaces = (count) => `v 0 0 0\nv 1 0 0\nv 0 1 0\n${'f 1 2 3\n'.repeat(count)}`;

for (const [name, textOf] of [
  ['loose triangles', (n) => surfaces.objText(surfaces.triangleSoup(n))],
  ['identical faces', identicalFaces],
])
  test(`a chart of one triangle takes little memory: ${name}`, {
    skip: isInstrumented,
  }, async (t) => {
    const at = tempFolder(t);
    const few = 10_000;
    const many = 40_000;
    const before = await peakOf(at, textOf(few));
    const perChart = ((await peakOf(at, textOf(many))) - before) / (many - few);
    assert.ok(perChart < 1250, `${perChart} bytes`);
  });
