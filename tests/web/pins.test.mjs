// Vertices are pinned in the layout, and charts bent by dragging the pins.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { atlas, middleOf, pixelOf } from './layout.mjs';
import {
  drawn,
  exportAs,
  exportMesh,
  metrics,
  openPage,
  reload,
  settled,
  textOf,
} from './page.mjs';

const RING = objText(torus(24, 12));

/** Corners of faces of the largest chart, far from each other. The bar of pins is far from the first. */
function farCorners({ uv, ofFace }, count) {
  const sizes = new Map();
  for (const chart of ofFace) sizes.set(chart, (sizes.get(chart) ?? 0) + 1);
  const [[largest]] = [...sizes].sort((a, b) => b[1] - a[1]);
  const all = uv.flatMap((corners, f) =>
    ofFace[f] === largest ? corners.map((at, k) => ({ f, k, at })) : [],
  );
  const found = [all.reduce((lowest, each) => (each.at[1] < lowest.at[1] ? each : lowest))];
  while (found.length < count) {
    const room = ({ at }) =>
      Math.min(...found.map((each) => Math.hypot(at[0] - each.at[0], at[1] - each.at[1])));
    found.push(all.reduce((best, each) => (room(each) > room(best) ? each : best)));
  }
  return found;
}

async function openWithPins(t, count, options = {}) {
  const page = await openPage(t, { open: ['ring.obj', RING], ...options });
  const before = await atlas(page);
  const corners = farCorners(before, count);
  await page.click('#pin');
  for (const { at } of corners) await pin(page, at);
  return { page, before, corners };
}

async function pin(page, at) {
  const [x, y] = await pixelOf(page, at);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.up();
}

/** Drags from a point of uv; returns how far in uv. */
async function drag(page, from, [right, up]) {
  const [x, y, side] = await pixelOf(page, from);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + right, y - up, { steps: 4 });
  await drawn(page);
  return [right / side, up / side];
}

async function drop(page) {
  await page.mouse.up();
  await page.waitForFunction(() =>
    /checked in/.test(document.querySelector('#run-text').textContent),
  );
  await settled(page);
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
const over = ([a, b], [c, d]) => times([a, b], [c / (c * c + d * d), -d / (c * c + d * d)]);

function assertNear(a, b, most, what) {
  for (const d of [0, 1]) assert.ok(Math.abs(a[d] - b[d]) < most, `${what}: ${a} ${b}`);
}

/** Calls `see` with each corner of the chart before and after; all others must be the same. */
function compare(before, after, { f }, see) {
  before.uv.forEach((corners, face) => {
    corners.forEach((at, k) => {
      if (before.ofFace[face] === before.ofFace[f]) see(at, after.uv[face][k]);
      else assert.deepEqual(after.uv[face][k], at, `face ${face} stays`);
    });
  });
}

test('a single pin moves its island', async (t) => {
  const { page, before, corners } = await openWithPins(t, 1);
  assert.match(await textOf(page, '#pins-text'), /^1 pin\. /);
  const by = await drag(page, corners[0].at, [24, -16]);
  assert.match(await textOf(page, '#pins-text'), /^Move u 0\.\d+, v \u22120\.\d+/);
  await drop(page);
  assert.match(await textOf(page, '#run-text'), /^Moved a pin of island \d+, checked in/);
  compare(before, await atlas(page), corners[0], (a, b) => assertNear(minus(b, a), by, 2e-3));
});

test('with two pins the island turns and grows about the other', async (t) => {
  const { page, before, corners } = await openWithPins(t, 2);
  const [dragged, still] = corners;
  await drag(page, dragged.at, [20, 26]);
  await drop(page);
  const after = await atlas(page);
  const now = ({ f, k }) => after.uv[f][k];
  assertNear(now(still), still.at, 1e-6, 'the other pin');
  const factor = over(minus(now(dragged), still.at), minus(dragged.at, still.at));
  compare(before, after, dragged, (a, b) =>
    assertNear(minus(b, still.at), times(minus(a, still.at), factor), 1e-6),
  );
});

test('with more pins the island bends, others stay, and all of it is undone', async (t) => {
  const { page, before, corners } = await openWithPins(t, 4);
  const stretch = await textOf(page, '#metrics');
  const picture = () => page.locator('#layout-canvas').screenshot();
  await drawn(page);
  const still = await picture();
  const by = await drag(page, corners[1].at, [-18, 12]);
  await page.waitForFunction(() => true);
  const bent = await picture();
  assert.notDeepEqual(bent, still);
  await drop(page);
  const after = await atlas(page);
  for (const [i, { f, k, at }] of corners.entries())
    assertNear(minus(after.uv[f][k], at), i === 1 ? by : [0, 0], i === 1 ? 2e-3 : 1e-6, `pin ${i}`);
  const moves = [];
  compare(before, after, corners[0], (a, b) => moves.push(Math.hypot(...minus(b, a))));
  assert.ok(new Set(moves.map((move) => move.toFixed(3))).size > 5, 'not all by the same');
  assert.notEqual(await textOf(page, '#metrics'), stretch, 'it is measured again');

  await page.focus('#layout-canvas');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual((await atlas(page)).uv, before.uv);
  assert.match(await textOf(page, '#pins-text'), /^4 pins/);
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.match(await textOf(page, '#pins-text'), /^3 pins/);
  await page.click('#details-toggle');
  await page.click('#tab-history');
  assert.deepEqual(
    (await page.locator('#history .step').allInnerTexts()).map((text) =>
      text.replace(/ (of|Undone|ring).*$/s, ''),
    ),
    ['Open', ...Array(4).fill('Pinned a vertex'), 'Moved a pin'],
  );
});

test('a click removes a pin, Escape puts it back, P ends it all', async (t) => {
  const { page, before, corners } = await openWithPins(t, 3);
  await drag(page, corners[2].at, [30, 30]);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  assert.deepEqual((await atlas(page)).uv, before.uv);
  await pin(page, corners[2].at);
  assert.match(await textOf(page, '#pins-text'), /^2 pins/);
  await page.click('#pins-remove');
  assert.equal(await textOf(page, '#pins-text'), 'Click a vertex to pin it');
  await page.focus('#layout-canvas');
  await page.keyboard.press('p');
  assert.ok(await page.isHidden('#pins'));
  await pin(page, middleOf(before.uv[corners[2].f]));
  assert.match(await textOf(page, '#selection-text'), /^Island \d/, 'a click selects again');
});

test('pins are set and moved by keys alone', async (t) => {
  const page = await openPage(t, { open: ['ball.obj', objText(sphere(8))] });
  const before = await atlas(page);
  await page.keyboard.press('p');
  await page.keyboard.press('Enter');
  assert.match(await textOf(page, '#pins-text'), /^1 pin\. /);
  await page.keyboard.press('g');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+ArrowUp');
  assert.match(await textOf(page, '#pins-text'), /^Move u /);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() =>
    /checked in/.test(document.querySelector('#run-text').textContent),
  );
  await settled(page);
  const after = await atlas(page);
  const moved = before.uv.flatMap((corners, f) =>
    corners.map((at, k) => minus(after.uv[f][k], at)),
  );
  const [first] = moved.filter(([u, v]) => u !== 0 || v !== 0);
  assertNear(first, [1 / 1024, 10 / 1024], 1e-6);
});

test('an island that folds is not valid, is written all the same, and comes back with its pins', async (t) => {
  const { page, corners } = await openWithPins(t, 4);
  await drag(page, corners[1].at, [-160, -120]);
  await drop(page);
  assert.equal(await textOf(page, '#badge'), 'Not valid');
  assert.match(await textOf(page, '#marks'), /not valid/);
  const folded = await atlas(page);
  const { bytes } = await exportAs(page, 'ply');
  assert.match(bytes.toString('latin1'), /^ply/);
  await reload(page);
  assert.match(await textOf(page, '#run-text'), /^Restored ring\.obj/);
  assert.equal(await textOf(page, '#badge'), 'Not valid');
  assert.deepEqual((await atlas(page)).uv, folded.uv);
  await page.click('#pin');
  assert.match(await textOf(page, '#pins-text'), /^4 pins/);
});

test('pins of a locked island cannot be dragged', async (t) => {
  const { page, before, corners } = await openWithPins(t, 2);
  await page.click('#details-toggle');
  for (const lock of await page.locator('#charts .lock').all()) await lock.click();
  await drag(page, corners[0].at, [30, 10]);
  await page.mouse.up();
  assert.match(
    await textOf(page, '#run-text'),
    /^This island is locked\. Unlock it to drag its pins/,
  );
  assert.deepEqual((await atlas(page)).uv, before.uv);
});

test('a finger drags a pin', async (t) => {
  const { page, before, corners } = await openWithPins(t, 1, { hasTouch: true });
  const [x, y, side] = await pixelOf(page, corners[0].at);
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...touchPoints) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', { x, y });
  for (const step of [8, 16, 24]) await touch('touchMove', { x: x + step, y });
  await touch('touchEnd');
  await page.waitForFunction(() =>
    /checked in/.test(document.querySelector('#run-text').textContent),
  );
  await settled(page);
  compare(before, await atlas(page), corners[0], (a, b) =>
    assertNear(minus(b, a), [24 / side, 0], 2e-3),
  );
  await exportMesh(page);
});

test('pins stay on their vertices when the atlas has other tiles', async (t) => {
  const rings = objText(together([0, 4, 8].map((x) => [torus(16, 8), [x, 0, 0]])));
  const page = await openPage(t, { open: ['rings.obj', rings] });
  await page.click('#more-toggle');
  await page.selectOption('#resolution', '4096');
  await settled(page);
  const density = 0.6 * Number((await metrics(page))['Texels per unit'].replace(',', ''));
  await page.fill('#more-texel-density', density.toFixed(0));
  await settled(page);
  await page.click('#more-udim');
  await settled(page);
  assert.doesNotMatch(await textOf(page, '#layout-info'), /tiles/);
  const { uv } = await atlas(page);
  await page.click('#pin');
  await pin(page, uv[0][0]);
  assert.match(await textOf(page, '#pins-text'), /^1 pin/);
  await page.selectOption('#resolution', '2048');
  await settled(page);
  assert.match(await textOf(page, '#layout-info'), /tiles/);
  await page.mouse.move(0, 0);
  await drawn(page);
  // Without what lies on it, whose round corners are not the same to the last bit.
  await page.evaluate(() => {
    document.querySelector('#pins').style.visibility = 'hidden';
  });
  const picture = () => page.locator('#layout-canvas').screenshot();
  const shown = await picture();
  // Drawn anew they are in the same places.
  for (let i = 0; i < 2; i++) await page.evaluate(() => document.querySelector('#pin').click());
  await drawn(page);
  assert.deepEqual(await picture(), shown);
});

test('pinning is for atlases', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  assert.ok(await page.isHidden('#pin'));
});
