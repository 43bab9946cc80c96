// Whole rows of seams at once: the loop through an edge by a double-click, and all sharp edges.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CUBE } from '../support/small-meshes.mjs';
import { objText, sphere } from '../support/surfaces.mjs';
import { openPage, settled, textOf } from './page.mjs';
import {
  charts,
  clickAt,
  drawn,
  edited,
  hint,
  pixelOf,
  point,
  pointAtLoop,
  SMALL,
} from './seam-page.mjs';

/** n x n squares in the plane of the screen. */
function quads(n) {
  const positions = [];
  const faces = [];
  for (let y = 0; y <= n; ++y) for (let x = 0; x <= n; ++x) positions.push([x, y, 0]);
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      const a = y * (n + 1) + x;
      faces.push([a, a + 1, a + n + 2, a + n + 1]);
    }
  return objText({ positions, faces });
}

const N = 5;
const openQuads = (t, options) =>
  openPage(t, { ...SMALL, ...options, open: ['quads.obj', quads(N)] });
const history = (page) => page.locator('#history').evaluate((list) => list.textContent);

/** Inside the square in the middle, and in one of its neighbours. */
const INSIDE = [0.5, 0.5];
const BESIDE = [0.5, 0.7];

async function doubleClick(page, first, second = first) {
  const [a, b] = [await pixelOf(page, first), await pixelOf(page, second)];
  await page.mouse.click(...a);
  await page.mouse.move(...b);
  await page.mouse.down({ clickCount: 2 });
  await page.mouse.up({ clickCount: 2 });
  await drawn(page);
  await settled(page);
}

test('a double-click on an edge cuts its loop and starts no cut, and undo joins it again', async (t) => {
  const page = await openQuads(t);
  const { place, text } = await pointAtLoop(page, INSIDE, BESIDE);
  assert.match(text, /^Vertex \d+: start a cut\. Double-click: cut a loop of 5 edges$/);
  await doubleClick(page, place);
  assert.equal(await edited(page), N);
  assert.equal(await charts(page), 2);
  assert.doesNotMatch(await hint(page), /^From vertex/, 'no cut is under way');
  assert.doesNotMatch(await hint(page), /Double-click/, 'it is cut already');
  assert.match(await history(page), /Cut a loop of 5 edges/);
  assert.doesNotMatch(await history(page), /Cut \d/);
  await page.click('#undo');
  await settled(page);
  assert.equal(await charts(page), 1);
  assert.equal(await page.getAttribute('#seams-auto', 'aria-pressed'), 'true');
});

test('the second click may be nearer to another vertex than the first one', async (t) => {
  const page = await openQuads(t);
  const { place, text } = await pointAtLoop(page, INSIDE, BESIDE);
  const [first] = /\d+/.exec(text);
  let other = place;
  for (let off = 1; first === /\d+/.exec(await hint(page))[0] && off < 12; ++off) {
    other = [place[0] + (off % 2 ? off : -off) / 200, place[1]];
    await point(page, ...other);
  }
  assert.notEqual(/\d+/.exec(await hint(page))[0], first);
  await doubleClick(page, place, other);
  assert.equal(await edited(page), N);
  assert.doesNotMatch(await history(page), /Cut \d/);
});

test('a double-click that ends a cut cuts no loop', async (t) => {
  const page = await openQuads(t);
  const { place } = await pointAtLoop(page, INSIDE, BESIDE);
  await clickAt(page, [0.5, 0.25]);
  assert.match(await textOf(page, '#run-text'), /^Cut started/);
  await doubleClick(page, place);
  assert.doesNotMatch(await history(page), /loop/);
  assert.match(await history(page), /Cut \d/);
  assert.doesNotMatch(await hint(page), /^From vertex/);
});

test('a double-tap cuts the loop', async (t) => {
  const page = await openQuads(t, { hasTouch: true });
  const { place } = await pointAtLoop(page, INSIDE, BESIDE);
  const [x, y] = await pixelOf(page, place);
  await page.mouse.move(0, 0);
  await page.touchscreen.tap(x, y);
  await page.touchscreen.tap(x + 3, y + 2);
  await page.waitForFunction(() =>
    /^seams edited/.test(document.querySelector('#seams-state').innerText),
  );
  await settled(page);
  assert.equal(await edited(page), N);
  assert.doesNotMatch(await history(page), /Cut \d/);
});

test('with Join a double-click cuts nothing, with Join and Alt it does', async (t) => {
  const page = await openQuads(t);
  const { place } = await pointAtLoop(page, INSIDE, BESIDE);
  await page.click('#seam-join');
  await doubleClick(page, place);
  assert.equal(await edited(page), -1);
  await page.keyboard.down('Alt');
  await doubleClick(page, place);
  await page.keyboard.up('Alt');
  assert.equal(await edited(page), N);
});

test('loops of triangles are cut as well', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['ball.obj', objText(sphere(8))] });
  const { place, text } = await pointAtLoop(page, INSIDE, [0.6, 0.6]);
  const [, count] = /a loop of (\d+) edges?$/.exec(text);
  assert.ok(Number(count) > 1);
  await doubleClick(page, place);
  assert.match(await history(page), new RegExp(`Cut a loop of ${count} edges?`));
  assert.equal(await textOf(page, '#alert'), '');
});

test('sharp edges are marked with one click and joined by undo', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['cube.obj', CUBE] });
  const cuts = await charts(page);
  assert.ok(cuts < 6);
  await page.hover('#sharp-mark');
  await drawn(page);
  const offered = /^(\d+) edges bend by more than 60°$/.exec(await hint(page));
  assert.ok(offered, await hint(page));
  await page.click('#sharp-mark');
  await settled(page);
  assert.equal(await charts(page), 6);
  assert.equal(await edited(page), 12);
  assert.match(await history(page), new RegExp(`Marked ${offered[1]} sharp edges`));
  await page.click('#sharp-mark');
  assert.equal(await textOf(page, '#run-text'), 'No other edge bends by more than 60°');
  await page.click('#undo');
  await settled(page);
  assert.equal(await charts(page), cuts);

  await page.hover('#sharp-mark');
  await page.fill('#sharp-marks-degrees', '90.5');
  await drawn(page);
  assert.equal(await hint(page), 'No other edge bends by more than 90.5°');
  await page.fill('#sharp-marks-degrees', '-1');
  await page.locator('#sharp-marks-degrees').blur();
  assert.equal(await page.inputValue('#sharp-marks-degrees'), '90.5');
  assert.match(await textOf(page, '#run-text'), /Sharp angle must be above 0 to 180/);
  await page.mouse.move(0, 0);
  await drawn(page);
  assert.match(await hint(page), /^Click a vertex/);
});

test('the angle of sharp seams is that of sharp marks', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['cube.obj', CUBE] });
  await page.click('#seams-sharp');
  await page.fill('#sharp-degrees', '42');
  await settled(page);
  assert.equal(await page.inputValue('#sharp-marks-degrees'), '42');
});
