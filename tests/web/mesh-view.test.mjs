// The mesh in 3D: how it first appears, and that the first view can be restored.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CUBE } from '../support/small-meshes.mjs';
import { drawn, dropAndWait, openPage, openSample, sampleNames, settled } from './page.mjs';

const CANVAS = '#mesh-canvas';

/** Box of what is drawn, in fractions of the canvas: `{ left, right, top, bottom }`, top is 0. */
async function drawnBox(page) {
  const picture = (await page.locator(CANVAS).screenshot()).toString('base64');
  return page.evaluate(async (picture) => {
    const bytes = Uint8Array.from(atob(picture), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    const { width, height } = image;
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const box = { left: 1, right: 0, top: 1, bottom: 0 };
    // The pane's rounded corners are not background.
    const background = data.slice(4 * (20 * width + 20), 4 * (20 * width + 20) + 3);
    for (let y = 8; y < height - 8; y++)
      for (let x = 8; x < width - 8; x++) {
        const at = 4 * (y * width + x);
        if (background.every((value, i) => Math.abs(value - data[at + i]) < 12)) continue;
        box.left = Math.min(box.left, x / width);
        box.right = Math.max(box.right, (x + 1) / width);
        box.top = Math.min(box.top, y / height);
        box.bottom = Math.max(box.bottom, (y + 1) / height);
      }
    return box;
  }, picture);
}

function assertFits({ left, right, top, bottom }, what) {
  assert.ok(Math.min(left, top) > 0.03 && Math.max(right, bottom) < 0.97, `${what} is not cut off`);
  assert.ok(Math.max(right - left, bottom - top) > 0.7, `${what} fills the pane`);
}

test('every sample fills its pane; the head stands upright', async (t) => {
  const page = await openPage(t);
  const names = await sampleNames(page);
  for (const name of names) {
    await openSample(page, name);
    const box = await drawnBox(page);
    assertFits(box, name);
    if (name !== 'head') continue;
    const { width, height } = await page.locator(CANVAS).boundingBox();
    const across = (box.right - box.left) * width;
    assert.ok(across < 0.8 * (box.bottom - box.top) * height, 'taller than wide');
  }
});

test('keys and a button look from front, right, top and the other side; Reset leads back', async (t) => {
  const page = await openPage(t, { settles: false });
  // 1 wide, 2 high, 6 deep.
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1} ${i & 2} ${1.5 * (i & 4)}`);
  const faces = CUBE.split('\n').filter((line) => line.startsWith('f'));
  await dropAndWait(page, 'box.obj', [...corners, ...faces].join('\n'));
  const shot = () => page.locator(CANVAS).screenshot();
  const first = await shot();
  const ratio = async () => {
    const drawn = await drawnBox(page);
    assertFits(drawn, 'the box');
    const { width, height } = await page.locator(CANVAS).boundingBox();
    return ((drawn.right - drawn.left) * width) / ((drawn.bottom - drawn.top) * height);
  };
  await page.focus(CANVAS);
  await page.keyboard.press('1');
  assert.ok((await ratio()) < 0.8, 'from the front it is higher than wide');
  const front = await drawnBox(page);
  await page.keyboard.press('3');
  assert.ok((await ratio()) > 1.8, 'from the right it is wide');
  await page.keyboard.press('7');
  assert.ok((await ratio()) < 0.6, 'from above it is long');
  await page.click('#reset');
  await page.mouse.move(0, 0);
  assert.deepEqual(await shot(), first);
  await page.click('#other-side');
  await page.mouse.move(0, 0);
  assert.notDeepEqual(await shot(), first);
  assertFits(await drawnBox(page), 'the other side');
  await page.focus(CANVAS);
  await page.keyboard.press('1');
  await page.keyboard.press('9');
  await page.keyboard.press('9');
  const again = await drawnBox(page);
  for (const side of Object.keys(front))
    assert.ok(
      Math.abs(again[side] - front[side]) < 0.03,
      `${side}: ${again[side]} in place of ${front[side]}`,
    );
});

/** Counts how often each canvas is cleared, which happens at the start of each picture. */
function prepareCounting() {
  globalThis.pictures = {};
  const { clear } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.clear = function (...what) {
    const { id } = this.canvas;
    globalThis.pictures[id] = (globalThis.pictures[id] ?? 0) + 1;
    return clear.apply(this, what);
  };
}

test('a picture is drawn once for each change, and not at all while nothing changes', async (t) => {
  const page = await openPage(t, {
    prepare: (page) => page.addInitScript(prepareCounting),
    reducedMotion: 'no-preference',
  });
  // Waits for several frames in a row in which nothing is drawn.
  const still = () =>
    page.evaluate(async () => {
      const sum = () => Object.values(globalThis.pictures).reduce((a, b) => a + b, 0);
      for (let quiet = 0, last = sum(); quiet < 10; ) {
        await new Promise((done) => requestAnimationFrame(done));
        quiet = sum() === last ? quiet + 1 : 0;
        last = sum();
      }
      return globalThis.pictures;
    });
  const opened = await still();
  // The empty views, the mesh, its charts and its seams.
  assert.ok(opened['mesh-canvas'] <= 4, `${opened['mesh-canvas']} pictures of the mesh`);
  assert.ok(opened['layout-canvas'] <= 2, `${opened['layout-canvas']} of the layout`);
  await page.click('#wireframe');
  const wired = await still();
  assert.equal(wired['mesh-canvas'], opened['mesh-canvas'] + 1);
  assert.equal(wired['layout-canvas'], opened['layout-canvas']);
  // Outside of the mesh there is nothing to aim at.
  await page.mouse.move(0, 0);
  const before = await still();
  const { x, y } = await page.locator(CANVAS).boundingBox();
  for (const off of [10, 14, 18]) {
    await page.mouse.move(x + off, y + off);
    assert.deepEqual(await still(), before);
  }
  // A drag glides to a stop, unless that is not wanted.
  const afterDrag = async () => {
    await page.mouse.move(x + 200, y + 200);
    await page.mouse.down();
    await page.mouse.move(x + 240, y + 210);
    await drawn(page);
    await page.mouse.up();
    const { 'mesh-canvas': released } = await page.evaluate(() => ({ ...globalThis.pictures }));
    return (await still())['mesh-canvas'] - released;
  };
  assert.ok((await afterDrag()) > 3);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.reload();
  await settled(page);
  await still();
  assert.ok((await afterDrag()) <= 1);
});

test('a mesh far from the origin, with a stray vertex, fills its pane', async (t) => {
  const page = await openPage(t, { settles: false });
  const corners = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const square = corners.map(([x, y]) => `v ${4e6 + x} ${5e6 + y} 0`);
  const text = `v 0 0 0\n${square.join('\n')}\nf 2 3 4 5\n`;
  await dropAndWait(page, 'far.obj', text);
  assertFits(await drawnBox(page), 'the square');
});

test('the mesh stays fitted in another size of the window, until it is turned', async (t) => {
  const page = await openPage(t);
  const fitted = await page.locator(CANVAS).screenshot();
  await page.setViewportSize({ width: 390, height: 844 });
  assertFits(await drawnBox(page), 'the mesh on a phone');
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.waitForFunction(() => document.querySelector('#mesh-canvas').clientWidth > 400);
  assert.deepEqual(await page.locator(CANVAS).screenshot(), fitted);

  const box = await page.locator(CANVAS).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 90, y + 20, { steps: 4 });
  await page.mouse.up();
  assert.notDeepEqual(await page.locator(CANVAS).screenshot(), fitted);
  await page.click('#reset');
  await page.mouse.move(0, 0);
  assert.deepEqual(await page.locator(CANVAS).screenshot(), fitted);
});
