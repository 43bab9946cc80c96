#!/usr/bin/env node
// Writes the meshes that benchmarks use as OBJ files to build/bench, for other programs to read, and
// says where each is from.
// Usage: npm run bench:meshes -- [NAME...]   NAME+N is refined N times; without names: all

import { relative } from 'node:path';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { runMain } from '../../scripts/lib/run.mjs';
import { MESH_NAMES, writeMesh } from './support/mesh_files.mjs';

await runMain(async () => {
  const given = process.argv.slice(2);
  for (const name of given.length > 0 ? given : MESH_NAMES) {
    const mesh = await writeMesh(name);
    if (mesh) console.log(`  ${relative(ROOT, mesh.path)}`);
  }
});
