// Padding inside of a chart: parts that are far apart on the surface stay apart in the atlas. The
// surfaces here are folded from flat shapes whose parts nearly touch.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { farParts } from '../support/far-parts.mjs';
import { sheet } from '../support/surfaces.mjs';
import { unwrapJudged } from '../support/unwrap-judged.mjs';

const TURN = 2 * Math.PI;

/** Turns a point around the line through two others, which lie in the plane z = 0. */
function turned(p, [from, to], angle) {
  const axis = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(...axis);
  const [x, y] = axis.map((c) => c / length);
  const d = [p[0] - from[0], p[1] - from[1], p[2]];
  const along = x * d[0] + y * d[1];
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const rest = [d[0] - along * x, d[1] - along * y, d[2]];
  const across = [y * d[2], -x * d[2], x * d[1] - y * d[0]];
  const [u, v, w] = rest.map((r, i) => c * r + s * across[i]);
  return [from[0] + along * x + u, from[1] + along * y + v, w];
}

/** A flat strip from one line to the next, folded along each of them. */
function folded(lines, angle) {
  const rows = 2;
  return sheet(rows, lines.length - 1, (u, v) => {
    const i = Math.round(v * (lines.length - 1));
    const [a, b] = lines[i];
    let p = [a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1]), 0];
    for (let k = i - 1; k > 0; k--) p = turned(p, lines[k], angle);
    return p;
  });
}

const lineAt = (angle, inner, outer) =>
  [outer, inner].map((r) => [r * Math.cos(angle), r * Math.sin(angle)]);

/** Nearly a full circle; `gap`: between its ends, where the width is 1. */
const horseshoe = (gap, radius = 3, count = 40) =>
  folded(
    Array.from({ length: count + 1 }, (_, i) =>
      lineAt(((TURN - gap / radius) * i) / count, radius - 0.5, radius + 0.5),
    ),
    2.4 / count,
  );

/** `gap`: between one turn, of width 1, and the next. */
const spiral = (gap, turns, count = Math.round(24 * turns)) =>
  folded(
    Array.from({ length: count + 1 }, (_, i) => {
      const inner = 1.5 + ((1 + gap) * turns * i) / count;
      return lineAt((TURN * turns * i) / count, inner, inner + 1);
    }),
    (2.5 * turns) / count,
  );

/** Every other prong, of width 1, stands up. */
function comb(gap, prongs) {
  const columns = 2 * prongs - 1;
  const place = (u, v) => {
    const [i, y] = [Math.round(u * columns), 6 * v];
    const x = Math.ceil(i / 2) + Math.floor(i / 2) * gap;
    const isUp = Math.floor(i / 2) % 2 === 1;
    return isUp && y > 1 ? [x, 1, y - 1] : [x, y, 0];
  };
  return sheet(columns, 6, place, (x, y) => x % 2 === 1 && y > 0);
}

async function unwrapped(t, surface, ...args) {
  const { report, text } = await unwrapJudged(t, surface, ...args);
  const { resolution, padding } = report.atlas;
  const notes = report.notes.filter((note) => note.includes('than the padding'));
  return {
    report,
    notes,
    far: farParts(text, { resolution, padding }),
  };
}

const SURFACES = {
  'a horseshoe': horseshoe(0.04),
  'a wider horseshoe': horseshoe(0.08, 5, 60),
  'a coarse horseshoe': horseshoe(0.05, 3, 12),
  'a spiral': spiral(0.06, 1.6),
  'a longer spiral': spiral(0.08, 3.2),
  'a fork': comb(0.03, 2),
  'a comb': comb(0.04, 5),
  'a long comb': comb(0.06, 11),
};

for (const [name, surface] of Object.entries(SURFACES))
  for (const [resolution, padding] of [
    ['128', '3'],
    ['256', '8'],
  ])
    test(`the parts of ${name} keep ${padding} texels apart at ${resolution}`, async (t) => {
      const size = ['--resolution', resolution, '--padding', padding, '--min-utilization', '0'];
      const whole = await unwrapped(t, surface, ...size, '--seams', 'none');
      assert.equal(whole.far.length, 1);
      assert.match(whole.notes.join(), /^parts of 1 chart .* texels at face \d+: .* automatic$/);
      const cut = await unwrapped(t, surface, ...size);
      assert.deepEqual([cut.far, cut.notes], [[], []]);
      assert.ok(cut.report.charts.length > 1);
    });

test('nothing is cut for a padding of 0, or where parts keep their distance', async (t) => {
  const size = ['--resolution', '256', '--min-utilization', '0'];
  for (const [surface, padding] of [
    [comb(0.04, 5), '0'],
    [comb(0.5, 5), '2'],
  ]) {
    const { report, far, notes } = await unwrapped(t, surface, ...size, '--padding', padding);
    assert.deepEqual([report.charts.length, far, notes], [1, [], []]);
  }
});

test('a chart stays whole, with a note, if its pieces do not fit', async (t) => {
  const size = ['--resolution', '128', '--padding', '3', '--min-utilization', '0'];
  const whole = await unwrapped(t, comb(0.04, 5), ...size, '--seams', 'none');
  const density = 0.97 * whole.report.atlas.texelDensity;
  const { report, notes } = await unwrapped(
    t,
    comb(0.04, 5),
    ...[...size, '--texel-density', `${density}`],
  );
  assert.equal(report.charts.length, 1);
  assert.match(notes.join(), /no cut was found whose pieces fit/);
});

test('charts that may not be cut are named in a note', async (t) => {
  for (const [option, reason] of [
    [['--straight-seams'], /with straight seams/],
    [['--t', '1.9'], /only if t is auto/],
  ]) {
    const { far, notes } = await unwrapped(t, comb(0.04, 5), '--resolution', '256', ...option);
    assert.equal(far.length, 1);
    assert.match(notes.join(), reason);
  }
});
