#!/usr/bin/env node
// Compares the npm package in Node and Chromium with the native program on the same meshes.
// Usage: npm run bench:wasm -- [options of npm run bench]

import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildWasm } from '../../scripts/build.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { Failure, run, runMain } from '../../scripts/lib/run.mjs';
import { benchMeshes } from './support/meshes.mjs';
import { benchOptions } from './support/options.mjs';
import { BASELINE, buildBench, PROGRAM } from './support/program.mjs';
import {
  appendCsv,
  complaints,
  exponent,
  printTable,
  STAGES,
  totalOf,
} from './support/results.mjs';
import { runInChromium, runInNode } from './support/wasm_runs.mjs';

const CSV = join(ROOT, 'tests/bench/results/wasm.csv');
const RECORDED = join(ROOT, 'tests/bench/recorded.json');

const KEYS = [
  ...['mesh', 'faces', 't', 'repeat', ...STAGES, 'call', 'iterations', 'residual', 'valid'],
  ...['memoryMB', 'nativeSolve', 'nativeTotal', 'baselineSolve', 'chromium'],
  ...['drift', 'node'],
];

const COLUMNS = [
  ['mesh', 'mesh'],
  ['faces', 'faces'],
  ...STAGES.map((stage) => [`${stage}/s`, stage, 3]),
  ['total/s', totalOf, 3],
  ['call/s', 'call', 3],
  ['peak MB', 'memoryMB', 0],
  ['steps', 'iterations'],
  ['residual', 'residual'],
  ['valid', (row) => (row.valid ? 'yes' : 'NO')],
];

const RATIOS = [
  ['mesh', 'mesh'],
  ['native solve/s', 'nativeSolve', 3],
  ['baseline solve/s', 'baselineSolve', 3],
  ['simd solve/s', 'solve', 3],
  ['simd/native', (row) => row.solve / row.nativeSolve, 2],
  ['simd/baseline', (row) => row.solve / row.baselineSolve, 2],
  ['native total/s', 'nativeTotal', 3],
  ['Chromium/s', 'chromium', 3],
  ['simd/native', (row) => totalOf(row) / row.nativeTotal, 2],
  ['Chromium/native', (row) => row.chromium && row.chromium / row.nativeTotal, 2],
  ['drift', 'drift', 2],
];

const LEGEND = `
native: the vectors of this machine; baseline: those of every x86-64
Chromium: a new browser each time, from loading the package to the OBJ text
drift: native solve after the other runs over before; ratios count where it is near 1`;

async function jsonOf(name, program, args) {
  const { code, output } = await run(program, args, { capture: true });
  if (code !== 0) throw new Failure(`${name}: ${output.trim()}`);
  return JSON.parse(output);
}

async function measure(mesh, { t, repeatFor }) {
  const made = await mesh.make();
  if (!made) return [];
  const { path, faces } = made;
  const repeat = repeatFor(faces);
  const args = [path, String(t), String(repeat)];
  const self = fileURLToPath(import.meta.url);
  const natively = (program) => jsonOf(mesh.name, program, ['plain', ...args]);
  // Measured before and after, to reveal whether the machine got busy in between.
  const before = await natively(PROGRAM);
  const simd = await jsonOf(mesh.name, process.execPath, [self, 'simd', ...args]);
  const chromium = findChrome() && (await runInChromium(path, { t, repeat }));
  const baseline = await natively(BASELINE);
  const after = await natively(PROGRAM);
  rmSync(path);
  const row = {
    mesh: mesh.name,
    ...simd,
    nativeSolve: (before.solve + after.solve) / 2,
    nativeTotal: (totalOf(before) + totalOf(after)) / 2,
    baselineSolve: baseline.solve,
    chromium,
    drift: after.solve / before.solve,
  };
  return [row];
}

async function main() {
  const options = benchOptions(process.argv.slice(2), CSV);
  if (!options) return;
  await buildBench(['abflat_flatten_bench', 'abflat_baseline_bench']);
  await buildWasm();
  const rows = [];
  for (const mesh of benchMeshes(options)) {
    console.log(`measuring ${mesh.name}`);
    rows.push(...(await measure(mesh, options)));
  }
  console.log('');
  printTable(COLUMNS, rows);
  console.log('');
  printTable(RATIOS, rows);
  console.log(LEGEND);
  const heads = rows.filter((row) => row.mesh.startsWith('head-'));
  if (heads.length > 1)
    console.log(
      `\nexponent of solve over the heads: ${exponent(heads, (row) => row.solve).toFixed(2)}`,
    );
  if (options.csv) appendCsv(options.csv, KEYS, rows);
  if (!options.check) return;
  const wrong = complaints(rows, JSON.parse(readFileSync(RECORDED, 'utf8')));
  if (wrong.length > 0) throw new Failure(wrong.join('\n'));
  console.log('all results are valid, no iteration count grew');
}

const [build, path, t, repeat] = process.argv.slice(2);
const isOne = build === 'simd';

/** Prints one line of JSON. */
const one = async () =>
  console.log(
    JSON.stringify(await runInNode(path, { build, t: Number(t), repeat: Number(repeat) })),
  );

await runMain(isOne ? one : main);
