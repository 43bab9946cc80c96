// The texel density of charts relative to each other: set as a number or by scaling, and kept when charts are packed anew.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { densityOf, FACES, isNear, shownDensity as shown, TILES } from './density-page.mjs';
import { atlas, middleOf, pixelOf } from './layout.mjs';
import { openPage, reload, settled, textOf } from './page.mjs';

/** Selects the chart of the face that is now at this place. */
async function select(page, { uv }, face) {
  const [x, y] = await pixelOf(page, middleOf(uv[face]));
  await page.mouse.click(x, y);
  assert.match(await textOf(page, '#selection-text'), /^Island \d+: /);
}

async function setDensity(page, text) {
  await page.fill('#selection-density', text);
  await page.press('#selection-density', 'Enter');
  await settled(page);
}

async function packAgain(page) {
  await page.click('#details-toggle');
  await page.click('#tab-charts');
  await page.click('#pack-again');
  await settled(page);
  await page.click('#details-toggle');
}

test('a density is set, kept when all is packed anew, by other options and after a reload, and undone', async (t) => {
  const page = await openPage(t, { own: true, mode: 'unwrap', open: ['tiles.obj', TILES] });
  const before = await atlas(page);
  isNear(densityOf(before, 0), 1);
  await select(page, before, 0);
  assert.equal(await shown(page), '1');
  await setDensity(page, '2');
  assert.match(await textOf(page, '#run-text'), /^Density of island \d+: 2, checked in/);
  assert.equal(await shown(page), '2');
  isNear(densityOf(await atlas(page), 0), 2);
  await packAgain(page);
  const packed = await atlas(page);
  isNear(densityOf(packed, 0), 2);
  assert.match(await textOf(page, '#badge'), /^Valid$/);
  await select(page, packed, 0);
  assert.equal(await shown(page), '2');
  await page.fill('#padding', '6');
  await settled(page);
  isNear(densityOf(await atlas(page), 0), 2);
  assert.match(await textOf(page, '#badge'), /^Valid$/);
  await reload(page);
  const again = await atlas(page);
  isNear(densityOf(again, 0), 2);
  await select(page, again, 0);
  assert.equal(await shown(page), '2');
  // Set to 1, all are alike again.
  await setDensity(page, '1');
  await packAgain(page);
  isNear(densityOf(await atlas(page), 0), 1);
  await page.click('#undo');
  await page.click('#undo');
  await settled(page);
  isNear(densityOf(await atlas(page), 0), 2);
});

test('an island that is scaled keeps its size beside the others, until densities are even', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES] });
  const before = await atlas(page);
  await select(page, before, FACES);
  await page.focus('#layout-canvas');
  await page.keyboard.press('s');
  await page.keyboard.type('.5');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.equal(await shown(page), '0.5');
  await packAgain(page);
  isNear(densityOf(await atlas(page), FACES), 0.5);
  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  assert.equal(await shown(page), '', 'islands of different densities');
  await page.keyboard.press('Alt+a');
  assert.ok(await page.isHidden('#selection-density'));
  await select(page, await atlas(page), FACES);
  await page.click('#selection-arrange');
  await page.locator('#arrange-menu [data-value=evened]').click();
  await settled(page);
  assert.equal(await shown(page), '1');
  await packAgain(page);
  isNear(densityOf(await atlas(page), FACES), 1);
});

test('an island that grows beyond the tile and over others is said to do both, and one click packs it', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES] });
  const before = await atlas(page);
  await select(page, before, 0);
  await setDensity(page, '2.5');
  assert.equal(await textOf(page, '#reason'), '1 island outside its tile, 2 islands overlap');
  assert.equal(await textOf(page, '#remedy'), 'Repack');
  await page.click('#remedy');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Repacked in/);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const packed = await atlas(page);
  isNear(densityOf(packed, 0), 2.5);
  assert.deepEqual(packed.ofFace, before.ofFace, 'the same islands');
});

test('what is no density is not taken, and Escape takes back what is typed', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES] });
  await select(page, await atlas(page), 0);
  await page.fill('#selection-density', '0');
  assert.equal(await page.getAttribute('#selection-density', 'aria-invalid'), 'true');
  await page.press('#selection-density', 'Enter');
  assert.match(
    await textOf(page, '#live'),
    /^0 was ignored: Density must be from 0.001 to 1000. It is still 1.$/,
  );
  assert.equal(await shown(page), '1');
  await page.fill('#selection-density', '7');
  await page.press('#selection-density', 'Escape');
  assert.equal(await shown(page), '1');
  assert.ok(await page.isVisible('#selection-density'));
  await page.press('#selection-density', 'Escape');
  assert.ok(await page.isHidden('#selection-density'));
  assert.ok(await page.isDisabled('#undo'));
});
