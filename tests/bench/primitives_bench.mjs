#!/usr/bin/env node
// Unwraps the geometries of three.js: time per face compared with a generated surface without
// symmetries.
// Usage: npm run bench:primitives -- [--families sphere,cone] [--sizes 1000,40000,500000] [--repeat
// 1] [--limit 60]

import { spawnSync } from 'node:child_process';
import { rmSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { buildNative } from '../../scripts/build.mjs';
import { NATIVE_PROGRAM } from '../../scripts/lib/paths.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { writeMesh } from './support/mesh_files.mjs';
import { PRIMITIVES, writePrimitive } from './support/primitives.mjs';
import { printTable } from './support/results.mjs';

const REFERENCE = 'iso-64';

const COLUMNS = [
  ['mesh', 'mesh'],
  ['faces', 'faces'],
  ['s', 'seconds', 3],
  ['us/face', 'perFace', 2],
  [`/ ${REFERENCE}`, 'ratio', 2],
  ['charts', 'charts'],
  ['seam', 'seam', 2],
  ['SD/4', 'stretch', 4],
  ['valid', (row) => (row.valid === undefined ? '-' : row.valid ? 'yes' : 'NO')],
];

function optionsOf(args) {
  const text = (value) => ({ type: 'string', default: value });
  const { values } = parseArgs({
    args,
    options: {
      families: text(PRIMITIVES.join(',')),
      sizes: text('100,1000,10000,40000,100000,500000'),
      repeat: text('1'),
      limit: text('60'),
    },
  });
  const families = values.families.split(',');
  const unknown = families.find((name) => !PRIMITIVES.includes(name));
  if (unknown) throw new Failure(`there is no family "${unknown}"; known are ${PRIMITIVES}`);
  const sizes = values.sizes.split(',').map(Number);
  if (!sizes.every((n) => n > 0)) throw new Failure('--sizes takes numbers of faces');
  return { families, sizes, repeat: Number(values.repeat), limit: Number(values.limit) };
}

/** The fastest of several runs on one thread; without seconds if the time limit was exceeded. */
function measure(name, { path, faces }, { repeat, limit }) {
  const output = path.replace(/\.obj$/, '-uv.obj');
  const args = ['unwrap', path, '-o', output, '--report', '-', '--quiet', '--threads', '1'];
  const runs = [];
  for (let i = 0; i < repeat; i++) {
    const { stdout } = spawnSync(NATIVE_PROGRAM, args, {
      encoding: 'utf8',
      timeout: 1000 * limit,
      maxBuffer: 1 << 30,
    });
    if (!stdout) return { mesh: name, faces };
    runs.push(JSON.parse(stdout));
  }
  for (const file of [path, output]) rmSync(file, { force: true });
  const report = runs.toSorted((a, b) => a.timings.total - b.timings.total)[0];
  if (report.error) throw new Failure(`${name}: ${report.error.message}`);
  return {
    mesh: name,
    faces,
    seconds: report.timings.total,
    perFace: (1e6 * report.timings.total) / faces,
    charts: report.charts.length,
    seam: report.seams.relativeLength,
    stretch: report.symmetricDirichlet,
    valid: report.valid,
  };
}

async function main() {
  const options = optionsOf(process.argv.slice(2));
  await buildNative();
  const reference = measure(REFERENCE, await writeMesh(REFERENCE), options);
  const rows = [{ ...reference, ratio: 1 }];
  for (const family of options.families)
    for (const size of options.sizes) {
      const row = measure(`${family}-${size}`, writePrimitive(family, size), options);
      rows.push({ ...row, ratio: row.perFace / reference.perFace });
    }
  printTable(COLUMNS, rows);
  const wrong = rows.filter((row) => !row.valid).map((row) => row.mesh);
  if (wrong.length > 0) throw new Failure(`not valid, or not done in time: ${wrong.join(', ')}`);
}

await runMain(main);
