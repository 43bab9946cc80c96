#!/usr/bin/env node
// Compares unwrapping with xatlas (the npm package watlas) on the same meshes, measured alike.
// Usage: npm run bench:unwrap -- [--meshes knot-90k,iso-64] [--threads 1] [--repeat 3]
// [--max-stretch 1.04] [--alone] [--csv [FILE]]

import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildNative } from '../../scripts/build.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { meshName, writeMesh } from './support/mesh_files.mjs';
import { withCsvFile } from './support/options.mjs';
import { appendCsv, printTable } from './support/results.mjs';
import { unwrapWithAbflat, unwrapWithXatlas } from './support/unwrap_runs.mjs';

const CSV = join(ROOT, 'tests/bench/results/unwrap.csv');
/** Closed and as large as scans; one is a scan with flaws. */
const MESHES = 'knot-90k,iso-64,bunny-4k+2,snowden,fertility+1,bunny+2,iso-128';
const STAGES = ['read', 'surface', 'seams', 'solve', 'pack', 'check', 'write'];
const MEASURES = ['seconds', 'charts', 'seamLength', 'symmetricDirichlet', 'utilization', 'lost'];
const KEYS = [
  ...['mesh', 'faces', 'threads', ...STAGES, ...MEASURES, 'valid'],
  ...MEASURES.map((key) => `xatlas ${key}`),
];

const COLUMNS = [
  ['mesh', 'mesh'],
  ['program', 'program'],
  ['faces', 'faces'],
  ['s', 'seconds', 2],
  ['charts', 'charts'],
  ['seam', 'seamLength', 2],
  ['SD/4', 'symmetricDirichlet', 4],
  ['utilisation', 'utilization', 3],
  ['lost', 'lost'],
  ['valid', (row) => ({ true: 'yes', false: 'NO' })[row.valid]],
  ...STAGES.map((stage) => [`${stage}/s`, stage, 2]),
];

const RATIOS = [
  ['mesh', 'mesh'],
  ['xatlas s / s', (row) => row['xatlas seconds'] / row.seconds, 1],
  ['charts', (row) => row.charts / row['xatlas charts'], 3],
  ['seam', (row) => row.seamLength / row['xatlas seamLength'], 3],
  ['SD/4 more by', (row) => row.symmetricDirichlet - row['xatlas symmetricDirichlet'], 4],
  ['utilisation', (row) => row.utilization / row['xatlas utilization'], 2],
  ['pack / (seams + solve)', (row) => row.pack / (row.seams + row.solve), 3],
];

const LEGEND = `
seam: length of all seams / root of the surface's area; SD/4: mean symmetric Dirichlet energy, 1 keeps all lengths
lost: triangles without area in the layout; s: abflat from file to file, xatlas (as WebAssembly) without files`;

function optionsOf(args) {
  const text = (value) => ({ type: 'string', default: value });
  const { values } = parseArgs({
    args: withCsvFile(args, CSV),
    options: {
      meshes: text(MESHES),
      threads: text('1'),
      repeat: text('3'),
      'max-stretch': text('1.04'),
      alone: { type: 'boolean', default: false },
      csv: { type: 'string' },
    },
  });
  const meshes = values.meshes.split(',');
  const unknown = meshes.find((name) => !meshName(name));
  if (unknown) throw new Failure(`there is no mesh "${unknown}"; known are ${MESHES}`);
  return { ...values, meshes };
}

async function measure(name, options) {
  const mesh = await writeMesh(name);
  if (!mesh) return [];
  const output = mesh.path.replace(/\.obj$/, '-uv.obj');
  const ours = await unwrapWithAbflat(mesh.path, output, {
    threads: options.threads,
    maxStretch: options['max-stretch'],
    repeat: Number(options.repeat),
  });
  const theirs = options.alone ? {} : await unwrapWithXatlas(mesh.path);
  for (const path of [mesh.path, output]) rmSync(path);
  const xatlas = Object.entries(theirs).map(([key, value]) => [`xatlas ${key}`, value]);
  const row = { mesh: name, faces: mesh.faces, threads: options.threads, ...ours };
  printTable(COLUMNS, [
    { ...row, program: 'abflat' },
    ...(options.alone ? [] : [{ ...theirs, mesh: name, faces: mesh.faces, program: 'xatlas' }]),
  ]);
  return [{ ...row, ...Object.fromEntries(xatlas) }];
}

async function main() {
  const options = optionsOf(process.argv.slice(2));
  await buildNative();
  const rows = [];
  for (const name of options.meshes) rows.push(...(await measure(name, options)));
  if (!options.alone) {
    console.log('');
    printTable(RATIOS, rows);
  }
  console.log(LEGEND);
  if (options.csv) appendCsv(options.csv, KEYS, rows);
  const invalid = rows.filter((row) => !row.valid).map((row) => row.mesh);
  if (invalid.length > 0) throw new Failure(`not valid: ${invalid.join(', ')}`);
}

await runMain(main);
