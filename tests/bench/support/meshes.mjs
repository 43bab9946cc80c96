// The meshes of the benchmarks that flatten.

import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { mustRun } from '../../../scripts/lib/run.mjs';
import { writeMesh } from './mesh_files.mjs';
import { FOLDER, PROGRAM } from './program.mjs';

/**
 * The meshes asked for: `{ name, make }`. `make` writes the file and resolves to `{ path, faces }`,
 * to undefined if it is made of a mesh that is missing.
 */
export function benchMeshes({ sizes, scans }) {
  const heads = sizes.map(({ name, faces }) => ({
    name,
    make: async () => {
      const path = join(FOLDER, `${name}.obj`);
      await mustRun(PROGRAM, ['make', String(faces), path]);
      return { path, faces };
    },
  }));
  return [...heads, ...scans.map(({ base, levels }) => scan(base, levels))];
}

/** A mesh whose faces are split into four `levels` times. */
function scan(base, levels) {
  const name = `${base}+${levels}`;
  const make = async () => {
    const coarse = await writeMesh(base);
    if (!coarse) return undefined;
    const path = join(FOLDER, `${name}.obj`);
    await mustRun(PROGRAM, ['subdivide', coarse.path, String(levels), path]);
    rmSync(coarse.path);
    return { path, faces: coarse.faces * 4 ** levels };
  };
  return { name, make };
}
