// Bugs found by fuzzing stay fixed, and random meshes with random options keep the properties that
// the fuzzers check. `abflat_replay TARGET --show SEED` shows the mesh of a failure.

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { replay, replayRandom } from './replay.mjs';
import { TARGET_NAMES } from './seeds.mjs';

for (const target of TARGET_NAMES) {
  const folder = join(ROOT, 'tests/fuzz/findings', target);
  const files = existsSync(folder) ? readdirSync(folder).map((name) => join(folder, name)) : [];
  if (files.length > 0)
    test(`${target}: ${files.length} findings stay mended`, () => replay(target, ...files));
}

for (const target of ['unwrap', 'flatten', 'pack', 'verify'])
  test(`${target}: 250 random meshes with random options`, () => replayRandom(target, 250, 1));
