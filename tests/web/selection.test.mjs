// Charts are selected in either view, framed, isolated and hidden.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { objText, together, torus } from '../support/surfaces.mjs';
import { pixelOf } from './layout.mjs';
import { choose, drawn, dropAndWait, openPage, settled, textOf } from './page.mjs';

/** Rings side by side, a chart each. */
const RINGS = objText(together([0, 1, 2].map((i) => [torus(16, 8), [2.6 * i, 0, 0]])));

const opened = (t, options) => openPage(t, { open: ['rings.obj', RINGS], ...options });

async function at(page, view, x, y) {
  const box = await page.locator(`#${view}-canvas`).boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}

/** Clicks where a chart is: looks for one along the middle line. */
async function clickChart(page, view, from = 0.2) {
  for (let x = from; x < 0.9; x += 0.04) {
    await page.mouse.click(...(await at(page, view, x, 0.5)));
    if (await page.isVisible('#selection')) return x;
  }
  return assert.fail(`no island in the ${view}`);
}

/** Short, for messages. */
const picture = async (page, view) =>
  createHash('md5')
    .update(await page.locator(`#${view}-canvas`).screenshot())
    .digest('hex');

const selectedRows = (page) => page.locator('.chart-table tr[aria-selected="true"]').count();

test('a click in the layout selects an island in both views and in the list', async (t) => {
  const page = await opened(t);
  await page.click('#details-toggle');
  const mesh = await picture(page, 'mesh');
  await clickChart(page, 'layout');
  assert.match(await textOf(page, '#selection-text'), /^Island \d+: \d+ triangles, stretch 1/);
  assert.equal(await selectedRows(page), 1);
  await page.mouse.move(0, 0);
  assert.notEqual(await picture(page, 'mesh'), mesh, 'it is outlined on the mesh');

  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  const charts = await page.locator('.chart-table tbody tr').count();
  assert.equal(await selectedRows(page), charts);
  assert.match(await textOf(page, '#selection-text'), /^\d+ islands: .*, 100\s% of the surface$/);
  await page.keyboard.press('Escape');
  assert.ok(await page.isHidden('#selection'));
  assert.equal(await picture(page, 'mesh'), mesh);
});

test('the bar of one island covers nothing of a fitted atlas, beside the details neither', async (t) => {
  const page = await opened(t);
  await clickChart(page, 'layout');
  for (const details of [false, true]) {
    if (details) await page.click('#details-toggle');
    for (const [width, height] of [
      [1440, 900],
      [1280, 720],
      [1024, 768],
      [820, 1180],
    ]) {
      await page.setViewportSize({ width, height });
      await drawn(page);
      const bar = await page.locator('#selection').boundingBox();
      const [, top] = await pixelOf(page, [0, 1]);
      assert.ok(bar.y + bar.height <= top, `${width}: ${bar.y} + ${bar.height}, atlas at ${top}`);
      const { x, width: own } = await page.locator('#selection-hide').boundingBox();
      assert.ok(x + own <= bar.x + bar.width, `${width}: all buttons are in the bar`);
    }
  }
});

test('on a phone the bar is at the foot of the screen, and all else stays within reach', async (t) => {
  const viewport = { width: 390, height: 844 };
  const page = await opened(t, { viewport, hasTouch: true, isMobile: true });
  // As if the user had scrolled no further than to the upper part of the layout.
  await page.evaluate(() => {
    const { top } = document.querySelector('#layout-canvas').getBoundingClientRect();
    scrollTo(0, scrollY + top + 130 - innerHeight);
  });
  const { x, y, width } = await page.locator('#layout-canvas').boundingBox();
  for (let i = 1; i < 20 && (await page.isHidden('#selection')); ++i)
    await page.touchscreen.tap(x + (i * width) / 20, y + 110);
  const bar = await page.locator('#selection').boundingBox();
  assert.deepEqual([bar.x, bar.width, bar.y + bar.height], [0, viewport.width, viewport.height]);
  const canvas = await page.locator('#layout-canvas').boundingBox();
  assert.ok(canvas.y + canvas.height <= bar.y + 0.5, 'it covers nothing of the layout');

  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  const { y: top, height } = await page.locator('.dock').boundingBox();
  assert.ok(top + height <= bar.y, 'the page ends above it');
  await page.locator('#selection-arrange').tap();
  const menu = await page.locator('#arrange-menu').boundingBox();
  assert.ok(menu.y >= 0 && menu.y + menu.height <= bar.y, 'the menu opens above it');
  await page.keyboard.press('Escape');
  await page.locator('#selection-none').tap();
  assert.ok(await page.isHidden('#selection'));

  // Hints are in the words of fingers, and name no key.
  assert.match(await textOf(page, '#seam-hint'), /^Tap a vertex .* double-tap/);
  await page.locator('#mesh-canvas').tap();
  await page.locator('#seam-cancel').waitFor();
  assert.match(await textOf(page, '#seam-hint'), /: tap the end of the cut, or Cancel cut$/);
});

test('islands are hidden, isolated and shown again, by button and key', async (t) => {
  const page = await opened(t);
  const all = await picture(page, 'layout');
  await clickChart(page, 'layout');
  await page.click('#selection-hide');
  await page.mouse.move(0, 0);
  assert.match(await textOf(page, '#selection-text'), /^1 island hidden$/);
  assert.ok(await page.isHidden('#selection-frame'));
  assert.notEqual(await picture(page, 'layout'), all);
  await page.click('#selection-show-all');
  await page.mouse.move(0, 0);
  assert.equal(await picture(page, 'layout'), all);

  await clickChart(page, 'layout');
  await page.focus('#layout-canvas');
  await page.keyboard.press('/');
  const [hidden] = (await textOf(page, '#selection-text')).match(/\d+/);
  assert.ok(hidden);
  assert.ok(await page.isVisible('#selection-show-all'));
  await page.keyboard.press('.');
  await page.mouse.move(0, 0);
  const framed = await picture(page, 'layout');
  assert.notEqual(framed, all);
  await page.keyboard.press('/');
  assert.notEqual(await picture(page, 'layout'), framed);
  await page.keyboard.press('h');
  await page.keyboard.press('Alt+h');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Home');
  // Keys aim at the middle while the view has the focus.
  await page.evaluate(() => document.activeElement.blur());
  await page.mouse.move(0, 0);
  assert.equal(await picture(page, 'layout'), all);
});

test('on the mesh clicks select with that tool alone, and Shift adds islands', async (t) => {
  const page = await opened(t);
  await page.mouse.click(...(await at(page, 'mesh', 0.25, 0.5)));
  assert.ok(await page.isHidden('#selection'), 'the click began a cut');
  await page.keyboard.press('Escape');
  await page.click('#seam-select');
  assert.equal(await page.getAttribute('#seam-cut', 'aria-pressed'), 'false');
  const x = await clickChart(page, 'mesh', 0.1);
  assert.match(await textOf(page, '#selection-text'), /^Island \d+: /);
  const before = await textOf(page, '#selection-text');
  await page.keyboard.down('Shift');
  for (let next = x + 0.06; next < 0.95; next += 0.04) {
    await page.mouse.click(...(await at(page, 'mesh', next, 0.5)));
    if ((await textOf(page, '#selection-text')) !== before) break;
  }
  await page.keyboard.up('Shift');
  assert.match(await textOf(page, '#selection-text'), /^\d+ islands: |^Island/);
  assert.notEqual(await textOf(page, '#selection-text'), before);
});

test('Escape goes from a tool back to Select, once it has nothing else to cancel', async (t) => {
  const page = await openPage(t, { open: ['grid.obj', grid(4)] });
  const isPressed = async (tool) =>
    (await page.getAttribute(`#seam-${tool}`, 'aria-pressed')) === 'true';
  // A cut from the vertex in the middle.
  await page.focus('#mesh-canvas');
  await page.keyboard.press('Enter');
  await page.locator('#seam-cancel').waitFor();
  await page.keyboard.press('Escape');
  assert.ok(await isPressed('cut'), 'the cut was cancelled');
  await page.keyboard.press('Escape');
  assert.ok((await isPressed('select')) && !(await isPressed('cut')));
  for (const tool of ['cut', 'join']) {
    await page.click(`#seam-${tool}`);
    assert.ok(await isPressed(tool));
    await page.click(`#seam-${tool}`);
    assert.ok((await isPressed('select')) && !(await isPressed(tool)), 'pressed again');
  }
  await page.click('#seam-cut');
  // In the layout the key has nothing to do with the tools of the mesh.
  await page.focus('#layout-canvas');
  await page.keyboard.press('Escape');
  assert.ok(await isPressed('cut'));
  await page.focus('#seam-cut');
  await page.keyboard.press('Escape');
  assert.ok(await isPressed('select'));
});

test('an island under the pointer stands out in the other view', async (t) => {
  const page = await opened(t);
  await page.mouse.move(0, 0);
  const plain = await picture(page, 'mesh');
  const x = await clickChart(page, 'layout');
  await page.keyboard.press('Escape');
  await page.mouse.move(...(await at(page, 'layout', x, 0.49)));
  await page.mouse.move(...(await at(page, 'layout', x, 0.5)));
  await page.waitForFunction(() => new Promise((done) => requestAnimationFrame(() => done(true))));
  assert.notEqual(await picture(page, 'mesh'), plain);
  await page.mouse.move(0, 0);
  assert.equal(await picture(page, 'mesh'), plain);
});

test('another layout, another mesh and one piece have no selection', async (t) => {
  const page = await opened(t);
  await page.click('#seams-auto');
  await settled(page);
  await clickChart(page, 'layout');
  await page.click('#selection-hide');
  await page.selectOption('#resolution', '2048');
  await settled(page);
  assert.ok(await page.isVisible('#selection-show-all'), 'the islands are the same');
  await page.click('#seams-sharp');
  await page.fill('#sharp-degrees', '20');
  await settled(page);
  assert.ok(await page.isHidden('#selection'));
  await clickChart(page, 'layout');
  await dropAndWait(page, 'ring.obj', objText(torus(12, 8)));
  assert.ok(await page.isHidden('#selection'));
  await dropAndWait(page, 'grid.obj', 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n');
  await choose(page, 'flatten');
  await page.mouse.click(...(await at(page, 'layout', 0.5, 0.5)));
  assert.ok(await page.isHidden('#selection'));
});
