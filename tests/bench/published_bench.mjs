#!/usr/bin/env node
// Compares unwrapping with the published figures of other programs, on the same public meshes: with
// PartUV's table, and with OptCuts at equal stretch.
// Usage: npm run bench:published -- [options of abflat unwrap]
// Meshes are in ABFLAT_PUBLISHED_MESHES, or in ../shared/meshes2. Without any of them, it measures
// others, of which no figures are published.

import { existsSync, mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from '../../scripts/build.mjs';
import { BUILD, ROOT } from '../../scripts/lib/paths.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { measureLayout } from './support/layout_measures.mjs';
import { writeMesh } from './support/mesh_files.mjs';
import {
  mostStretched,
  publishedOptCuts,
  publishedUnwrappers,
  withoutOptions,
  worseThanOptCuts,
  worseThanPartUv,
} from './support/published.mjs';
import { printTable } from './support/results.mjs';
import { unwrapped } from './support/unwrap_runs.mjs';

const MESHES = process.env.ABFLAT_PUBLISHED_MESHES ?? join(ROOT, '../shared/meshes2');
const FOLDER = join(BUILD, 'bench');
const REPEAT = 3;
/** Bounds on a chart's stretch, chosen for a mean over the mesh that is no higher than OptCuts'. */
const STRETCHES = [1.0225, 1.025, 1.0275, 1.03];
/** OptCuts only cuts to reduce stretch, not for packing. */
const AS_OPTCUTS = ['--balance', '1', '--min-utilization', '0'];

/** Options that the comparison with OptCuts sets itself. */
const OWN_OF_OPTCUTS = ['--balance', '--min-utilization', '--max-stretch'];

const marked = (key, digits) => (row) =>
  row[key] === undefined ? '-' : row[key].toFixed(digits) + (row.worse?.includes(key) ? '*' : ' ');
const valid = ['valid', (row) => ({ true: 'yes', false: 'NO' })[row.valid] ?? '-'];

const COLUMNS = [
  ['mesh', 'mesh'],
  ['program', 'program'],
  ['s', marked('seconds', 2)],
  ['charts', marked('charts', 0)],
  ['seam', marked('seam', 2)],
  ['area', marked('area', 3)],
  ['areaOverall', marked('areaOverall', 3)],
  ['angular', marked('angular', 3)],
  ['SD/4', 'sd', 4],
  ['compactness', 'compactness', 3],
  ['turning', 'turning', 1],
  valid,
];

const LEGEND = `
*: worse than PartUV's figure; of angular by more than 0.015, of s than a tenth
seam: length of chart outlines in the atlas as packed; area, areaOverall: mean of max(r, 1/r), r the area in the layout over that on the
surface, in relation to the chart and to the mesh; angular: 1 keeps right angles; compactness: 4 pi A / P^2 of charts in the layout, mean
by area; turning: radians that seams turn by, for a length of the root of the surface's area (finer meshes have more)`;

const OPTCUTS_COLUMNS = [
  ['mesh', 'mesh'],
  ['program', 'program'],
  ['s', marked('seconds', 2)],
  ['charts', marked('charts', 0)],
  ['seam3', marked('seam3', 2)],
  ['SD/4', marked('sd', 4)],
  ['max-stretch', 'maxStretch', 4],
  ['seam3 / OptCuts', (row) => row.ratios?.seam3, 2],
  ['charts / OptCuts', (row) => row.ratios?.charts, 2],
  ['OptCuts s / s', (row) => row.ratios && 1 / row.ratios.seconds, 0],
  ['compactness', 'compactness', 3],
  ['turning', 'turning', 1],
  valid,
];

const OPTCUTS_LEGEND = `
*: SD/4 above OptCuts', seam3 more than 1.2 times as long, or s more than a 50th
seam3: length of chart outlines on the surface over the root of its area, so that seams count twice`;

/** Some of the published meshes. */
const SOURCE = 'https://github.com/alecjacobson/common-3d-test-models';
const STAND_INS = ['bunny-4k+1', 'bunny-4k+2'];

const pathOf = (mesh) => join(MESHES, `${mesh}.obj`);

/** Prints a sentence if there is no such mesh. */
function isThere(mesh) {
  if (existsSync(pathOf(mesh))) return true;
  console.log(`skipped: ${pathOf(mesh)}, which does not exist`);
  return false;
}

async function measure(mesh, options, path = pathOf(mesh)) {
  const output = join(FOLDER, `${mesh}-uv.obj`);
  const { report, layout } = await unwrapped(path, output, options, REPEAT);
  rmSync(output);
  const seconds = report.timings.total;
  return { mesh, program: 'abflat', seconds, valid: report.valid, ...measureLayout(layout) };
}

async function besidePartUv(options) {
  const { source, tables } = publishedUnwrappers();
  const rows = [];
  for (const { mesh, rows: others } of tables.filter((table) => isThere(table.mesh))) {
    const row = await measure(mesh, options);
    row.worse = worseThanPartUv(
      row,
      others.find(({ program }) => program === 'PartUV'),
    );
    rows.push(row, ...others.map((other) => ({ mesh, ...other })));
  }
  if (rows.length === 0) return [];
  console.log(`\n${source}; abflat with ${options.join(' ') || 'its defaults'}\n`);
  printTable(COLUMNS, rows);
  console.log(LEGEND);
  return rows;
}

const geometricMean = (values) =>
  Math.exp(values.reduce((sum, x) => sum + Math.log(x), 0) / values.length);

function meanRow(rows) {
  const of = (key) => geometricMean(rows.map((row) => row.ratios[key]));
  const ratios = { seam3: of('seam3'), charts: of('charts'), seconds: of('seconds') };
  return { mesh: 'geometric mean', program: '-', ratios };
}

async function besideOptCuts(options) {
  const { source, rows: others } = publishedOptCuts();
  const rows = [];
  for (const other of others.filter(({ mesh }) => isThere(mesh))) {
    const runs = [];
    for (const maxStretch of STRETCHES) {
      const bound = [...AS_OPTCUTS, '--max-stretch', `${maxStretch}`];
      runs.push({ maxStretch, ...(await measure(other.mesh, [...options, ...bound])) });
    }
    const row = mostStretched(runs, other);
    row.worse = worseThanOptCuts(row, other);
    row.ratios = Object.fromEntries(
      ['seam3', 'charts', 'seconds'].map((key) => [key, row[key] / other[key]]),
    );
    rows.push(row, { program: 'OptCuts', ...other });
  }
  if (rows.length === 0) return [];
  const ours = rows.filter((row) => row.ratios);
  console.log(`\n${source}; abflat with ${[...options, ...AS_OPTCUTS].join(' ')}\n`);
  printTable(OPTCUTS_COLUMNS, [...rows, meanRow(ours)]);
  console.log(OPTCUTS_LEGEND);
  return ours;
}

async function standIns(options) {
  console.log(`\nno published mesh is in ${MESHES}; some are at ${SOURCE}\n`);
  const rows = [];
  for (const name of STAND_INS) {
    const { path } = await writeMesh(name);
    rows.push(await measure(name, options, path));
  }
  console.log('');
  printTable(COLUMNS, rows);
  console.log(LEGEND);
  return rows;
}

await runMain(async () => {
  const options = process.argv.slice(2).filter((arg) => arg !== '--');
  await buildNative();
  mkdirSync(FOLDER, { recursive: true });
  const rows = [
    ...(await besidePartUv(options)),
    ...(await besideOptCuts(withoutOptions(options, OWN_OF_OPTCUTS))),
  ];
  if (rows.length === 0) rows.push(...(await standIns(options)));
  const invalid = rows.filter((row) => row.valid === false).map((row) => row.mesh);
  if (invalid.length > 0) throw new Failure(`not valid: ${invalid.join(', ')}`);
});
