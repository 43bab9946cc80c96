// Random meshes and options with a texel density: every chart has it, as measured in the file, or
// the report names the charts that do not. Slivers draw no outline out.
// ABFLAT_FUZZ_RUNS=500 ABFLAT_FUZZ_SEED=1000 makes more.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { chartDensities } from '../support/chart-densities.mjs';
import { generatedDisk } from '../support/disks.mjs';
import { Random, randomSurface } from '../support/random-surfaces.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { sharedFinding, withoutShared } from '../support/shared.mjs';
import { isosurface, objText } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const RUNS = Number(process.env.ABFLAT_FUZZ_RUNS ?? (isInstrumented ? 10 : 80));
const FIRST = Number(process.env.ABFLAT_FUZZ_SEED ?? 0);

/** Fans of triangles in place of polygons. */
const triangulated = ({ positions, faces }) => ({
  positions,
  faces: faces.flatMap((face) => face.slice(2).map((v, k) => [face[0], face[k + 1], v])),
});

/** With folds and slivers. */
function shaken(random, { positions, faces }) {
  const by = random.pick([0, 0.02, 0.1]);
  return {
    positions: positions.map((p) => p.map((x) => x + by * random.between(-1, 1))),
    faces,
  };
}

function randomMesh(random) {
  const kind = random.below(4);
  if (kind === 0) return generatedDisk(random.below(1e6), 400);
  if (kind === 1) return shaken(random, isosurface(5 + random.below(5), random.below(1e6)));
  const names = ['closed', 'cells', 'checkerboard', 'fan', 'sheet', 'motheaten', 'soup'];
  return triangulated(randomSurface(random, random.pick(names)));
}

/** The root of the surface's area, roughly: that of its bounding box's diagonal. */
function sizeOf({ positions, faces }) {
  const used = faces.flat().map((v) => positions[v]);
  const extent = [0, 1, 2].map((d) => {
    const x = used.map((p) => p[d]);
    return Math.max(...x) - Math.min(...x);
  });
  return Math.hypot(...extent) || 1;
}

function randomWishes(random, mesh) {
  const resolution = random.pick([64, 128, 500, 1024]);
  const density = (resolution / sizeOf(mesh)) * 2 ** random.between(-3, 0.5);
  const args = ['--texel-density', `${density}`, '--resolution', `${resolution}`];
  args.push('--padding', `${random.pick([0, 2, 4])}`);
  if (random.chance(0.8)) args.push('--udim');
  if (random.chance(0.4)) args.push('--max-stretch', random.pick(['1.005', '1.1', '1.3', '3']));
  if (random.chance(0.3)) args.push('--balance', random.pick(['0', '0.5', '1']));
  if (random.chance(0.2)) args.push('--t', random.pick(['1', '1.5', '2']));
  if (random.chance(0.2)) args.push('--straight-seams');
  if (random.chance(0.2)) args.push('--rotate', random.pick(['quarter', 'none']));
  if (random.chance(0.2)) args.push('--seams', random.pick(['none', 'auto,sharp=40']));
  if (random.chance(0.2)) args.push('--fill-holes', random.pick(['never', 'always']));
  return { density, resolution, args };
}

/** Number of charts that the notes name as enlarged, or as having moved vertices. */
const named = (notes) =>
  notes.reduce((sum, note) => {
    const [, count] =
      /^(\d+) tiny charts? /.exec(note) ?? /vert(?:ex|ices) of (\d+) chart/.exec(note) ?? [];
    return sum + Number(count ?? 0);
  }, 0);

/** With one of these, charts that slivers draw out are not cut. */
const NOT_CUT = /^(none|--t|--straight-seams)$/;

for (let seed = FIRST; seed < FIRST + RUNS; seed++)
  test(`random texel density ${seed}`, async (t) => {
    const at = tempFolder(t);
    const random = new Random(seed);
    const mesh = randomMesh(random);
    const { density, resolution, args } = randomWishes(random, mesh);
    writeFileSync(at('in.obj'), objText(mesh));
    const all = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json', ...args];
    const { code, stderr } = await runAbflat(all, { cwd: at() });
    const run = `abflat ${all.join(' ')}: ${stderr}`;
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    if (code > 1) {
      assert.match(report.error.code, /^(AtlasTooSmall|EmptyMesh)$/, run);
      return;
    }
    const charts = chartDensities(readFileSync(at('out.obj'), 'utf8'), resolution);
    const off = charts.filter(
      (chart) => !(Math.abs(chart.density / density - 1) <= 1e-6 + chart.rounding),
    );
    assert.ok(off.length <= named(report.notes), `${run} ${JSON.stringify({ off, density })}`);
    if (args.some((arg) => NOT_CUT.test(arg)) || report.notes.length > 0) return;
    for (const { drawnOut, rounding } of charts)
      assert.ok(
        !(drawnOut >= 12) || rounding > 1e-3,
        `${run} an outline is ${drawnOut} times as long`,
      );
  });

test('slivers do not draw a chart out', { skip: withoutShared }, async (t) => {
  const at = tempFolder(t);
  const mesh = sharedFinding('find-08-34.obj');
  const args = ['unwrap', mesh, '-o', 'out.obj', '--max-stretch', '1.3', '--min-utilization', '0'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 0, stderr);
  const charts = chartDensities(readFileSync(at('out.obj'), 'utf8'), 1024);
  for (const { drawnOut } of charts) assert.ok(!(drawnOut > 12), `${drawnOut} times as long`);
});
