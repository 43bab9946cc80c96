// Texel densities are painted on the mesh: whole islands or single faces, which the layout then follows.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isNear, shownDensity, TILES, tileDensities } from './density-page.mjs';
import { atlas, middleOf, pixelOf } from './layout.mjs';
import { drawn, openPage, reload, settled, textOf } from './page.mjs';

/** Three squares beside each other, seen from the front. */
async function opened(t, options) {
  const page = await openPage(t, { mode: 'unwrap', open: ['tiles.obj', TILES], ...options });
  await offered(page);
  return page;
}

/** The tools are beside the heat map of texels, once they are loaded. */
async function offered(page) {
  await page.selectOption('#shading', 'texels');
  await page.locator('#density-paint').waitFor();
}

const hint = (page) => page.evaluate(() => document.querySelector('#density-hint').textContent);
const isOn = async (page) => (await page.getAttribute('#density-paint', 'aria-pressed')) === 'true';

/** Turns the brush on; it finds the mesh in the middle of the view once that can be painted. */
async function start(page) {
  await page.selectOption('#shading', 'texels');
  await page.click('#density-paint');
  await drawn(page);
  const { x, y, width, height } = await page.locator('#mesh-canvas').boundingBox();
  await page.waitForFunction(
    ([clientX, clientY]) => {
      const how = { clientX, clientY, pointerType: 'mouse', isPrimary: true, bubbles: true };
      document.querySelector('#mesh-canvas').dispatchEvent(new PointerEvent('pointermove', how));
      return /^\d+ (island|face)/.test(document.querySelector('#density-hint').textContent);
    },
    [x + width / 2, y + height / 2],
  );
  return { x: x + width / 2, y: y + height / 2, width };
}

async function stroke(page, from, to = from, key) {
  if (key) await page.keyboard.down(key);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x + 1, to.y, { steps: 5 });
  await page.mouse.up();
  if (key) await page.keyboard.up(key);
  await settled(page);
}

/** The island of a face, in the layout. */
async function select(page, face) {
  // The legend of a heat map takes some of the room.
  await page.selectOption('#shading', 'plain');
  const { uv } = await atlas(page);
  await drawn(page);
  const [x, y] = await pixelOf(page, middleOf(uv[face]));
  await page.mouse.click(x, y);
  await page.waitForFunction(() => document.querySelector('#selection-density').value !== '');
}

test('islands that the brush touches get its density, at once and packed; undone, kept, erased', async (t) => {
  const page = await opened(t, { own: true });
  const before = await tileDensities(page);
  for (const density of before) isNear(density, 1);
  const middle = await start(page);
  assert.equal(await page.inputValue('#shading'), 'texels', 'the heat map shows what comes of it');
  await page.mouse.move(middle.x, middle.y);
  assert.equal(await hint(page), '1 island: paint 2×');
  await stroke(page, middle);
  assert.match(await textOf(page, '#run-text'), /^Painted density 2 on 1 island in /);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const [left, painted, right] = await tileDensities(page);
  isNear(painted / left, 2);
  isNear(right / left, 1);

  await select(page, 4);
  assert.equal(await shownDensity(page), '2', 'as if it was set');
  await page.click('#undo');
  await settled(page);
  isNear((await tileDensities(page))[1], 1);
  await page.click('#redo');
  await settled(page);
  await reload(page);
  await offered(page);
  isNear((await tileDensities(page))[1], 2);

  // A stroke over two of them; then one is erased, and then all.
  await start(page);
  await page.selectOption('#density-factor', '0.5');
  await stroke(page, middle, { ...middle, x: middle.x + middle.width / 3 });
  assert.match(await textOf(page, '#run-text'), /^Painted density 0.5 on 2 islands/);
  const halves = await tileDensities(page);
  isNear(halves[1] / halves[0], 0.5);
  isNear(halves[2] / halves[0], 0.5);
  await stroke(page, middle, middle, 'Alt');
  assert.match(await textOf(page, '#run-text'), /^Erased the density of 1 island/);
  const erased = await tileDensities(page);
  isNear(erased[1] / erased[0], 1);
  isNear(erased[2] / erased[0], 0.5);
  await page.click('#density-clear');
  await settled(page);
  for (const density of await tileDensities(page)) isNear(density, 1);
  assert.ok(await page.isHidden('#density-clear'));
});

test('of faces, an island gets the mean, which stays when another island is scaled', async (t) => {
  const page = await opened(t);
  const middle = await start(page);
  await page.click('#density-whole');
  await page.selectOption('#density-factor', '4');
  // One of the four squares of the tile.
  const square = { x: middle.x + middle.width / 40, y: middle.y + middle.width / 40 };
  await drawn(page);
  await page.mouse.move(square.x, square.y);
  assert.match(await hint(page), /^\d face/);
  const touched = Number(/^\d/.exec(await hint(page)));
  await stroke(page, square, { ...square, x: square.x - 1 });
  const mean = Math.sqrt((4 - touched + 16 * touched) / 4);
  const [left, painted] = await tileDensities(page);
  isNear(painted / left, mean);
  await page.click('#density-paint');
  await select(page, 4);
  isNear(Number(await shownDensity(page)), mean);
  await select(page, 8);
  await page.fill('#selection-density', '0.5');
  await page.press('#selection-density', 'Enter');
  await settled(page);
  const scaled = await tileDensities(page);
  isNear(scaled[1] / scaled[0], mean);
  isNear(scaled[2] / scaled[0], 0.5);
  // What was painted is still there, face by face.
  await start(page);
  await stroke(page, square, { ...square, x: square.x - 1 }, 'Alt');
  const erased = await tileDensities(page);
  isNear(erased[1] / erased[0], 1);
  isNear(erased[2] / erased[0], 0.5);
});

test('keys paint in the middle, tools for seams end it, and beside the mesh a drag turns it', async (t) => {
  const page = await opened(t);
  const middle = await start(page);
  await page.focus('#mesh-canvas');
  await page.keyboard.press('Enter');
  await settled(page);
  isNear((await tileDensities(page))[1], 2);
  await page.focus('#mesh-canvas');
  await page.keyboard.press('Enter');
  assert.equal(await textOf(page, '#live'), 'No densities changed');
  await page.keyboard.press('d');
  assert.ok(!(await isOn(page)));
  await page.selectOption('#shading', 'plain');
  assert.ok(await page.isHidden('#density-paint'));
  await page.focus('#mesh-canvas');
  await page.keyboard.press('d');
  assert.ok(await isOn(page));
  assert.equal(await page.inputValue('#shading'), 'texels', 'the heat map shows what comes of it');
  await page.click('#seam-cut');
  assert.ok(!(await isOn(page)));
  await page.click('#density-paint');
  assert.equal(await page.getAttribute('#seam-select', 'aria-pressed'), 'true');
  const { y } = await page.locator('#mesh-canvas').boundingBox();
  const beside = { x: middle.x, y: y + 20 };
  const picture = () => page.locator('#mesh-canvas').screenshot();
  const before = await picture();
  await stroke(page, beside, { ...beside, x: beside.x + 80 });
  assert.notDeepEqual(await picture(), before);
  isNear((await tileDensities(page))[1], 2);
});

test('a finger paints', async (t) => {
  const page = await opened(t, { hasTouch: true, viewport: { width: 390, height: 844 } });
  await start(page);
  await page.locator('#mesh-canvas').scrollIntoViewIfNeeded();
  const { x, y, width, height } = await page.locator('#mesh-canvas').boundingBox();
  await page.touchscreen.tap(x + width / 2, y + height / 2);
  await page.waitForFunction(() =>
    /^Painted density 2 on 1 island/.test(document.querySelector('#run-text').textContent),
  );
  await settled(page);
  isNear((await tileDensities(page))[1], 2);
});
