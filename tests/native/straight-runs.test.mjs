// Random disks with random straight runs, bounds and options: either every angle asked for is in
// the file, or the report says which are not and the program ends with exit code 1.
// ABFLAT_FUZZ_RUNS=300 ABFLAT_FUZZ_SEED=1000 makes more of them.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  boundaryAngles,
  isInjective,
  straightDisk,
  vertexTexcoords,
} from '../support/asked-angles.mjs';
import { toObj } from '../support/disks.mjs';
import { Random } from '../support/random-surfaces.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const RUNS = Number(process.env.ABFLAT_FUZZ_RUNS ?? (isInstrumented ? 10 : 80));
const FIRST = Number(process.env.ABFLAT_FUZZ_SEED ?? 0);

/** Radians: what the numbers of a format may round away. */
const ROUNDING = { obj: 1.1e-6, ply: 1.1e-3, glb: 1.1e-3 };

/** Options as { t, bounds (per place), format, args }. */
function randomWishes(random, { loop }, file) {
  const t = random.pick(['auto', 'auto', 'auto', 2, 1.5, 1.05, 1]);
  const format = random.pick(['obj', 'obj', 'obj', 'ply', 'glb']);
  const args = ['--t', `${t}`];
  if (random.chance(0.4)) args.push('--balance', random.pick(['0.2', '1']));
  if (random.chance(0.3)) args.push('--untangle', random.pick(['none', 'local', 'global', 'best']));
  const bounds = loop.map(() => (t === 'auto' ? 2 : t));
  if (random.chance(0.3)) {
    for (let i = random.below(6); i >= 0; i--)
      bounds[random.below(loop.length)] = 0.6 + 0.1 * random.below(12);
    const lines = loop.map((v, i) => `${v} ${bounds[i]}\n`);
    args.push('--bounds', file('bounds.txt', lines.join('')));
  }
  return { t, bounds, format, args };
}

/** The places whose angle in the file is not what was asked for. */
const missed = (angles, { straight }, { bounds, format }) =>
  angles.flatMap((angle, i) => {
    const limit = ROUNDING[format];
    const isMet = straight.has(i)
      ? Math.abs(angle - Math.PI) <= limit
      : bounds[i] >= 2 || angle <= bounds[i] * Math.PI + limit;
    return isMet ? [] : [{ place: i, angle, straight: straight.has(i), bound: bounds[i] }];
  });

/** Whether bounds and straight runs leave enough for the angles of a closed boundary. */
const hasSum = (straight, bounds) =>
  bounds.reduce((sum, t, i) => sum + (straight.has(i) ? 1 : t), 0) >= bounds.length - 2;

for (let seed = FIRST; seed < FIRST + RUNS; seed++)
  test(`random straight runs ${seed}`, async (t) => {
    const at = tempFolder(t);
    const file = (name, text) => {
      writeFileSync(at(name), text);
      return name;
    };
    const disk = straightDisk(seed);
    const wishes = randomWishes(new Random(seed + 5e6), disk, file);
    file('in.obj', toObj(disk));
    const runs = disk.runs.map(({ from, to }) => `${disk.loop[from]} ${disk.loop[to]}\n`);
    file('straight.txt', runs.join(''));
    const output = `out.${wishes.format}`;
    const args = ['flatten', 'in.obj', '-o', output, '--straight', 'straight.txt', ...wishes.args];
    const { code, stderr } = await runAbflat([...args, '--report', 'r.json'], { cwd: at() });
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    const run = `abflat ${args.join(' ')}: ${stderr}`;
    if (!disk.isFeasible || !hasSum(disk.straight, wishes.bounds)) {
      assert.equal(code, 4, run);
      return;
    }
    assert.ok(code === 0 || code === 1, run);
    assert.equal(report.valid, code === 0, run);
    const [chart] = report.charts;
    assert.equal(chart.straight?.vertices, disk.straight.size, run);
    assert.equal(chart.straight.released, 0, run);
    const uv = vertexTexcoords(disk, at(output));
    const isFine = isInjective(disk, uv);
    const angles = missed(boundaryAngles(disk.loop, uv), disk, wishes);
    if (code === 0) {
      assert.ok(isFine, run);
      assert.deepEqual(angles, [], run);
      return;
    }
    assert.match(chart.problem, /^[^\n]+$/, run);
    assert.ok(!chart.converged || !isFine || angles.length > 0, `${run} ${chart.problem}`);
    const isFree = wishes.bounds.every((bound) => bound >= 2);
    const isAuto = wishes.t === 'auto' && !wishes.args.includes('none');
    assert.ok(!isFree || !isAuto || wishes.format === 'glb', `${run} ${chart.problem}`);
  });
