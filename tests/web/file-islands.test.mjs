// Islands of the UVs that a file has: selected, relaxed, moved, and packed around others.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { middleOf, pixelOf } from './layout.mjs';
import { choose, dropAndWait, metrics, reload, settled, textOf } from './page.mjs';
import { squares } from './squares.mjs';
import {
  assertNear,
  changed,
  exported,
  layoutReady,
  openUvs,
  select,
  selectBy,
  squareOf,
  turnOf,
} from './uvs-page.mjs';

const WIDE = [0.1, 0.1, 0.4, 0.1];
const SQUARE = [0.6, 0.6, 0.2, 0.2];
const MIRRORED = [0.5, 0.6, -0.1, 0.3];
const APART = [WIDE, SQUARE, MIRRORED];

const sidesOf = ([a, b, c]) => [
  Math.hypot(b[0] - a[0], b[1] - a[1]),
  Math.hypot(c[0] - b[0], c[1] - b[1]),
];

test('Relax gives all islands of a file their shape on the surface, in their places', async (t) => {
  const page = await openUvs(t, APART);
  const before = await exported(page);
  await page.click('#pack-relax');
  await changed(page, 'Relaxed 3 islands, checked in');
  assert.equal(await page.getAttribute('#pack-keep', 'aria-pressed'), 'false');
  const after = await exported(page);
  after.forEach((corners, i) => {
    const [width, height] = sidesOf(corners);
    assert.ok(Math.abs(width / height - 1) < 1e-3, `island ${i} is a square`);
    const [w, h] = sidesOf(before[i]);
    assert.ok(Math.abs((width * height) / (w * h) - 1) < 1e-3, `island ${i} is as large`);
    assertNear([middleOf(corners)], [middleOf(before[i])], `island ${i} is where it was`);
    assert.equal(turnOf(corners) > 0, turnOf(before[i]) > 0, `island ${i} is turned as it was`);
  });
  assert.equal((await metrics(page)).Flipped, '1');

  await reload(page);
  assert.equal(await page.getAttribute('#mode-pack', 'aria-pressed'), 'true');
  assertNear(await exported(page), after, 'it is kept');
  await page.click('#pack-islands');
  await changed(page, 'Repacked in');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  for (const corners of await exported(page)) {
    const [width, height] = sidesOf(corners);
    assert.ok(Math.abs(width / height - 1) < 1e-3, 'what was relaxed is packed');
  }
  await page.click('#pack-keep');
  await settled(page);
  assertNear(await exported(page), before, 'as in the file');
  assert.equal(await page.getAttribute('#pack-keep', 'aria-pressed'), 'true');
});

test('only the selected islands are relaxed, and it can be undone', async (t) => {
  const page = await openUvs(t, APART);
  const before = await exported(page);
  await select(page, WIDE);
  assert.match(await textOf(page, '#selection-text'), /^Island 0: 2 triangles, stretch 2\.1/);
  assert.equal(await textOf(page, '#pack-scope'), '1 selected');
  await page.click('#pack-relax');
  await changed(page, 'Relaxed island 0, checked in');
  const after = await exported(page);
  assertNear(after.slice(1), before.slice(1), 'the others stay');
  const [width, height] = sidesOf(after[0]);
  assert.ok(Math.abs(width / height - 1) < 1e-3);
  assert.match(await textOf(page, '#selection-text'), /^Island 0: 2 triangles, stretch 1/);
  await page.click('#undo');
  await settled(page);
  assertNear(await exported(page), before, 'undone');
  assert.equal(await page.getAttribute('#pack-keep', 'aria-pressed'), 'true');
});

test('islands that share texels stay as they are, and one sentence says why', async (t) => {
  const page = await openUvs(t, [WIDE, WIDE, MIRRORED]);
  await page.click('#pack-relax');
  await changed(page, 'Relaxed island 2; 2 stay as they are, checked in');
  assert.equal(await textOf(page, '#alert'), '');
  const why =
    /^2 islands stay as they are, such as island 0: it lies on another island or on itself/;
  assert.match(await textOf(page, '#notice'), why);
  await dropAndWait(page, 'all.obj', squares([WIDE, WIDE]));
  await choose(page, 'pack');
  await layoutReady(page);
  await page.click('#pack-relax');
  await changed(page, '2 islands stay as they are');
  assert.match(await textOf(page, '#notice'), why);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await page.getAttribute('#pack-keep', 'aria-pressed'), 'true');
});

test('islands are selected by what is wrong with them, by their object, and by an area', async (t) => {
  const page = await openUvs(t, [WIDE, [0.3, 0.15, 0.3, 0.3], MIRRORED]);
  const selected = async (text) => assert.match(await textOf(page, '#selection-text'), text);
  await selectBy(page, 'overlapping');
  await selected(/^2 islands: /);
  await selectBy(page, 'flipped');
  await selected(/^Island 2: /);
  await selectBy(page, '1.2');
  await selected(/^2 islands: /);
  await selectBy(page, 'group');
  // What is said aloud may come later than what is shown.
  await page
    .locator('#live')
    .getByText(/^No other island is part of these objects/)
    .waitFor({ state: 'attached' });
  await selectBy(page, 'invert');
  await selected(/^Island 1: /);
  const [left, top] = await pixelOf(page, [0.45, 0.98]);
  const [right, bottom] = await pixelOf(page, [0.55, 0.7]);
  await page.mouse.move(left - 30, top);
  await page.mouse.down();
  await page.mouse.move(right, bottom, { steps: 4 });
  await page.mouse.up();
  await selected(/^Island 2: /);
});

test('the selected islands are packed around the others, which stay', async (t) => {
  const on = [0.62, 0.62, 0.1, 0.1];
  const page = await openUvs(t, [WIDE, SQUARE, on, [0.15, 0.12, 0.1, 0.4]]);
  const before = await exported(page);
  const [x, y] = await pixelOf(page, [0.45, 0.15]);
  await page.mouse.click(x, y);
  assert.match(await textOf(page, '#selection-text'), /^Island 0: /);
  assert.ok(await page.isVisible('#pack-padding'), 'its options count');
  await page.click('#pack-islands');
  await changed(page, 'Repacked 1 island; 3 stay, checked in');
  const after = await exported(page);
  assertNear(after.slice(1), before.slice(1), 'the others stay');
  const [width, height] = sidesOf(after[0]);
  assert.ok(Math.max(width, height) <= 0.4 && Math.max(width, height) > 0.39, 'it does not grow');
  for (const [u, v] of after[0]) assert.ok(u > 0 && u < 1 && v > 0 && v < 1);
});

test('a selected island of a file is moved, and what overlaps then is marked', async (t) => {
  const page = await openUvs(t, APART);
  await select(page, WIDE);
  assert.ok(await page.isHidden('#selection-density-label'), 'nothing asks for a density');
  const [x, y, side] = await pixelOf(page, middleOf(squareOf(WIDE)));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + side * 0.45, y - side * 0.52, { steps: 4 });
  await page.mouse.up();
  await changed(page, 'Moved island 0, checked in');
  assert.equal((await metrics(page)).Overlapping, '2');
});

test('objects of a file are listed with its islands, hidden, and get tiles of their own', async (t) => {
  // Each has the whole square for itself, as where each has a texture.
  const whole = [0, 0, 1, 1];
  const page = await openUvs(t, [whole, whole, [0.1, 0.1, 0.5, 0.5]]);
  await page.click('#details-toggle');
  await page.click('#tab-objects');
  await page.waitForFunction(
    () => document.querySelector('.part-table td:nth-child(3)')?.innerText === '1',
  );
  assert.equal(await page.locator('.part-table tbody tr').count(), 3);
  assert.ok(await page.isHidden('.part-table .number'), 'no density');
  await page.getByRole('button', { name: 'square 1', exact: true }).click();
  assert.match(await textOf(page, '#selection-text'), /^Island 1: /);
  await page.getByRole('button', { name: 'Hide square 1', exact: true }).click();
  assert.equal(await textOf(page, '#selection-text'), '1 island hidden');
  await page.click('#selection-show-all');

  await page.click('#pack-islands');
  await changed(page, 'Repacked in');
  assert.equal(await textOf(page, '#layout-info'), '3 islands');
  await page.selectOption('#pack-tiles', 'object');
  await page.waitForFunction(
    () => document.querySelector('#layout-info').innerText === '3 islands, 3 tiles',
  );
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const tiles = (await exported(page)).map((corners) => Math.floor(middleOf(corners)[0]));
  assert.deepEqual(tiles, [0, 1, 2]);
  for (const corners of await exported(page))
    assert.ok(sidesOf(corners)[0] > 0.98, 'each fills its tile');
  assert.match(page.url(), /tiles=object/);
  // They keep these tiles.
  await page.selectOption('#pack-tiles', 'one');
  await settled(page);
  assert.equal(await textOf(page, '#layout-info'), '3 islands');
  assert.ok(await page.locator('#pack-tiles option[value="material"]').isDisabled());
});

test('a phone shows the layout of a file as large as an atlas', async (t) => {
  const viewport = { width: 390, height: 844 };
  const page = await openUvs(t, APART, { viewport, hasTouch: true });
  const { height } = await page.locator('#layout-canvas').boundingBox();
  assert.ok(height > 0.25 * viewport.height, `${height}`);
});
