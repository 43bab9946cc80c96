// Bounds of t are painted on the boundary of a disk, in either view, and taken back.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { CUBE } from '../support/small-meshes.mjs';
import { objText } from '../support/surfaces.mjs';
import {
  choose,
  dropAndWait,
  exportMesh,
  openPage,
  openSample,
  reload,
  settled,
  textOf,
} from './page.mjs';
import { drawn, SMALL } from './seam-page.mjs';

const N = 4;

/** Three quarters of a square in the plane of the screen: the corner inside has 270 degrees. */
function angle() {
  const positions = [];
  const faces = [];
  const at = (x, y) => positions.findIndex(([a, b]) => a === x && b === y);
  for (let y = 0; y <= 2 * N; ++y)
    for (let x = 0; x <= 2 * N; ++x) if (x <= N || y <= N) positions.push([x, y, 0]);
  for (let y = 0; y < 2 * N; ++y)
    for (let x = 0; x < 2 * N; ++x)
      if (x < N || y < N) faces.push([at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
  return { positions, faces };
}

const openAngle = async (t, options) => {
  const page = await openPage(t, {
    ...SMALL,
    ...options,
    mode: 'flatten',
    open: ['angle.obj', objText(angle())],
  });
  await page.click('#bound-paint');
  await ready(page);
  return page;
};

const hint = (page) => page.evaluate(() => document.querySelector('#bound-hint').textContent);
const history = (page) => page.locator('#history').evaluate((list) => list.textContent);
const info = (page) => textOf(page, '#layout-info');

/** Waits until the brush finds the boundary. */
async function ready(page) {
  await page.waitForFunction(async () => {
    const canvas = document.querySelector('#mesh-canvas');
    const { left, top, width, height } = canvas.getBoundingClientRect();
    for (let i = 0; i < 40; ++i) {
      const [clientX, clientY] = [left + width / 2, top + (height * i) / 40];
      const how = { clientX, clientY, pointerType: 'mouse', isPrimary: true, bubbles: true };
      canvas.dispatchEvent(new PointerEvent('pointermove', how));
      if (/vert/.test(document.querySelector('#bound-hint').textContent)) return true;
    }
    return false;
  });
}

/** Where the corner is: it is the vertex nearest to the middle, however the layout is turned. */
async function cornerIn(page, view) {
  const found = await page.waitForFunction((selector) => {
    const canvas = document.querySelector(selector);
    const { left, top, width, height } = canvas.getBoundingClientRect();
    for (let radius = 0; radius < width / 2; radius += 4)
      for (let turn = 0; turn < 32; ++turn) {
        const [x, y] = [Math.cos, Math.sin].map((f) => radius * f((turn * Math.PI) / 16));
        const [clientX, clientY] = [left + width / 2 + x, top + height / 2 + y];
        const how = { clientX, clientY, pointerType: 'mouse', isPrimary: true, bubbles: true };
        canvas.dispatchEvent(new PointerEvent('pointermove', how));
        if (/^1 vert/.test(document.querySelector('#bound-hint').textContent))
          return [clientX, clientY];
      }
    return null; // the views are still being drawn
  }, `#${view}-canvas`);
  return found.jsonValue();
}

/** Drags over the corner. */
async function stroke(page, view) {
  const [x, y] = await cornerIn(page, view);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 1, y + 1, { steps: 2 });
  await page.mouse.up();
  await drawn(page);
  await settled(page);
}

/** The largest interior angle at the boundary of the exported layout, in units of pi. */
async function largestAngle(page) {
  const text = readFileSync((await exportMesh(page)).path, 'utf8');
  const rows = (word) =>
    text
      .split('\n')
      .filter((line) => line.startsWith(`${word} `))
      .map((line) => line.slice(word.length + 1).split(' '));
  const uv = rows('vt').map((row) => row.map(Number));
  const faces = rows('f').map((row) => row.map((corner) => Number(corner.split('/')[1]) - 1));
  const uses = new Map();
  const sums = new Map();
  for (const face of faces)
    face.forEach((v, i) => {
      const [before, next] = [
        face[(i + face.length - 1) % face.length],
        face[(i + 1) % face.length],
      ];
      const [a, b] = [before, next].map((w) =>
        Math.atan2(uv[w][1] - uv[v][1], uv[w][0] - uv[v][0]),
      );
      const turn = (a - b + 4 * Math.PI) % (2 * Math.PI);
      sums.set(v, (sums.get(v) ?? 0) + turn / Math.PI);
      const key = [v, next].sort().join();
      uses.set(key, (uses.get(key) ?? 0) + 1);
    });
  const boundary = [...uses]
    .filter(([, n]) => n === 1)
    .flatMap(([key]) => key.split(',').map(Number));
  return Math.max(...boundary.map((v) => sums.get(v)));
}

for (const view of ['mesh', 'layout'])
  test(`a stroke in the ${view} view bounds the corner under it, and undo frees it`, async (t) => {
    const page = await openAngle(t);
    assert.ok((await largestAngle(page)) > 1.45);
    await stroke(page, view);
    assert.match(await textOf(page, '#run-text'), /^Flattened in .*; 1 own bound$/);
    assert.match(await textOf(page, '#marks'), /1 vertex has its own bound/);
    assert.doesNotMatch(await textOf(page, '#marks'), /tightened/);
    assert.match(await history(page), /Painted the bounds of 1 vertex/);
    assert.ok((await largestAngle(page)) < 1.2, 'the corner is straight');
    await page.click('#undo');
    await settled(page);
    assert.ok((await largestAngle(page)) > 1.45);
    assert.ok(await page.isHidden('#marks'));
    await page.click('#redo');
    await settled(page);
    assert.ok((await largestAngle(page)) < 1.2);
    assert.match(await textOf(page, '#marks'), /1 vertex has its own bound/);
  });

test('Alt and Erase take bounds away, Clear all of them', async (t) => {
  const page = await openAngle(t);
  await stroke(page, 'layout');
  await page.click('#bound-clear');
  await settled(page);
  assert.ok(await page.isHidden('#bound-clear'));
  assert.match(await history(page), /Cleared all painted bounds/);
  for (const erase of [
    async () => {
      await page.keyboard.down('Alt');
      await stroke(page, 'mesh');
      await page.keyboard.up('Alt');
    },
    async () => {
      await page.click('#bound-erase');
      await stroke(page, 'mesh');
      await page.click('#bound-erase');
    },
  ]) {
    await stroke(page, 'mesh');
    assert.match(await textOf(page, '#run-text'), /; 1 own bound$/);
    await erase();
    assert.doesNotMatch(await textOf(page, '#run-text'), /own bound/);
    assert.match(await history(page), /Erased the bounds of 1 vertex/);
  }
  await page.keyboard.down('Alt');
  await stroke(page, 'mesh');
  await page.keyboard.up('Alt');
  assert.equal(await textOf(page, '#run-text'), 'No bounds changed');
});

test('with the brush, a drag away from the boundary turns the view and paints nothing', async (t) => {
  const page = await openAngle(t);
  const box = await page.locator('#mesh-canvas').boundingBox();
  const [x, y] = [box.x + 20, box.y + 20];
  const before = await page.locator('#mesh-canvas').screenshot();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 80, y + 40, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  assert.notDeepEqual(await page.locator('#mesh-canvas').screenshot(), before);
  assert.doesNotMatch(await history(page), /bounds/);
});

test('a finger paints, and the value is that of the slider', async (t) => {
  const page = await openAngle(t, { hasTouch: true });
  await page.locator('#bound-t').fill('1.25');
  assert.equal(await textOf(page, '#bound-t-value'), '1.25, up to 225°');
  const [x, y] = await cornerIn(page, 'mesh');
  await page.touchscreen.tap(x, y);
  await drawn(page);
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /; 1 own bound$/);
  const most = await largestAngle(page);
  assert.ok(most > 1.2 && most < 1.3, `${most}`);
});

test('bounds that cannot be met are refused in a sentence, and undo leads back', async (t) => {
  const page = await openAngle(t);
  await page.locator('#bound-t').fill('0.9');
  const box = await page.locator('#mesh-canvas').boundingBox();
  await page.mouse.move(...(await cornerIn(page, 'mesh')));
  await page.mouse.down();
  for (let i = 0; i <= 20; ++i)
    for (const j of i % 2 ? [0, 1] : [1, 0])
      await page.mouse.move(box.x + (box.width * i) / 20, box.y + box.height * j);
  await page.mouse.up();
  await drawn(page);
  await settled(page);
  assert.match(await textOf(page, '#alert'), /the bounds cannot be met/);
  await page.click('#undo');
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
});

test('bounds come back after a reload, and another mesh has none', async (t) => {
  const page = await openAngle(t, { own: true });
  await stroke(page, 'mesh');
  const before = await largestAngle(page);
  await reload(page);
  assert.match(await textOf(page, '#marks'), /1 vertex has its own bound/);
  assert.equal(await largestAngle(page), before);
  await openSample(page, 'hemisphere');
  assert.ok(await page.isHidden('#marks'));
  await dropAndWait(page, 'cube.obj', CUBE);
  await choose(page, 'unwrap');
  assert.ok(await page.isHidden('#bound-tools'));
});

test('keys: B paints, Enter paints in the middle, Alt erases there', async (t) => {
  const page = await openAngle(t);
  await page.focus('#layout-canvas');
  await page.keyboard.press('b');
  assert.equal(await page.getAttribute('#bound-paint', 'aria-pressed'), 'false');
  assert.equal(await hint(page), '');
  await page.keyboard.press('b');
  await page.focus('#mesh-canvas');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.match(await info(page), /^t = auto/);
  assert.match(await textOf(page, '#run-text'), /; 1 own bound$/);
  await page.keyboard.press('Alt+Space');
  await settled(page);
  assert.doesNotMatch(await textOf(page, '#run-text'), /own bound/);
});
