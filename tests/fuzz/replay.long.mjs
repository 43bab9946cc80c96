// The same for thousands of random meshes.

import { test } from 'node:test';
import { replayRandom } from './replay.mjs';

for (const target of ['unwrap', 'flatten', 'pack', 'verify'])
  test(`${target}: 5000 random meshes with random options`, () => replayRandom(target, 5000, 1000));
