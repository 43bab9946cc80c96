#!/usr/bin/env node
// Shows how seams look: a picture of each mesh from four sides beside its layout, with measures of
// them.
// Usage: npm run bench:seams -- FOLDER MESH... [-- options of abflat unwrap]
// A mesh is a file, or a name of `npm run bench:meshes`.
// Writes FOLDER/NAME.png: the layout, the mesh from the front and from the right; from above, from
// the left and from behind. Seams are red, boundaries blue.

import { existsSync, mkdirSync, rmSync } from 'node:fs';
import { join, parse } from 'node:path';
import { buildNative } from '../../scripts/build.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { measureLayout } from './support/layout_measures.mjs';
import { meshName, writeMesh } from './support/mesh_files.mjs';
import { printTable } from './support/results.mjs';
import { seamPainter } from './support/seam_sheets.mjs';
import { unwrapped } from './support/unwrap_runs.mjs';

const COLUMNS = [
  ['mesh', 'mesh'],
  ['charts', 'charts'],
  ['seam3', 'seam3', 2],
  ['SD/4', 'sd', 4],
  ['compactness', 'compactness', 3],
  ['turning', 'turning', 1],
  ['valid', (row) => (row.valid ? 'yes' : 'NO')],
];

const LEGEND = `
seam3: length of chart outlines on the surface over the root of its area; compactness: 4 pi A / P^2 of charts in the layout, mean by area;
turning: radians that seams turn by, for a length of the root of the surface's area (finer meshes have more)`;

function argumentsOf(args) {
  const end = args.indexOf('--');
  const [folder, ...meshes] = end < 0 ? args : args.slice(0, end);
  if (meshes.length === 0)
    throw new Failure('Usage: npm run bench:seams -- FOLDER MESH... [-- options of abflat unwrap]');
  const missing = meshes.find((mesh) => !existsSync(mesh) && !meshName(mesh));
  if (missing) throw new Failure(`There is no file ${missing}.`);
  return { folder, meshes, options: end < 0 ? [] : args.slice(end + 1) };
}

await runMain(async () => {
  const { folder, meshes, options } = argumentsOf(process.argv.slice(2));
  await buildNative();
  mkdirSync(folder, { recursive: true });
  const painter = await seamPainter();
  const rows = [];
  try {
    for (const mesh of meshes) {
      const file = existsSync(mesh) ? mesh : (await writeMesh(mesh))?.path;
      if (!file) continue;
      const { name } = parse(file);
      const output = join(folder, `${name}-uv.obj`);
      const { report, layout } = await unwrapped(file, output, options, 1);
      rmSync(output);
      const picture = join(folder, `${name}.png`);
      await painter.draw(layout, picture);
      console.log(picture);
      rows.push({ mesh: name, valid: report.valid, ...measureLayout(layout) });
    }
  } finally {
    await painter.close();
  }
  console.log('');
  printTable(COLUMNS, rows);
  console.log(LEGEND);
});
