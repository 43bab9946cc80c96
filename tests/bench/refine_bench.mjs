#!/usr/bin/env node
// Compares refining for lengths with solving for angles: seconds, threads, and how close it ends to
// the least energy.
// Usage: npm run bench:refine -- [--meshes head-5000,bunny-disk+1,FILE+1] [--balances
// 0.2,1] [--repeat 3]

import { existsSync } from 'node:fs';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import { BUILD, ROOT } from '../../scripts/lib/paths.mjs';
import { Failure, run, runMain } from '../../scripts/lib/run.mjs';
import { meshName, writeMesh } from './support/mesh_files.mjs';
import { buildBench } from './support/program.mjs';
import { printTable } from './support/results.mjs';

const PROGRAM = join(BUILD, 'native/tests/abflat_refine_bench');
const SHARED = join(ROOT, '../shared/meshes');

/** Disks with 5 k to 500 k faces: generated heads, and others that are subdivided. */
const MESHES = [
  'head-5000',
  'cut-sphere',
  'bunny-disk+1',
  'head-30000',
  'bunny-disk+3',
  'head-500000',
];
/** Used as well where they are. */
const MORE = [
  'cow-cut.off',
  'camel-cut.obj+1',
  'hemisphere.obj+1',
  'face.obj',
  'nefertiti.off+3',
  'cathead.obj+4',
  'face.obj+1',
].map((name) => join(SHARED, name));

const excess = (row) => (row.energy - row.reference) / row.reference;

const COLUMNS = [
  ['mesh', 'mesh'],
  ['faces', 'faces'],
  ['b', 'balance', 2],
  ['solve/s', 'solve', 3],
  ['refine/s', 'refine', 3],
  ['refine/solve', (row) => row.refine / row.solve, 2],
  ['1/2 threads', (row) => row.refineOnTwo && row.refine / row.refineOnTwo, 2],
  ['same bytes', (row) => (row.identical ? 'yes' : 'NO')],
  ['steps', 'steps'],
  ['energy before', 'energyBefore', 5],
  ['energy', 'energy', 5],
  ['reference', 'reference', 5],
  ['its steps', 'referenceSteps'],
  ['above it', (row) => `${(100 * excess(row)).toFixed(3)}%`],
  ['valid', (row) => (row.valid ? 'yes' : 'NO')],
  ['limit', 'limit'],
];

function optionsOf(args) {
  const { values } = parseArgs({
    args,
    options: {
      meshes: { type: 'string', default: [...MESHES, ...MORE].join(',') },
      balances: { type: 'string', default: '0.2,1' },
      repeat: { type: 'string', default: '3' },
    },
  });
  const balances = values.balances.split(',').map(Number);
  if (!balances.every((b) => b > 0 && b <= 1))
    throw new Failure('--balances takes numbers above 0 and up to 1');
  return { meshes: values.meshes.split(','), balances, repeat: Number(values.repeat) };
}

/** What the program calls a mesh, undefined if that is a file that does not exist. */
async function argumentFor(mesh) {
  const [base, ...levels] = mesh.split(/(?=\+\d+$)/);
  if (meshName(base)) return [(await writeMesh(base)).path, ...levels].join('');
  return !base.includes('.') || existsSync(base) ? mesh : undefined;
}

await runMain(async () => {
  const { meshes, balances, repeat } = optionsOf(process.argv.slice(2));
  await buildBench(['abflat_refine_bench']);
  const rows = [];
  for (const mesh of meshes) {
    const name = basename(mesh);
    const what = await argumentFor(mesh);
    if (!what) {
      console.log(`skipped: ${mesh}, which does not exist`);
      continue;
    }
    console.log(`measuring ${name}`);
    for (const balance of balances) {
      const args = [what, String(balance), String(repeat)];
      const { code, output } = await run(PROGRAM, args, { capture: true });
      if (code !== 0) throw new Failure(`${name}: ${output.trim()}`);
      rows.push({ mesh: name, ...JSON.parse(output) });
    }
  }
  console.log('');
  printTable(COLUMNS, rows);
  console.log('\nreference: the energy of a run of many more steps, from the same angles');
});
