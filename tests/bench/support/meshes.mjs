// The benchmarks' meshes, as OBJ files in build/bench.

import { existsSync, mkdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { cmakeBuild } from '../../../scripts/lib/cmake.mjs';
import { BUILD, ROOT } from '../../../scripts/lib/paths.mjs';
import { mustRun } from '../../../scripts/lib/run.mjs';
import { setup } from '../../../scripts/setup.mjs';

export const PROGRAM = join(BUILD, 'native/tests/abflat_flatten_bench');
/** The same with only the vector instructions that every x86-64 has. */
export const BASELINE = join(BUILD, 'native/tests/abflat_baseline_bench');
const FOLDER = join(BUILD, 'bench');
const FACE = join(ROOT, '../shared/meshes/face.obj');
/** Approximately, for face.obj. */
const BYTES_PER_FACE = 60;

export async function buildBench(targets = ['abflat_flatten_bench']) {
  await setup(['build']);
  await cmakeBuild('native', {
    settings: { ABFLAT_TESTS: 'ON' },
    targets,
  });
  mkdirSync(FOLDER, { recursive: true });
}

/** The meshes asked for: `{ name, faces, isHead, make }`; `make` writes the file and names it. */
export function benchMeshes({ sizes, levels }) {
  const write = (name, args) => async () => {
    const path = join(FOLDER, `${name}.obj`);
    await mustRun(PROGRAM, [...args, path]);
    return path;
  };
  const heads = sizes.map(({ name, faces }) => ({
    name,
    faces,
    isHead: true,
    make: write(name, ['make', String(faces)]),
  }));
  if (levels.length > 0 && !existsSync(FACE))
    console.log(`skipped: subdivisions of ${FACE}, which does not exist`);
  const faces = (existsSync(FACE) ? levels : []).map((level) => ({
    name: `face+${level}`,
    faces: (statSync(FACE).size / BYTES_PER_FACE) * 4 ** level,
    isHead: false,
    make: write(`face+${level}`, ['subdivide', FACE, String(level)]),
  }));
  return [...heads, ...faces];
}
