// Symmetric seams of meshes as people make them: with noise, with something on one side only, with
// faces across the plane, turned.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { chartedLayout, lengthOf, minus } from '../support/charted-layout.mjs';
import { mirroredShare } from '../support/mirrored-share.mjs';
import { Random } from '../support/random-surfaces.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { unwrapJudged } from '../support/unwrap-judged.mjs';

const ACROSS_X = { normal: [1, 0, 0], distance: 0 };
const SHARE = 0.95;

/** Directions in which something sticks out: how far, how wide. */
const LIMBS = [
  { at: [0.5, -0.8, 0.3], length: 1, width: 0.35 },
  { at: [0.5, -0.8, -0.35], length: 0.9, width: 0.35 },
  { at: [0, 0.5, 0.85], length: 0.8, width: 0.55 },
  { at: [0.45, 0.8, 0.4], length: 0.7, width: 0.2 },
];
const KNOB = { at: [-0.9, 0.1, -0.4], length: 0.5, width: 0.3 };

const radiusAt = (p, limbs) =>
  limbs.reduce((sum, { at, length, width }) => {
    const size = Math.hypot(...at);
    const off = Math.hypot(...at.map((x, d) => p[d] - x / size));
    return sum + length * Math.exp(-((off / width) ** 4));
  }, 1);

/** With as many faces across as `n`; if that is odd, the middle ones lie across the plane. */
function creature(n, extra = []) {
  const { positions, faces } = sphere(n);
  const place = (p) => {
    const right = [Math.abs(p[0]), p[1], p[2]];
    const radius = radiusAt(right, LIMBS) + radiusAt(p, extra) - 1;
    return [p[0], 0.8 * p[1], 1.3 * p[2]].map((x) => x * radius);
  };
  return { positions: positions.map(place), faces };
}

function shaken({ positions, faces }, most) {
  const random = new Random(7);
  return { positions: positions.map((p) => p.map((x) => x + random.between(-most, most))), faces };
}

function turned({ positions, faces }, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { positions: positions.map(([x, y, z]) => [c * x - s * y, s * x + c * y, z]), faces };
}

async function shareOf(t, surface, plane, ...options) {
  const { text, report } = await unwrapJudged(t, surface, ...options);
  const layout = chartedLayout(parseObj(text));
  return { share: mirroredShare(layout, plane), report, layout };
}

/** About 4 from end to end. */
const NOISE = 4e-4;
const TURN = 0.6;
const ACROSS = isInstrumented ? 16 : 24;
const CREATURES = {
  exact: [creature(ACROSS), ACROSS_X],
  'with noise': [shaken(creature(ACROSS), NOISE), ACROSS_X],
  'with faces across the plane': [creature(ACROSS - 1), ACROSS_X],
  turned: [
    turned(creature(ACROSS), TURN),
    { normal: [Math.cos(TURN), Math.sin(TURN), 0], distance: 0 },
  ],
};

for (const [name, [surface, plane]] of Object.entries(CREATURES))
  test(`seams are symmetric where that is asked for: ${name}`, async (t) => {
    const { share } = await shareOf(t, surface, plane, '--symmetric-seams', 'always');
    assert.ok(share > SHARE, `${share}`);
  });

const distance = (p, q) => lengthOf(minus(p, q));

test('a part on one side leaves the other seams symmetric', async (t) => {
  const surface = shaken(creature(24, [KNOB]), NOISE);
  const { layout } = await shareOf(t, surface, ACROSS_X, '--symmetric-seams', 'always');
  const centre = KNOB.at.map((x) => 1.5 * x);
  const isFar = ({ a }) => [a, [-a[0], a[1], a[2]]].every((p) => distance(p, centre) > 0.9);
  const share = mirroredShare({ ...layout, cuts: layout.cuts.filter(isFar) }, ACROSS_X);
  // What is cut once more because it was stretched too much may differ.
  assert.ok(share > 0.85, `${share}`);
});

test('a note says why seams are not symmetric', async (t) => {
  const surface = torus();
  surface.positions = surface.positions.map(([x, y, z], i) => [x * (1 + 0.3 * Math.sin(i)), y, z]);
  const { report } = await shareOf(t, surface, ACROSS_X, '--symmetric-seams', 'always');
  assert.ok(report.notes.some((note) => note.startsWith('seams are not symmetric: ')));
});

function middleOf({ triangles }, axis) {
  const places = triangles.flatMap(({ xyz }) => xyz.map((p) => p[axis]));
  return (Math.min(...places) + Math.max(...places)) / 2;
}

for (const [file, axis] of [
  ['spot-uv.obj', 0],
  ['suzanne-quads.obj', 0],
])
  test(`${file} has symmetric seams by default`, { skip: withoutShared }, async (t) => {
    const at = tempFolder(t);
    const run = await runAbflat(['unwrap', sharedMesh(file), '-o', at('out.obj'), '-q']);
    assert.deepEqual([run.code, run.stderr], [0, '']);
    const layout = chartedLayout(parseObj(readFileSync(at('out.obj'), 'utf8')));
    const normal = [0, 1, 2].map((d) => (d === axis ? 1 : 0));
    const share = mirroredShare(layout, { normal, distance: middleOf(layout, axis) });
    assert.ok(share > SHARE, `${share}`);
  });

test('rings side by side stay within the bound of stretch', async (t) => {
  const at = tempFolder(t);
  const rings = [0, 3].map((x) => [torus(16, 8), [x, 0, 0]]);
  writeFileSync(at('in.obj'), objText(together(rings)));
  await runAbflat(['unwrap', at('in.obj'), '-o', at('out.obj'), '-q', '--report', at('r.json')]);
  const { charts } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  for (const { symmetricDirichlet } of charts) assert.ok(symmetricDirichlet <= 1.02);
});

test('a cow has no seam down the middle of its face', { skip: withoutShared }, async (t) => {
  const at = tempFolder(t);
  await runAbflat(['unwrap', sharedMesh('../meshes2/cow.obj'), '-o', at('out.obj'), '-q']);
  const { cuts } = chartedLayout(parseObj(readFileSync(at('out.obj'), 'utf8')));
  const FACE = 50; // in front of the horns; the cow looks along x
  const isInMiddle = ([x, , z]) => x > FACE && Math.abs(z) < 1e-3;
  assert.ok(cuts.some(({ a }) => a[0] > FACE));
  assert.deepEqual(
    cuts.filter(({ a, b }) => isInMiddle(a) && isInMiddle(b)),
    [],
  );
});
