#!/usr/bin/env node
// Time and memory from file to file for several sizes, compared with one factorisation of a
// Laplacian.
// Usage: npm run bench -- [--sizes 10k,100k] [--repeat N] [--csv [FILE]] [--check]; see --help

import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { Failure, run, runMain } from '../../scripts/lib/run.mjs';
import { benchMeshes } from './support/meshes.mjs';
import { benchOptions } from './support/options.mjs';
import { buildBench, PROGRAM } from './support/program.mjs';
import {
  appendCsv,
  complaints,
  exponent,
  printTable,
  STAGES,
  totalOf,
} from './support/results.mjs';

const CSV = join(ROOT, 'tests/bench/results/native.csv');
const RECORDED = join(ROOT, 'tests/bench/recorded.json');
/** The yardsticks run on one thread, as we do in all but one column. */
const ENV = { OPENBLAS_NUM_THREADS: '1', OMP_NUM_THREADS: '1' };

const KEYS = [
  ...['mesh', 'faces', 'vertices', 't', 'repeat', ...STAGES, 'linear', 'iterations', 'residual'],
  ...['solveOnTwo', 'identical'],
  ...['fallbacks', 'valid', 'memoryMB', 'u', 'uNumeric', 'e', 'eNumeric', 'own', 'ownNumeric'],
  'compiler',
];

const COLUMNS = [
  ['mesh', 'mesh'],
  ['faces', 'faces'],
  ...STAGES.map((stage) => [`${stage}/s`, stage, 3]),
  ['total/s', totalOf, 3],
  ['peak MB', 'memoryMB', 0],
  ['steps', 'iterations'],
  ['residual', 'residual'],
  ['valid', (row) => (row.valid ? 'yes' : 'NO')],
  ['U/s', 'u', 3],
  ["U'/s", 'uOrdered', 3],
  ['E/s', 'e', 3],
  ['own/s', 'own', 3],
  ['solve/U', (row) => row.u && row.solve / row.u, 2],
  ["solve/U'", (row) => row.u && row.solve / row.uOrdered, 2],
  ['solve/E', (row) => row.solve / row.e, 2],
  ['solve/own', (row) => row.solve / row.own, 2],
  ['1/2 threads', (row) => row.solveOnTwo && row.solve / row.solveOnTwo, 2],
  ['same bytes', (row) => ({ true: 'yes', false: 'NO' })[row.identical]],
  [
    'io+check',
    (row) => `${((100 * (row.read + row.check + row.write)) / totalOf(row)).toFixed(0)}%`,
  ],
];

async function measure(mesh, { t, repeatFor }) {
  const made = await mesh.make();
  if (!made) return [];
  const { path, faces } = made;
  const args = ['run', path, String(t), String(repeatFor(faces))];
  const { code, output } = await run(PROGRAM, args, { capture: true, env: ENV });
  rmSync(path);
  if (code !== 0) throw new Failure(`${mesh.name}: ${output.trim()}`);
  return [{ mesh: mesh.name, ...JSON.parse(output) }];
}

function printExponents(rows) {
  const heads = rows.filter((row) => row.mesh.startsWith('head-'));
  if (heads.length < 2) return;
  const shown = ['solve', 'total', 'memory', 'own'].map((name, i) => {
    const of = [(row) => row.solve, totalOf, (row) => row.memoryMB, (row) => row.own][i];
    return `${name} ${exponent(heads, of).toFixed(2)}`;
  });
  console.log(`\nexponents over the heads: ${shown.join(', ')}`);
}

await runMain(async () => {
  const options = benchOptions(process.argv.slice(2), CSV);
  if (!options) return;
  await buildBench();
  const rows = [];
  for (const mesh of benchMeshes(options)) {
    console.log(`measuring ${mesh.name}`);
    rows.push(...(await measure(mesh, options)));
  }
  console.log('');
  printTable(COLUMNS, rows);
  console.log(`
U: ordering by METIS, supernodal factorisation and one solution of the V x V Laplacian by CHOLMOD
U': the same without ordering and analysis, for who has them at hand
E, own: ordering, factorisation and one solution by Eigen (AMD) and abflat`);
  printExponents(rows);
  if (options.csv) appendCsv(options.csv, KEYS, rows);
  if (!options.check) return;
  const wrong = complaints(rows, JSON.parse(readFileSync(RECORDED, 'utf8')));
  if (wrong.length > 0) throw new Failure(wrong.join('\n'));
  console.log('all results are valid, no iteration count grew');
});
