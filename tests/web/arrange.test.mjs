// Charts are moved, turned, scaled, straightened and stacked in the layout.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { boxArray, objText, together, torus } from '../support/surfaces.mjs';
import { arrangeAll, atlas, middleOf, pixelOf } from './layout.mjs';
import { drawn, openPage, pathOf, settled, textOf } from './page.mjs';

/** Two rings side by side. */
const RINGS = objText(
  together([
    [torus(16, 8), [0, 0, 0]],
    [torus(16, 8), [3, 0, 0]],
  ]),
);
const SIZE = 1024;

/** Selects the chart of a face by a click; returns where. */
async function select(page, { uv }, face = 0) {
  const [x, y, side] = await pixelOf(page, middleOf(uv[face]));
  await page.mouse.click(x, y);
  assert.match(await textOf(page, '#selection-text'), /^Island \d+: /);
  return { x, y, side };
}

/** How the corners of the faces of a chart have moved: each by the same, or not at all. */
function shiftOf(before, after, face) {
  const chart = before.ofFace[face];
  let shift = null;
  before.uv.forEach((corners, f) => {
    corners.forEach((corner, i) => {
      const by = [0, 1].map((d) => after.uv[f][i][d] - corner[d]);
      if (before.ofFace[f] !== chart) assert.deepEqual(by, [0, 0], `face ${f} stays`);
      else {
        shift ??= by;
        for (const d of [0, 1])
          assert.ok(Math.abs(by[d] - shift[d]) < 1e-6, `face ${f} goes along`);
      }
    });
  });
  return shift;
}

async function placed(page) {
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /checked in/);
  await drawn(page);
}

test('a selected island is dragged, what it does is checked, and it is undone', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS] });
  const before = await atlas(page);
  const { x, y, side } = await select(page, before);
  // The round corners of buttons are not always drawn alike to the last bit.
  const mask = [page.locator('#selection')];
  const picture = () => page.locator('#layout-canvas').screenshot({ mask });
  await page.mouse.move(0, 0);
  await drawn(page);
  const still = await picture();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y - 20, { steps: 4 });
  await drawn(page);
  assert.match(await textOf(page, '#selection-text'), /^Move u 0\.\d+, v 0\.\d+ \(/);
  await page.mouse.up();
  await placed(page);
  assert.match(await textOf(page, '#run-text'), /^Moved island \d+, checked in .*, not valid$/);
  assert.match(await textOf(page, '#badge'), /^Not valid$/);
  assert.match(await textOf(page, '#marks'), /^\d islands? (is|are) not valid$/);
  assert.match(await textOf(page, '#selection-text'), /^Island \d+: /, 'it stays selected');
  const after = await atlas(page);
  const shift = shiftOf(before, after, 0);
  assert.ok(Math.abs(shift[0] - 30 / side) < 2e-3 && Math.abs(shift[1] - 20 / side) < 2e-3);
  await page.focus('#layout-canvas');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.ok(await page.isHidden('#marks'));
  assert.deepEqual((await atlas(page)).uv, before.uv);
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.activeElement.blur());
  await drawn(page);
  assert.deepEqual(await picture(), still, 'the same colours in the same places');
});

test('G, R and S move, turn and scale by pointer, arrows and numbers; Escape puts all back', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS] });
  const before = await atlas(page);
  const { x, y, side } = await select(page, before);
  const press = (...keys) =>
    keys.reduce((all, key) => all.then(() => page.keyboard.press(key)), Promise.resolve());
  const gesture = () => textOf(page, '#selection-text');
  await page.mouse.move(x, y);
  await press('g');
  await page.mouse.move(x + 40, y, { steps: 3 });
  assert.match(await gesture(), /^Move u 0\.\d+, v 0 \(/);
  await press('Escape');
  assert.match(await gesture(), /^Island/, 'it is still selected');
  assert.deepEqual((await atlas(page)).uv, before.uv);

  await press('g', 'ArrowRight', 'Shift+ArrowUp', 'Enter');
  await placed(page);
  const nudged = await atlas(page);
  const shift = shiftOf(before, nudged, 0);
  for (const [d, texels] of [1, 10].entries())
    assert.ok(Math.abs(shift[d] - texels / SIZE) < 1e-6, `${shift[d] * SIZE} texels`);

  // A click ends it as well, and does not select anything else.
  await press('g', 'y');
  await page.mouse.move(x + 10, y + 33, { steps: 2 });
  await page.mouse.down();
  await page.mouse.up();
  await placed(page);
  const along = shiftOf(nudged, await atlas(page), 0);
  assert.ok(along[0] === 0 && Math.abs(along[1] + 33 / side) < 2e-3, String(along));
  assert.match(await gesture(), /^Island/);

  await press('r', '9', '0');
  assert.equal(await gesture(), 'Rotate 90°');
  await press('Enter');
  await placed(page);
  await press('s', '0', '.', '5', 'Enter');
  await placed(page);
  assert.match(await textOf(page, '#run-text'), /^Scaled island \d+, checked/);
  const sizeOf = ({ uv, ofFace }) => {
    const corners = uv.filter((_, f) => ofFace[f] === before.ofFace[0]).flat();
    return [0, 1].map(
      (d) => Math.max(...corners.map((c) => c[d])) - Math.min(...corners.map((c) => c[d])),
    );
  };
  const [[w, h], [w1, h1]] = [sizeOf(before), sizeOf(await atlas(page))];
  assert.ok(Math.abs(w1 - h / 2) < 1e-6 && Math.abs(h1 - w / 2) < 1e-6, 'turned and half as large');
  await page.click('#details-toggle');
  await page.click('#tab-history');
  assert.deepEqual(
    (await page.locator('#history .step').allInnerTexts()).map((text) => text.split(' ')[0]),
    ['Open', 'Moved', 'Moved', 'Rotated', 'Scaled'],
  );
});

test('a seam is cut elsewhere: islands stay where they were moved to', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS] });
  const before = await atlas(page);
  await select(page, before);
  await page.keyboard.press('g');
  await page.keyboard.type('.125');
  await page.keyboard.press('Enter');
  await placed(page);
  const moved = await atlas(page);
  shiftOf(before, moved, 0);
  // Edges of the other ring.
  await page.click('#details-toggle');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#seams-save')]);
  const seams = readFileSync(await pathOf(download), 'utf8').trim();
  await page.setInputFiles('#seams-file', {
    name: 'more.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from(`${seams}\n160 161\n`),
  });
  await page.waitForFunction(() => document.querySelector('#seams-state').textContent);
  await settled(page);
  const after = await atlas(page);
  after.uv.forEach((corners, f) => {
    if (before.ofFace[f] === before.ofFace[0]) assert.deepEqual(corners, moved.uv[f]);
  });
  // Another resolution packs all anew.
  await page.selectOption('#resolution', '512');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('locked islands cannot be moved; what else is selected can', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS] });
  const before = await atlas(page);
  const { x, y } = await select(page, before);
  await page.click('#details-toggle');
  await page.locator('.chart-table tr[aria-selected="true"] .lock').click();
  await page.focus('#layout-canvas');
  await page.keyboard.press('g');
  assert.equal(await textOf(page, '#run-text'), 'Locked islands stay. Unlock them to move them');
  await page.click('#details-close');
  await drawn(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y, { steps: 3 });
  await page.mouse.up();
  await drawn(page);
  assert.deepEqual((await atlas(page)).uv, before.uv, 'the drag has panned');
  await arrangeAll(page, 'g', '1');
  await placed(page);
  const after = await atlas(page);
  after.uv.forEach((corners, f) => {
    const by = corners[0][0] - before.uv[f][0][0];
    assert.ok(Math.abs(by - (before.ofFace[f] === before.ofFace[0] ? 0 : 1)) < 1e-6);
  });
  assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 1);
});

test('the menu stacks islands of the same shape, straightens and evens out', async (t) => {
  const page = await openPage(t, {
    open: ['boxes.obj', objText(boxArray(2))],
  });
  const before = await atlas(page);
  const count = Math.max(...before.ofFace) + 1;
  assert.ok(count >= 2);
  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  const arrange = async (value) => {
    await page.click('#selection-arrange');
    await page.click(`#arrange-menu [data-value="${value}"]`);
    await placed(page);
  };
  await arrange('stacked');
  assert.match(await textOf(page, '#run-text'), /^Stacked \d+ islands.*, checked in [^,]*$/);
  assert.match(await textOf(page, '#reason'), /^\d+ islands stacked, no other overlaps$/);
  const boxes = ({ uv, ofFace }) => {
    const found = new Map();
    uv.forEach((corners, f) => {
      const low = found.get(ofFace[f]) ?? [Infinity, Infinity];
      for (const corner of corners) for (const d of [0, 1]) low[d] = Math.min(low[d], corner[d]);
      found.set(ofFace[f], low);
    });
    return new Set([...found.values()].map((low) => low.map((x) => x.toFixed(4)).join(' ')));
  };
  const stacked = await atlas(page);
  assert.ok(boxes({ uv: stacked.uv, ofFace: before.ofFace }).size < count, 'islands share a place');
  await arrange('left');
  await arrange('straightened');
  await arrange('evened');
  assert.match(await textOf(page, '#run-text'), /^Evened out \d+ islands, checked/);
  // By keyboard: the menu opens, leads and closes.
  await page.focus('#selection-arrange');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('End');
  await page.keyboard.press('Escape');
  assert.ok(await page.isHidden('#arrange-menu'));
});

test('a finger drags a selected island, two zoom', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS], hasTouch: true });
  const before = await atlas(page);
  const [x, y, side] = await pixelOf(page, middleOf(before.uv[0]));
  await page.touchscreen.tap(x, y);
  assert.match(await textOf(page, '#selection-text'), /^Island \d+: /);
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })),
    });
  await touch('touchStart', [x, y]);
  await touch('touchStart', [x, y], [x + 60, y]);
  await touch('touchMove', [x - 20, y], [x + 80, y]);
  await touch('touchEnd');
  await drawn(page);
  assert.deepEqual((await atlas(page)).uv, before.uv);
  await page.click('#fit');
  await touch('touchStart', [x, y]);
  for (const by of [10, 20, 30]) await touch('touchMove', [x + by, y]);
  await touch('touchEnd');
  await placed(page);
  const shift = shiftOf(before, await atlas(page), 0);
  assert.ok(Math.abs(shift[0] - 30 / side) < 2e-3, String(shift));
});

test('moves follow each other without waiting for the checks', async (t) => {
  const page = await openPage(t, {
    open: [
      'rings.obj',
      objText(
        together([
          [torus(160, 80), [0, 0, 0]],
          [torus(16, 8), [3, 0, 0]],
        ]),
      ),
    ],
  });
  const before = await atlas(page);
  await select(page, before);
  for (const number of ['.25', '.5', '-.125']) {
    await page.keyboard.press('g');
    await page.keyboard.type(number);
    await page.keyboard.press('Enter');
    // As soon as the charts are where they were put.
    await page.waitForFunction(
      (count) => document.querySelectorAll('#history .step').length === count,
      2 + ['.25', '.5', '-.125'].indexOf(number),
    );
  }
  await placed(page);
  const after = await atlas(page);
  const [u, v] = shiftOf(before, after, 0);
  assert.ok(Math.abs(u - 0.625) < 1e-6 && Math.abs(v) < 1e-6, `${u}, ${v}`);
});
