// The texel density of charts relative to each other: set as a number or by scaling, and kept when charts are packed anew.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { densityOf, FACES, isNear, shownDensity as shown, TILES } from './density-page.mjs';
import { atlas, middleOf, pixelOf } from './layout.mjs';
import { metrics, openPage, reload, settled, textOf } from './page.mjs';

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
  assert.match(await textOf(page, '#run-text'), /^Set density 2 on island \d+(, checked)? in/);
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
  assert.match(await textOf(page, '#run-text'), /^Evened out island \d+ in .*; repacked, /);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await shown(page), '1');
  isNear(densityOf(await atlas(page), FACES), 1);
});

test('where the density of an island leaves too little room, all are packed at once, as one step', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES] });
  const before = await atlas(page);
  await select(page, before, 0);
  await setDensity(page, '2.5');
  assert.match(
    await textOf(page, '#run-text'),
    /^Set density 2\.5 on island \d+ in .*; repacked, because there was too little room$/,
  );
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await shown(page), '2.5');
  const packed = await atlas(page);
  isNear(densityOf(packed, 0), 2.5);
  assert.deepEqual(packed.ofFace, before.ofFace, 'the same islands');
  await page.click('#undo');
  await settled(page);
  assert.deepEqual(await atlas(page), before);
  assert.ok(await page.isDisabled('#undo'));
  await page.click('#redo');
  await settled(page);
  assert.deepEqual(await atlas(page), packed);
  // What is moved by hand from there stays where it is put.
  await page.focus('#layout-canvas');
  await page.keyboard.press('s');
  await page.keyboard.type('.5');
  await page.keyboard.press('Enter');
  await settled(page);
  const scaled = await atlas(page);
  isNear(densityOf(scaled, 0), 1.25);
  assert.deepEqual(scaled.uv.slice(FACES), packed.uv.slice(FACES));
});

test('a locked island stays where a density packs the others', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES] });
  const before = await atlas(page);
  await select(page, before, 2 * FACES);
  const [, locked] = /^Island (\d+):/.exec(await textOf(page, '#selection-text'));
  await page.click('#details-toggle');
  await page.click(`.lock[data-chart="${locked}"]`);
  await page.click('#details-toggle');
  await select(page, before, 0);
  await setDensity(page, '2.5');
  assert.match(await textOf(page, '#run-text'), /; repacked, because there was too little room$/);
  const packed = await atlas(page);
  assert.deepEqual(packed.uv.slice(2 * FACES), before.uv.slice(2 * FACES));
  isNear(densityOf(packed, 0) / densityOf(packed, FACES), 2.5);
  assert.doesNotMatch(await textOf(page, '#badge'), /Not valid/);
});

test('an island that is scaled by hand stays where it is put, and one click packs it', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES] });
  const before = await atlas(page);
  await select(page, before, 0);
  await page.focus('#layout-canvas');
  await page.keyboard.press('s');
  await page.keyboard.type('2.5');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.equal(await textOf(page, '#reason'), '1 island outside its tile, 2 islands overlap');
  assert.equal(await textOf(page, '#remedy'), 'Repack');
  // A density does not undo what was put there on purpose.
  await setDensity(page, '2.4');
  assert.equal(await textOf(page, '#remedy'), 'Repack');
  assert.match(await textOf(page, '#run-text'), /^Set density 2\.4 on island \d+, checked in/);
  await page.click('#remedy');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Repacked in/);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const packed = await atlas(page);
  isNear(densityOf(packed, 0), 2.4);
  assert.deepEqual(packed.ofFace, before.ofFace, 'the same islands');
});

test('where there is no room for a density at all, the island has it and the badge says so', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES] });
  const most = Math.floor(Number((await metrics(page))['Texels per unit']));
  await page.click('#more-toggle');
  await page.fill('#more-texel-density', String(most));
  await page.press('#more-texel-density', 'Enter');
  await settled(page);
  await page.click('#more-toggle');
  await select(page, await atlas(page), 0);
  await setDensity(page, '2.5');
  assert.match(await textOf(page, '#run-text'), /^Set density 2\.5 on island .*, not valid$/);
  isNear(densityOf(await atlas(page), 0), 2.5);
  await page.click('#remedy');
  await settled(page);
  assert.match(await textOf(page, '#alert'), /the islands do not fit one tile/);
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
