// Long parts: cables, beams, rails and roads, which would leave most of the tile empty in one piece.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isInstrumented } from '../support/run-abflat.mjs';
import { boxArray, sheet, together } from '../support/surfaces.mjs';
import { unwrapJudged } from '../support/unwrap-judged.mjs';

const TURN = 2 * Math.PI;

const cable = (length, sides = 6) =>
  sheet(
    sides,
    2 * length,
    (u, v) => [length * v, 0.2 * Math.cos(TURN * u), 0.2 * Math.sin(TURN * u)],
    undefined,
    true,
  );

const strip = (length, columns = 2 * length) => sheet(columns, 1, (u, v) => [length * u, v / 2, 0]);

/** Goes `length` far in bends of up to a right angle to either side. */
function road(length) {
  const middle = [[0, 0, 0]];
  for (let i = 0; i < length; i++) {
    const [x, y] = middle[i];
    const angle = 0.9 * Math.sin((TURN * i) / 80);
    middle.push([x + Math.cos(angle), y + Math.sin(angle), angle]);
  }
  return sheet(length, 4, (u, v) => {
    const [x, y, angle] = middle[Math.round(u * length)];
    const off = 3 * (v - 0.5);
    return [x - off * Math.sin(angle), y + off * Math.cos(angle), 0];
  });
}

/** In a helix of ten turns. */
const spring = () =>
  sheet(
    6,
    300,
    (u, v) => {
      const r = 1 + 0.08 * Math.cos(TURN * u);
      return [
        r * Math.cos(10 * TURN * v),
        r * Math.sin(10 * TURN * v),
        4 * v + 0.08 * Math.sin(TURN * u),
      ];
    },
    undefined,
    true,
  );

const unwrapped = async (...args) => (await unwrapJudged(...args)).report;

/** The surface, and the least utilization by itself and where 0.7 is asked for. */
const SURFACES = {
  'a short cable': [cable(30), 0.65, 0.7],
  'a cable': [cable(200), 0.7, 0.7],
  'a spring': [spring(), 0.6, 0.7],
  'a road': [road(600), 0.4, 0.6],
  'a long strip beside boxes': [
    together([
      [strip(100), [0, -9, 0]],
      [boxArray(4), [0, 0, 0]],
    ]),
    0.55,
    0.6,
  ],
  'five strips': [together([0, 1, 2, 3, 4].map((i) => [strip(100), [0, 2 * i, 0]])), 0.7, 0.7],
};

/** With sanitizers one of each kind: a tube and one that is flat. */
const isTried = (name) => !isInstrumented || ['a short cable', 'five strips'].includes(name);

for (const [name, [surface, least, leastAsked]] of Object.entries(SURFACES).filter(([name]) =>
  isTried(name),
))
  test(`${name} fills the tile`, async (t) => {
    const whole = await unwrapped(t, surface, '--min-utilization', '0');
    const cut = await unwrapped(t, surface);
    const asked = await unwrapped(t, surface, '--min-utilization', '0.7');
    assert.ok(whole.atlas.utilization < 0.5 * least, `whole: ${whole.atlas.utilization}`);
    assert.ok(cut.atlas.utilization >= least, `auto: ${cut.atlas.utilization}`);
    assert.ok(asked.atlas.utilization >= leastAsked, `asked: ${asked.atlas.utilization}`);
    assert.deepEqual(cut.notes, []);
    assert.equal(asked.notes.length, asked.atlas.utilization < 0.7 ? 1 : 0);
    // What is paid in charts and seams is gained in texels.
    const gain = Math.log(cut.atlas.texelDensity / whole.atlas.texelDensity);
    assert.ok(gain > 0.015 * cut.atlas.packingCuts + 0.04 * cut.atlas.packingCutLength);
  });

test('what is as long as a face cannot be cut, and a note says so', async (t) => {
  const boxes = together([
    [strip(100, 1), [0, -9, 0]],
    [boxArray(4), [0, 0, 0]],
  ]);
  for (const args of [[], ['--min-utilization', '0.7'], ['--straight-seams']]) {
    const { atlas, notes } = await unwrapped(t, boxes, ...args);
    assert.equal(atlas.packingCuts, 0);
    assert.match(
      notes.join('\n'),
      /^charts cover [\d.]+ % of the tile.*: face [01] is as long as the tile/,
    );
  }
});
