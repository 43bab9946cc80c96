// Islands of a file are mirrored in their places.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { middleOf } from './layout.mjs';
import { choose, metrics, openPage, reload, settled, textOf } from './page.mjs';
import { squares } from './squares.mjs';
import {
  assertNear,
  changed,
  exported,
  layoutReady,
  openUvs,
  select,
  selectBy,
  turnOf,
} from './uvs-page.mjs';

/** Numbers that single precision has, so that mirroring rounds nothing. */
const PLAIN = [0.125, 0.125, 0.375, 0.125];
const MIRRORED = [0.5, 0.625, -0.25, 0.25];
const ALSO_MIRRORED = [0.875, 0.5, -0.125, 0.25];

const flipped = async (page) => (await metrics(page)).Flipped ?? '0';
const flipEntry = (page) => page.locator('#arrange-menu button:text("Flip")');

const mirrored = (corners) => {
  const us = corners.map(([u]) => u);
  const sum = Math.min(...us) + Math.max(...us);
  return corners.map(([u, v]) => [sum - u, v]);
};

test('flipped islands are selected and flipped in their places, exported so, and packed', async (t) => {
  const page = await openUvs(t, [PLAIN, MIRRORED, ALSO_MIRRORED]);
  const before = await exported(page);
  assert.deepEqual(
    before.map((corners) => turnOf(corners) > 0),
    [true, false, false],
  );
  assert.equal(await flipped(page), '2');
  await selectBy(page, 'flipped');
  await page.click('#selection-arrange');
  await flipEntry(page).click();
  await changed(page, 'Flipped 2 islands, checked in');
  assert.equal(await flipped(page), '0');
  assert.equal(await textOf(page, '#notice'), '');
  const after = await exported(page);
  assertNear(after, [before[0], mirrored(before[1]), mirrored(before[2])], 'each in its box');
  await selectBy(page, 'flipped');
  assert.equal(await textOf(page, '#run-text'), 'No face is mirrored');

  await reload(page);
  assertNear(await exported(page), after, 'it is kept');
  await page.click('#pack-islands');
  await changed(page, 'Repacked in');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  for (const corners of await exported(page)) assert.ok(turnOf(corners) > 0);
});

test('F flips an island, again flips it back, and each is a step to undo', async (t) => {
  const page = await openUvs(t, [PLAIN, MIRRORED]);
  const before = await exported(page);
  await page.focus('#layout-canvas');
  await page.keyboard.press('f');
  assert.equal(await textOf(page, '#run-text'), 'Select an island first');
  await select(page, PLAIN);
  await page.keyboard.press('f');
  await changed(page, 'Flipped island 0, checked in');
  assert.equal(await flipped(page), '2');
  const once = await exported(page);
  assertNear(once, [mirrored(before[0]), before[1]], 'the other stays');
  await page.focus('#layout-canvas');
  await page.keyboard.press('f');
  await changed(page, 'Flipped island 0, checked in');
  assertNear(await exported(page), before, 'twice is as before');
  await page.click('#undo');
  await settled(page);
  assertNear(await exported(page), once, 'one step');
  await page.click('#undo');
  await settled(page);
  assertNear(await exported(page), before, 'as in the file');
  assert.equal(await page.getAttribute('#pack-keep', 'aria-pressed'), 'true');
});

/** Two triangles of a square that lie on each other, one of them mirrored. */
const FOLDED = `v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0.25 0.25
vt 0.75 0.25
vt 0.75 0.75
vt 0.75 0.3
f 1/1 2/2 3/3
f 1/1 3/3 4/4
`;

test('an island with faces that run either way is flipped, and a note says what is left', async (t) => {
  const page = await openPage(t, { open: ['folded.obj', FOLDED] });
  await choose(page, 'pack');
  await layoutReady(page);
  const before = await exported(page);
  const turns = before.map((corners) => Math.sign(turnOf(corners)));
  assert.equal(turns[0] * turns[1], -1);
  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  await page.keyboard.press('f');
  await changed(page, 'Flipped island 0, checked in');
  assert.match(
    await textOf(page, '#notice'),
    /^Island 0 has faces that run either way, so some are flipped still\. Try Relax/,
  );
  assert.deepEqual(
    (await exported(page)).map((corners) => Math.sign(turnOf(corners))),
    turns.map((turn) => -turn),
  );
});

test('an atlas is seen from the front, so nothing flips it', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['squares.obj', squares([PLAIN])] });
  await page.locator('#select-charts').waitFor();
  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  await page.keyboard.press('f');
  await page.click('#selection-arrange');
  assert.ok(await flipEntry(page).isHidden());
  assert.ok(await page.isDisabled('#undo'));
});

test('the place of an island is its box, whatever lies in it', async () => {
  const { loadModule } = await import('./modules.mjs');
  const { flipped: flip } = await loadModule('arrange/flip');
  // A triangle, and one that is not asked for.
  const uv = Float64Array.of(0.1, 0.2, 0.7, 0.3, 0.2, 0.9, 5, 5, 6, 5, 5, 6);
  const arrays = {
    uv,
    indices: Uint32Array.of(0, 1, 2, 3, 4, 5),
    chartOfTriangle: Uint32Array.of(0, 1),
  };
  const { uv: now, folded } = flip(arrays, Uint32Array.of(0));
  const single = (numbers) => numbers.map(Math.fround);
  assert.deepEqual([...now.slice(0, 6)], single([0.7 + 0.1 - 0.1, 0.2, 0.1, 0.3, 0.6, 0.9]));
  assert.deepEqual(now.slice(6), uv.slice(6));
  assert.deepEqual(folded, []);
  const corners = [0, 1, 2].map((v) => [now[2 * v], now[2 * v + 1]]);
  assert.ok(turnOf(corners) < 0);
  assert.ok(
    Math.abs(
      middleOf(corners)[1] -
        middleOf([
          [0.1, 0.2],
          [0.7, 0.3],
          [0.2, 0.9],
        ])[1],
    ) < 1e-6,
  );
});
