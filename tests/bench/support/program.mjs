// The benchmark programs in C++.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { cmakeBuild } from '../../../scripts/lib/cmake.mjs';
import { BUILD } from '../../../scripts/lib/paths.mjs';
import { setup } from '../../../scripts/setup.mjs';

export const PROGRAM = join(BUILD, 'native/tests/abflat_flatten_bench');
/** The same with only the vector instructions that every x86-64 has. */
export const BASELINE = join(BUILD, 'native/tests/abflat_baseline_bench');
/** Where they find and leave meshes. */
export const FOLDER = join(BUILD, 'bench');

export async function buildBench(targets = ['abflat_flatten_bench']) {
  await setup(['build']);
  await cmakeBuild('native', {
    settings: { ABFLAT_TESTS: 'ON' },
    targets,
  });
  mkdirSync(FOLDER, { recursive: true });
}
