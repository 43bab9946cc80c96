#!/usr/bin/env node
// The npm package in Node beside the native program on the same meshes.
// Usage: npm run bench:wasm -- [options of npm run bench]

import { readFileSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildWasm } from '../../scripts/build.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { Failure, run, runMain } from '../../scripts/lib/run.mjs';
import { benchMeshes, buildBench, PROGRAM } from './support/meshes.mjs';
import { benchOptions } from './support/options.mjs';
import {
  appendCsv,
  complaints,
  exponent,
  printTable,
  STAGES,
  totalOf,
} from './support/results.mjs';

const CSV = join(ROOT, 'tests/bench/results/wasm.csv');
const RECORDED = join(ROOT, 'tests/bench/recorded.json');

const KEYS = [
  ...['mesh', 'faces', 't', 'repeat', ...STAGES, 'call', 'iterations', 'residual', 'valid'],
  ...['memoryMB', 'nativeSolve', 'nativeTotal', 'drift', 'node'],
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
  ['native solve/s', 'nativeSolve', 3],
  ['solve ratio', (row) => row.solve / row.nativeSolve, 2],
  ['total ratio', (row) => totalOf(row) / row.nativeTotal, 2],
  ['drift', 'drift', 2],
];

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** In a process of its own, for its peak of memory: prints one line of JSON. */
async function runOne(path, t, repeat) {
  const { createAbflat } = await import('abflat');
  const abflat = await createAbflat();
  const calls = [];
  try {
    for (let i = 0; i < repeat; ++i) {
      const bytes = readFileSync(path);
      const start = performance.now();
      const { report } = await abflat.flatten({ bytes, name: basename(path) }, { t, obj: true });
      calls.push({ call: (performance.now() - start) / 1000, report });
    }
  } finally {
    abflat.terminate();
  }
  const { report } = calls.at(-1);
  const [chart] = report.charts;
  const row = {
    faces: chart.faces,
    t: chart.t,
    repeat,
    call: median(calls.map(({ call }) => call)),
  };
  for (const stage of STAGES) row[stage] = median(calls.map((call) => call.report.timings[stage]));
  Object.assign(row, {
    iterations: chart.iterations,
    residual: chart.constraintResidual,
    valid: report.valid && chart.converged,
    memoryMB: (process.resourceUsage().maxRSS * 1024) / 1e6,
    node: process.version,
  });
  console.log(JSON.stringify(row));
}

async function jsonOf(name, program, args) {
  const { code, output } = await run(program, args, { capture: true });
  if (code !== 0) throw new Failure(`${name}: ${output.trim()}`);
  return JSON.parse(output);
}

async function measure(mesh, { t, repeatFor }) {
  const path = await mesh.make();
  const args = [path, String(t), String(repeatFor(mesh.faces))];
  const self = fileURLToPath(import.meta.url);
  const natively = () => jsonOf(mesh.name, PROGRAM, ['plain', ...args]);
  // Before and after, so that a machine that gets busy meanwhile shows.
  const before = await natively();
  const wasm = await jsonOf(mesh.name, process.execPath, [self, 'one', ...args]);
  const after = await natively();
  rmSync(path);
  return {
    mesh: mesh.name,
    ...wasm,
    nativeSolve: (before.solve + after.solve) / 2,
    nativeTotal: (totalOf(before) + totalOf(after)) / 2,
    drift: after.solve / before.solve,
  };
}

async function main() {
  const options = benchOptions(process.argv.slice(2), CSV);
  if (!options) return;
  await buildBench();
  await buildWasm();
  const rows = [];
  for (const mesh of benchMeshes(options)) {
    console.log(`measuring ${mesh.name}`);
    rows.push(await measure(mesh, options));
  }
  console.log('');
  printTable(COLUMNS, rows);
  console.log(
    '\ndrift: native solve after the wasm run over before; ratios count where it is near 1',
  );
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

const [mode, path, t, repeat] = process.argv.slice(2);
await runMain(mode === 'one' ? () => runOne(path, Number(t), Number(repeat)) : main);
