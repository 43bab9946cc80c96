// Seams are painted by dragging over the mesh, with Ctrl or with Paint pressed.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { objText, torus } from '../support/surfaces.mjs';
import { metrics, openPage, pathOf, settled, textOf } from './page.mjs';
import { CANVAS, charts, drawn, edited, flatGrid, hint, SMALL } from './seam-page.mjs';

const N = 6;
const GRID = ['grid.obj', flatGrid(N)];
async function openGrid(t, options) {
  const page = await openPage(t, { ...SMALL, ...options, open: GRID });
  await ready(page);
  return page;
}

/** What paints is loaded after the first layout. */
async function ready(page) {
  await page.waitForFunction(async () => {
    const canvas = document.querySelector('#mesh-canvas');
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const how = { pointerType: 'mouse', isPrimary: true, bubbles: true };
    const [clientX, clientY] = [left + 0.5 * width, top + 0.7 * height];
    canvas.dispatchEvent(new PointerEvent('pointermove', { ...how, clientX, clientY }));
    await new Promise((done) => requestAnimationFrame(done));
    return /^Vertex/.test(document.querySelector('#seam-hint').textContent);
  });
  await page.mouse.move(0, 0);
  await page.dispatchEvent(CANVAS, 'pointerleave');
}

const history = (page) => page.locator('#history').evaluate((list) => list.textContent);
const says = (page) => textOf(page, '#run-text');

/** Where a vertex of the grid is, in pixels of the page: the grid fills the canvas except for a margin. */
async function pixelOf(page, [x, y]) {
  const box = await page.locator(CANVAS).boundingBox();
  const side = 0.88 * Math.min(box.width, box.height);
  return [
    box.x + box.width / 2 + (x / N - 0.5) * side,
    box.y + box.height / 2 - (y / N - 0.5) * side,
  ];
}

const pixelsOf = (page, places) => Promise.all(places.map((place) => pixelOf(page, place)));

/** Presses at the first vertex and moves over the others. */
async function begin(page, ...places) {
  const [first, ...others] = await pixelsOf(page, places);
  await page.mouse.move(...first);
  await page.mouse.down();
  for (const pixel of others) await page.mouse.move(...pixel, { steps: 4 });
  await drawn(page);
}

async function paint(page, ...places) {
  await begin(page, ...places);
  await page.mouse.up();
  await drawn(page);
  await settled(page);
}

async function withKey(page, key, act) {
  await page.keyboard.down(key);
  await act();
  await page.keyboard.up(key);
}

const paintWithCtrl = (page, ...places) => withKey(page, 'Control', () => paint(page, ...places));

/** The seams as pairs of vertices of the grid, each as "x,y". */
async function seams(page) {
  await page.click('#details-toggle');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#seams-save')]);
  // The views are larger without it.
  await page.click('#details-toggle');
  const text = readFileSync(await pathOf(download), 'utf8');
  const name = (v) => `${v % (N + 1)},${Math.floor(v / (N + 1))}`;
  return text
    .split('\n')
    .filter((line) => /^\d+ \d+$/.test(line))
    .map((line) => line.split(' ').map((v) => name(Number(v))));
}

/** The vertices that are met by so many seams. */
function metBy(pairs, count) {
  const uses = new Map();
  for (const v of pairs.flat()) uses.set(v, (uses.get(v) ?? 0) + 1);
  return [...uses].filter(([, n]) => n === count).map(([v]) => v);
}

/** Runs something that must not turn the view; the picture is compared without the pointer. */
async function assertStill(page, act) {
  const vertex = async () => {
    await page.mouse.move(...(await pixelOf(page, [1, 4])));
    await drawn(page);
    return hint(page);
  };
  const before = await vertex();
  await act();
  assert.equal(await vertex(), before);
}

test('a stroke with Ctrl cuts along itself, in one step of the history', async (t) => {
  const page = await openGrid(t);
  await assertStill(page, async () => {
    await withKey(page, 'Control', async () => {
      await begin(page, [0, 2], [3, 2], [3, 6]);
      assert.equal(await hint(page), 'Painting 7 edges as seam, Esc cancels');
      assert.equal(await charts(page), 1, 'nothing is cut before the end');
      await page.mouse.up();
    });
    await settled(page);
  });
  assert.equal(await edited(page), 7);
  assert.equal(await charts(page), 2);
  assert.match(await history(page), /Painted 7 edges as seam/);
  const pairs = await seams(page);
  assert.equal(pairs.length, 7);
  assert.deepEqual(metBy(pairs, 1).sort(), ['0,2', '3,6'], 'one path');
  assert.ok(metBy(pairs, 2).includes('3,2'), 'around the corner');
  await page.click('#undo');
  await settled(page);
  assert.equal(await charts(page), 1);
  assert.ok(await page.isDisabled('#undo'));
  await page.click('#redo');
  await settled(page);
  assert.equal(await charts(page), 2);
});

test('one jump of the pointer is enough, and going back takes back', async (t) => {
  const page = await openGrid(t);
  await withKey(page, 'Control', async () => {
    const [from, to] = await pixelsOf(page, [
      [0, 3],
      [5, 3],
    ]);
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(...to);
    await drawn(page);
    assert.match(await hint(page), /^Painting 5 edges/);
    await page.mouse.move(...(await pixelOf(page, [2, 3])), { steps: 5 });
    await drawn(page);
    assert.match(await hint(page), /^Painting 2 edges/);
    await page.mouse.up();
  });
  await settled(page);
  assert.equal(await edited(page), 2);
});

test('a stroke goes on where it comes back to the mesh, and can close a loop', async (t) => {
  const page = await openGrid(t);
  await withKey(page, 'Control', async () => {
    await begin(page, [2, 2], [2, 4], [4, 4]);
    const box = await page.locator(CANVAS).boundingBox();
    await page.mouse.move(box.x + 4, box.y + 4);
    await page.mouse.move(...(await pixelOf(page, [4, 4])));
    for (const place of [
      [4, 2],
      [2, 2],
    ])
      await page.mouse.move(...(await pixelOf(page, place)), { steps: 6 });
    await page.mouse.up();
  });
  await settled(page);
  assert.equal(await charts(page), 2, 'cut out');
});

test('Escape cancels a stroke, and the rest of the drag does nothing', async (t) => {
  const page = await openGrid(t);
  await assertStill(page, () =>
    withKey(page, 'Control', async () => {
      await begin(page, [0, 2], [3, 2]);
      await page.keyboard.press('Escape');
      assert.equal(await says(page), 'Stroke cancelled');
      assert.doesNotMatch(await hint(page), /Painting/);
      await page.mouse.move(...(await pixelOf(page, [3, 5])), { steps: 4 });
      await page.mouse.up();
    }),
  );
  assert.equal(await edited(page), -1);
  assert.ok(await page.isDisabled('#undo'));
  await paintWithCtrl(page, [0, 2], [6, 2]);
  assert.equal(await charts(page), 2, 'the next one is painted');
});

test('with Join or Alt a stroke erases edge by edge', async (t) => {
  const page = await openGrid(t);
  for (const erase of [
    async () => {
      await page.click('#seam-join');
      await paintWithCtrl(page, [0, 3], [2, 3]);
      await page.click('#seam-cut');
    },
    () => withKey(page, 'Alt', () => paintWithCtrl(page, [0, 3], [2, 3])),
  ]) {
    await paintWithCtrl(page, [0, 3], [6, 3]);
    assert.equal(await edited(page), 6);
    await erase();
    assert.equal(await edited(page), 4);
    assert.match(await history(page), /Erased 2 seam edges/);
    assert.ok((await seams(page)).every(([a, b]) => a[0] >= 2 && b[0] >= 2));
    for (let i = 0; i < 2; ++i) {
      await page.click('#undo');
      await settled(page);
    }
  }
  await page.click('#seam-join');
  await paintWithCtrl(page, [1, 1], [1, 5]);
  assert.equal(await says(page), 'No seam under this stroke');
});

test('seams that islands need are not erased', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['torus.obj', objText(torus(24, 12))] });
  await ready(page);
  await page.click('#seam-join');
  const box = await page.locator(CANVAS).boundingBox();
  const erase = async () => {
    // To and fro over all of it.
    await withKey(page, 'Control', async () => {
      await page.mouse.move(box.x + box.width / 2, box.y + 0.75 * box.height);
      await page.mouse.down();
      for (let i = 0; i <= 30; ++i)
        await page.mouse.move(
          box.x + (i % 2 ? 0.05 : 0.95) * box.width,
          box.y + (0.05 + 0.03 * i) * box.height,
        );
      await drawn(page);
      await page.mouse.up();
    });
    await settled(page);
  };
  await erase();
  assert.match(await history(page), /Erased \d+ seam edges?/);
  assert.match(await textOf(page, '#badge'), /^(Valid|Stretched)$/, 'nothing overlaps');
  assert.ok(Number((await metrics(page))['Seam length']) > 0);
});

test('with Paint pressed a drag over the mesh paints, beside it it turns the view', async (t) => {
  const page = await openGrid(t);
  await page.click('#seam-paint');
  await drawn(page);
  assert.equal(await hint(page), 'Drag over the mesh to paint a seam');
  await paint(page, [0, 1], [6, 1]);
  assert.equal(await charts(page), 2);
  await page.click('#seam-join');
  await paint(page, [0, 1], [6, 1]);
  assert.equal(await charts(page), 1);
  // What selects does not paint.
  await page.click('#seam-select');
  assert.equal(await page.getAttribute('#seam-paint', 'aria-pressed'), 'false');
  await page.click('#seam-paint');
  assert.equal(await page.getAttribute('#seam-cut', 'aria-pressed'), 'true');

  const box = await page.locator(CANVAS).boundingBox();
  const before = await page.locator(CANVAS).screenshot();
  await page.mouse.move(box.x + 8, box.y + 8);
  await page.mouse.down();
  await page.mouse.move(box.x + 60, box.y + 40, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  assert.notDeepEqual(await page.locator(CANVAS).screenshot(), before);
});

test('a click is a click, with Ctrl and with Paint pressed', async (t) => {
  const page = await openGrid(t);
  const click = async (place) => {
    const [x, y] = await pixelOf(page, place);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 2, y + 2);
    await page.mouse.up();
    await drawn(page);
  };
  await withKey(page, 'Control', () => click([0, 3]));
  assert.match(await says(page), /^Cut started at vertex 21$/);
  await page.keyboard.press('Escape');
  await page.click('#seam-paint');
  await click([0, 3]);
  assert.match(await says(page), /^Cut started at vertex 21$/);
  // A stroke takes the place of the cut that was begun.
  await paint(page, [0, 1], [6, 1]);
  assert.equal(await edited(page), 6);
  assert.ok(await page.isHidden('#seam-cancel'));
});

test('C presses Paint', async (t) => {
  const page = await openGrid(t);
  await page.focus(CANVAS);
  for (const state of ['true', 'false']) {
    await page.keyboard.press('c');
    assert.equal(await page.getAttribute('#seam-paint', 'aria-pressed'), state);
  }
});

async function fingers(page) {
  const client = await page.context().newCDPSession(page);
  return (type, ...points) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
}

test('one finger paints with Paint pressed, two fingers move the view', async (t) => {
  const page = await openGrid(t, { hasTouch: true });
  const touch = await fingers(page);
  await page.locator('#seam-paint').tap();
  const [from, middle, to] = await pixelsOf(page, [
    [0, 4],
    [3, 4],
    [6, 4],
  ]);
  await touch('touchStart', from);
  for (const place of [middle, to]) await touch('touchMove', place);
  await touch('touchEnd');
  await page.waitForFunction(() =>
    /^seams edited/.test(document.querySelector('#seams-state').innerText),
  );
  await settled(page);
  assert.equal(await edited(page), 6);

  // A second finger takes a stroke back.
  await touch('touchStart', from);
  await touch('touchMove', middle);
  await touch('touchStart', middle, to);
  await touch('touchEnd');
  await settled(page);
  assert.equal(await edited(page), 6);

  const before = await page.locator(CANVAS).screenshot();
  const [x, y] = middle;
  await touch('touchStart', [x, y]);
  await touch('touchStart', [x, y], [x + 40, y]);
  await touch('touchMove', [x - 20, y], [x + 60, y]);
  await touch('touchMove', [x - 40, y], [x + 80, y]);
  await touch('touchEnd');
  await drawn(page);
  assert.equal(await edited(page), 6);
  assert.notDeepEqual(await page.locator(CANVAS).screenshot(), before, 'zoomed');
});
