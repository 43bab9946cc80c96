// Charts of equal shape share their place: in every format, judged by the file alone.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { randomNumbers } from '../support/disks.mjs';
import { hasTerminals, runAbflat, runOnTerminal } from '../support/run-abflat.mjs';
import { judgeStacks } from '../support/stacks.mjs';
import { objText, together, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** A box of quads whose sides all differ. */
const WEDGE = {
  positions: [
    [0, 0, 0],
    [3, 0, 0],
    [3, 2, 0],
    [0, 1, 0],
    [0, 0, 1],
    [3, 0, 0.5],
    [3, 2, 1.5],
    [0, 1, 1],
  ],
  faces: [
    [0, 3, 2, 1],
    [4, 5, 6, 7],
    [0, 1, 5, 4],
    [1, 2, 6, 5],
    [2, 3, 7, 6],
    [3, 0, 4, 7],
  ],
};

/** Moved, turned and perhaps mirrored, in single precision; faces begin anywhere. */
function copyOf({ positions, faces }, next, isMirrored) {
  const q = [0, 1, 2, 3].map(() => next() - 0.5);
  const [w, x, y, z] = q.map((c) => c / Math.hypot(...q));
  const axes = [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
  const shift = [0, 1, 2].map(() => 40 * next());
  const turned = positions.map((p) =>
    axes.map((axis, d) => {
      const side = isMirrored ? -1 : 1;
      return Math.fround(side * axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2] + shift[d]);
    }),
  );
  const begun = faces.map((face) => {
    const k = Math.floor(face.length * next());
    return [...face.slice(k), ...face.slice(0, k)];
  });
  return {
    positions: turned,
    faces: isMirrored ? begun.map((face) => face.reverse()) : begun,
  };
}

function copies(part, count, { areMirrored = false } = {}) {
  const next = randomNumbers(5);
  return together(
    Array.from({ length: count }, (_, i) => [
      copyOf(part, next, areMirrored && i % 2 === 1),
      [0, 0, 0],
    ]),
  );
}

async function stacked(t, surface, output, ...args) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objText(surface));
  const run = await runAbflat(['unwrap', 'in.obj', '-o', output, '--report', 'r.json', ...args], {
    cwd: at(),
  });
  assert.equal(run.code, 0, run.stderr);
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  return { report, judged: judgeStacks(at(output)), at };
}

const MIRRORED = copies(WEDGE, 8, { areMirrored: true });

for (const format of ['obj', 'ply', 'glb'])
  for (const how of ['identical', 'mirrored'])
    test(`${how} parts share their place in the ${format} file, and nothing else overlaps`, async (t) => {
      const { report, judged } = await stacked(t, MIRRORED, `out.${format}`, '--stack', how);
      assert.ok(judged.isValid, JSON.stringify(judged.problems));
      const { charts, atlas } = report;
      assert.equal(judged.all, charts.length);
      assert.deepEqual(
        { charts: judged.charts, places: judged.places, mirrored: judged.mirrored },
        atlas.stacked,
      );
      assert.ok(atlas.stacked.charts >= (how === 'mirrored' ? 7 : 6));
      assert.equal(atlas.stacked.mirrored > 0, how === 'mirrored');
      assert.equal(charts.filter((c) => c.stackedOn >= 0).length, atlas.stacked.charts);
      assert.equal(charts.filter((c) => c.mirrored).length, atlas.stacked.mirrored);
    });

test('without the option nothing shares its place', async (t) => {
  const apart = await stacked(t, MIRRORED, 'out.obj');
  assert.deepEqual(apart.report.atlas.stacked, { charts: 0, places: 0, mirrored: 0 });
  assert.equal(apart.judged.charts, 0);
  const on = await stacked(t, MIRRORED, 'out.obj', '--stack', 'mirrored');
  assert.ok(on.report.atlas.texelDensity > 2 * apart.report.atlas.texelDensity);
});

test('on a terminal, the program says how many charts lie on others', {
  skip: !hasTerminals(),
}, (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objText(MIRRORED));
  const args = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json'];
  const { seen } = runOnTerminal([...args, '--stack', 'mirrored'], { cwd: at() });
  const { charts, places, mirrored } = JSON.parse(readFileSync(at('r.json'), 'utf8')).atlas.stacked;
  assert.ok(
    seen.includes(`  ${charts} charts lie on ${places} others, ${mirrored} mirrored`),
    seen,
  );
  assert.doesNotMatch(runOnTerminal(args, { cwd: at() }).seen, / lies? on /);
});

test('the picture of an atlas shows each place once', async (t) => {
  const rings = copies(torus(16, 8), 3);
  const { report, at } = await stacked(
    t,
    rings,
    'out.obj',
    ...['--stack', 'identical', '--layout', 'l.svg'],
  );
  const shown = readFileSync(at('l.svg'), 'utf8').match(/<g /g).length;
  assert.equal(shown, report.charts.length - report.atlas.stacked.charts);
});

test('kept islands may lie on each other, if that is asked for', async (t) => {
  const first = await stacked(t, MIRRORED, 'out.obj', '--stack', 'mirrored');
  const args = ['unwrap', 'out.obj', '-o', 'next.obj', '--report', 'r.json', '--keep', 'uv'];
  const cwd = first.at();
  const refused = await runAbflat(args, { cwd });
  assert.match(refused.stderr, /mirrored|overlap/);
  const kept = await runAbflat([...args, '--stack', 'mirrored'], { cwd });
  assert.equal(kept.code, 0, kept.stderr);
  const uvIn = (name) =>
    readFileSync(first.at(name), 'utf8')
      .split('\n')
      .filter((line) => line.startsWith('vt '))
      .sort();
  assert.deepEqual(uvIn('next.obj'), uvIn('out.obj'));
  const { atlas } = JSON.parse(readFileSync(first.at('r.json'), 'utf8'));
  assert.deepEqual(atlas.stacked, first.report.atlas.stacked);
});
