// Charts are selected by areas and by what they are, made level by an edge, and given another shape.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { chartsOf, parseObj } from '../support/atlas.mjs';
import { objText, together, torus } from '../support/surfaces.mjs';
import { arrangeAll, atlas, middleOf, pixelOf } from './layout.mjs';
import { drawn, exportMesh, metrics, openPage, reload, settled, textOf } from './page.mjs';

/** Two rings and a small one. */
const RINGS = objText(
  together([
    [torus(16, 8), [0, 0, 0]],
    [torus(16, 8), [3, 0, 0]],
    [torus(12, 6), [6, 0, 0]],
  ]),
);
const said = (page) => textOf(page, '#run-text');
const selection = (page) => textOf(page, '#selection-text');

async function opened(t, name, text, options) {
  const page = await openPage(t, { open: [name, text], ...options });
  await page.locator('#select-charts').waitFor();
  return page;
}

async function choose(page, menu, value) {
  await page.click(`#${menu === 'select' ? 'select-charts' : 'selection-arrange'}`);
  await page.click(`#${menu}-menu ${value}`);
}

async function drag(page, from, to, ...keys) {
  for (const key of keys) await page.keyboard.down(key);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 4 });
  await page.mouse.up();
  for (const key of keys) await page.keyboard.up(key);
}

/** The face in the chart of a face that is farthest from all others. */
function innerFace({ uv, ofFace }, face) {
  const middles = uv.map(middleOf);
  const away = (f) =>
    middles.reduce((least, [u, v], g) => {
      if (ofFace[g] === ofFace[face]) return least;
      return Math.min(least, Math.hypot(u - middles[f][0], v - middles[f][1]));
    }, Number.POSITIVE_INFINITY);
  const own = [...uv.keys()].filter((f) => ofFace[f] === ofFace[face]);
  return own.reduce((best, f) => (away(f) > away(best) ? f : best));
}

test('boxes and lassos select the charts that they touch; keys, menus and Esc', async (t) => {
  const page = await opened(t, 'rings.obj', RINGS);
  const now = await atlas(page);
  const count = Math.max(...now.ofFace) + 1;
  const { x, y, width, height } = await page.locator('#layout-canvas').boundingBox();
  const [corner, opposite] = [
    [x + 3, y + 3],
    [x + width - 3, y + height - 3],
  ];
  await page.mouse.move(...corner);
  await page.mouse.down();
  await page.mouse.move(...opposite, { steps: 4 });
  assert.match(await page.getAttribute('.area polygon', 'points'), /^3,3 /, 'the box is seen');
  await page.mouse.up();
  assert.equal(await page.getAttribute('.area polygon', 'points'), '');
  assert.match(await selection(page), new RegExp(`^${count} islands: `));
  assert.equal(await said(page), `Selected ${count} islands`);
  await page.keyboard.press('Escape');
  assert.ok(await page.isHidden('#selection'));
  assert.deepEqual((await atlas(page)).uv, now.uv, 'nothing was moved');

  // From within a chart that is not selected, a drag pans, unless the next one is to draw.
  await page.keyboard.press('b');
  assert.equal(await said(page), 'Drag a box around islands; Esc cancels');
  await page.keyboard.press('Escape');
  const face = middleOf(now.uv[innerFace(now, 0)]);
  const [u, v] = await pixelOf(page, face);
  await page.keyboard.press('b');
  await drag(page, [u, v], [u + 8, v + 1]);
  assert.match(await selection(page), /^Island \d+: /);
  const first = await selection(page);
  assert.deepEqual((await pixelOf(page, face)).slice(0, 2), [u, v]);
  // The same with Shift adds, and with Ctrl draws a lasso.
  const other = now.ofFace.findIndex((chart) => chart !== now.ofFace[0]);
  const [left, bottom] = await pixelOf(page, middleOf(now.uv[innerFace(now, other)]));
  await drag(page, [left, bottom], [left + 8, bottom + 1], 'Shift');
  assert.match(await selection(page), /^2 islands: /);
  await drag(page, [left, bottom], [left + 8, bottom + 1], 'Shift', 'Control');
  assert.match(await selection(page), /^2 islands: /);
  await page.keyboard.press('Alt+a');
  await drag(page, [u, v], [u + 8, v + 1], 'Control');
  assert.equal(await selection(page), first);
  await page.keyboard.press('i');
  assert.match(await selection(page), count > 2 ? new RegExp(`^${count - 1} islands`) : /^Island/);
  // A press that does not move is a click, and beside all charts deselects.
  await page.mouse.click(...corner);
  assert.ok(await page.isHidden('#selection'));
});

test('a drag with another button moves the view, and so does one over a chart', async (t) => {
  const page = await opened(t, 'rings.obj', RINGS);
  const { x, y } = await page.locator('#layout-canvas').boundingBox();
  const picture = () => page.locator('#layout-canvas').screenshot();
  const before = await picture();
  await page.mouse.move(x + 4, y + 4);
  await page.mouse.down({ button: 'middle' });
  await page.mouse.move(x + 60, y + 40, { steps: 3 });
  await page.mouse.up({ button: 'middle' });
  await page.mouse.move(0, 0);
  await drawn(page);
  const moved = await picture();
  assert.ok(!before.equals(moved));
  await page.click('#fit');
  const now = await atlas(page);
  const [u, v] = await pixelOf(page, middleOf(now.uv[innerFace(now, 0)]));
  await drag(page, [u, v], [u + 50, v + 30]);
  await page.mouse.move(0, 0);
  await drawn(page);
  assert.ok(!before.equals(await picture()));
  assert.ok(await page.isHidden('#selection'));
});

test('charts are selected by material, object, shape, stretch and mirroring', async (t) => {
  // Two alike in one object and material, a third in others.
  const lines = RINGS.trim().split('\n');
  const faces = lines.flatMap((line, i) => (line.startsWith('f') ? i : []));
  lines.splice(faces[faces.length - 144], 0, 'o small', 'usemtl blue');
  lines.splice(faces[0], 0, 'o large', 'usemtl red');
  const page = await opened(t, 'rings.obj', `${lines.join('\n')}\n`);
  const now = await atlas(page);
  const charts = (from, to) => new Set(now.ofFace.slice(from, to)).size;
  const total = Math.max(...now.ofFace) + 1;
  const [large, small] = [charts(0, -144), charts(-144)];
  assert.equal(large + small, total);
  const text = (n) => (n === 1 ? /^Island \d+: / : new RegExp(`^${n} islands: `));
  const pick = async (face) => {
    await page.keyboard.press('Alt+a');
    const [x, y] = await pixelOf(page, middleOf(now.uv.at(face)));
    await page.mouse.click(x, y);
    assert.match(await selection(page), /^Island \d+: /);
  };
  await choose(page, 'select', '[data-value="material"]');
  assert.equal(await said(page), 'Select an island first');
  for (const by of ['material', 'group']) {
    await pick(-1);
    await choose(page, 'select', `[data-value="${by}"]`);
    await settled(page);
    if (small > 1) assert.match(await selection(page), text(small), by);
    await pick(0);
    await choose(page, 'select', `[data-value="${by}"]`);
    await page.waitForFunction(
      (large) =>
        document.querySelector('#selection-text').textContent.startsWith(`${large} islands`),
      large,
    );
  }
  await pick(0);
  await choose(page, 'select', '[data-value="shape"]');
  await page.waitForFunction(() =>
    /^\d+ islands: /.test(document.querySelector('#selection-text').textContent),
  );
  await choose(page, 'select', '[data-value="all"]');
  assert.match(await selection(page), text(total));
  await choose(page, 'select', '[data-value="invert"]');
  assert.ok(await page.isHidden('#selection'));
  await choose(page, 'select', '[data-value="flipped"]');
  assert.equal(await said(page), 'No face is mirrored');
  await choose(page, 'select', '[data-value="overlapping"]');
  assert.equal(await said(page), 'No islands overlap');
  await choose(page, 'select', '[data-value="1.2"]');
  assert.match(await said(page), /^(No island is stretched beyond 1.2; the most is 1|Selected)/);
  // By keyboard.
  await page.focus('#select-charts');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('End');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.value), '1.2');
  await page.keyboard.press('Escape');
  assert.ok(await page.isHidden('#select-menu'));
  await arrangeAll(page, 's', '0.5');
  await settled(page);
  await arrangeAll(page, 's', '4');
  await settled(page);
});

/** Quads in columns and rows. */
function quads(columns, rows, place) {
  const across = Array.from({ length: columns + 1 }, (_, i) => i);
  const positions = Array.from({ length: rows + 1 }, (_, j) => across.map((i) => place(i, j)));
  const faces = Array.from({ length: columns * rows }, (_, k) => {
    const a = Math.floor(k / columns) * (columns + 1) + (k % columns);
    return [a, a + 1, a + columns + 2, a + columns + 1];
  });
  return objText({ positions: positions.flat(), faces });
}

/** A bowl. */
const BOWL = quads(10, 3, (i, j) => [i / 4, j / 4, ((i - 5) ** 2 + 4 * (j - 1.5) ** 2) / 40]);

test('an edge is made level, and a part of an outline; locked charts stay', async (t) => {
  const page = await opened(t, 'rings.obj', RINGS);
  for (const [key, number] of [
    ['s', '.6'],
    ['r', '20'],
  ]) {
    await arrangeAll(page, key, number);
    await settled(page);
  }
  const before = await atlas(page);
  const side = outlineSide(before, 0);
  const [a, b] = await Promise.all(side.map((point) => pixelOf(page, point)));
  const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  await page.keyboard.press('Alt+a');
  await page.keyboard.press('e');
  assert.match(await said(page), /^Click an edge, or drag/);
  await page.mouse.move(...middle);
  assert.match(await page.getAttribute('.marked-lines path', 'd'), /^M[-\d.]+ [-\d.]+L/);
  await page.mouse.down();
  await page.mouse.up();
  await settled(page);
  assert.match(await said(page), /^Aligned island \d+, checked/);
  const now = await atlas(page);
  const [from, to] = sameSide(before, now, side);
  assert.ok(Math.min(Math.abs(from[0] - to[0]), Math.abs(from[1] - to[1])) < 1e-6);
  now.uv.forEach((corners, f) => {
    if (before.ofFace[f] !== before.ofFace[0]) assert.deepEqual(corners, before.uv[f]);
  });
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual((await atlas(page)).uv, before.uv);
  await page.keyboard.press('e');
  await page.keyboard.press('Escape');
  assert.equal(await said(page), 'Nothing was aligned');

  // From one end to the other.
  await page.click('#fit');
  await page.focus('#layout-canvas');
  await page.keyboard.press('e');
  await drag(page, a, b);
  await settled(page);
  const [left, right] = sameSide(before, await atlas(page), side);
  assert.ok(Math.min(Math.abs(left[0] - right[0]), Math.abs(left[1] - right[1])) < 1e-6);
  await page.keyboard.press('Control+z');
  await settled(page);

  await page.mouse.click(
    ...(await pixelOf(page, middleOf(before.uv[innerFace(before, 0)]))).slice(0, 2),
  );
  await page.click('#details-toggle');
  await page.locator('.chart-table tr[aria-selected="true"] .lock').click();
  await page.click('#details-close');
  await drawn(page);
  await page.focus('#layout-canvas');
  await page.keyboard.press('e');
  await page.mouse.click(...middle);
  assert.equal(await said(page), 'Locked islands stay. Unlock them to move them');
  assert.deepEqual((await atlas(page)).uv, before.uv);
});

/** An edge on the outline of the chart of a face, in uv. */
function outlineSide({ uv, ofFace }, face) {
  const sides = new Map();
  uv.forEach((corners, f) => {
    if (ofFace[f] !== ofFace[face]) return;
    corners.forEach((from, i) => {
      const to = corners[(i + 1) % corners.length];
      const name = [String(from), String(to)].sort().join(' ');
      sides.set(name, [...(sides.get(name) ?? []), [from, to]]);
    });
  });
  const outer = [...sides.values()].filter(({ length }) => length === 1).map(([side]) => side);
  const length = ([[x0, y0], [x1, y1]]) => Math.hypot(x1 - x0, y1 - y0);
  return outer.reduce((longest, each) => (length(each) > length(longest) ? each : longest));
}

/** Where the ends of a side are in a later layout. */
function sameSide(before, now, side) {
  return side.map((point) => {
    for (const [f, corners] of before.uv.entries())
      for (const [i, corner] of corners.entries())
        if (String(corner) === String(point) && before.ofFace[f] === before.ofFace[0])
          return now.uv[f][i];
    return assert.fail('there is no such corner');
  });
}

test('charts become rectangles and are relaxed in their place, which is undone, kept and exported', async (t) => {
  const page = await opened(t, 'bowl.obj', BOWL);
  await page.click('#more-toggle');
  await page.selectOption('#more-rectify', 'never');
  await settled(page);
  await page.click('#more-toggle');
  const before = await atlas(page);
  await page.keyboard.press('a');
  await choose(page, 'arrange', 'button:text("Rectify")');
  await settled(page);
  assert.match(await said(page), /^Rectified island \d+, checked/);
  const { uv } = await atlas(page);
  const along = (d) => new Set(uv.flat().map((corner) => corner[d].toFixed(5))).size;
  assert.deepEqual(
    [along(0), along(1)].sort((a, b) => a - b),
    [4, 11],
    'rows and columns',
  );
  await choose(page, 'arrange', 'button:text("Relax")');
  await settled(page);
  assert.match(await said(page), /^Relaxed island \d+, checked/);
  for (let i = 0; i < 2; ++i) {
    await page.focus('#layout-canvas');
    await page.keyboard.press('Control+z');
    await settled(page);
  }
  assert.deepEqual((await atlas(page)).uv, before.uv);
  await page.keyboard.press('Control+Shift+z');
  await settled(page);
  assert.deepEqual((await atlas(page)).uv, uv);
  await reload(page);
  assert.deepEqual((await atlas(page)).uv, uv, 'the next visit has it, too');
});

test('Join removes a seam that is clicked in the layout; symmetric edits have both sides', async (t) => {
  const page = await opened(
    t,
    'sheet.obj',
    quads(6, 4, (i, j) => [i - 3, j - 2, 0]),
  );
  const cut = async (pairs) => {
    await page.setInputFiles('#seams-file', {
      name: 'cut.txt',
      mimeType: 'text/plain',
      buffer: Buffer.from(pairs.map((pair) => pair.join(' ')).join('\n')),
    });
    await page.waitForFunction(() => document.querySelector('#seams-state').textContent);
    await settled(page);
  };
  const charts = async () => Number((await metrics(page)).Islands);
  await page.click('#details-toggle');
  const { path } = await exportMesh(page);
  const { positions, faces } = parseObj(readFileSync(path, 'utf8'));
  const at = (x, y) => positions.findIndex((p) => p[0] === x && p[1] === y);
  const line = (x) => [-2, -1, 0, 1].map((y) => [at(x, y), at(x, y + 1)]);
  await cut([...line(-1), ...line(1)]);
  assert.equal(await charts(), 3);
  await page.click('#details-close');
  await page.click('#seam-join');
  const clickSeam = async ([a, b], lines) => {
    await page.click('#fit');
    const now = await atlas(page);
    const f = faces.findIndex((face) => [a, b].every((v) => face.some(([w]) => w === v)));
    const ends = [a, b].map((v) => now.uv[f][faces[f].findIndex(([w]) => w === v)]);
    const [x, y] = await pixelOf(page, middleOf(ends));
    await page.mouse.move(x, y);
    await drawn(page);
    assert.match(await textOf(page, '#seam-hint'), /^Seam of 4 edges/);
    assert.match(
      await page.getAttribute('.joined-lines path', 'd'),
      new RegExp(`^(M\\S+ \\S+L\\S+ \\S+){${lines}}$`),
    );
    await page.mouse.down();
    await page.mouse.up();
    await settled(page);
  };
  await clickSeam(line(-1)[1], 8);
  assert.equal(await charts(), 2);
  assert.ok(await page.isHidden('#selection'), 'the click selects nothing');
  await page.focus('#layout-canvas');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await charts(), 3);
  await page.click('#seam-symmetric');
  await clickSeam(line(-1)[1], 16);
  assert.equal(await charts(), 1, 'the other seam is its mirror image');
  assert.equal(chartsOf(parseObj(readFileSync((await exportMesh(page)).path, 'utf8'))).count, 1);
});

test('a finger draws a box once it is announced', async (t) => {
  const viewport = { width: 390, height: 844 };
  const page = await opened(t, 'rings.obj', RINGS, { viewport, hasTouch: true, isMobile: true });
  const button = await page.locator('#select-charts').boundingBox();
  assert.ok(button.height >= 40 && button.x + button.width <= viewport.width);
  await page.locator('#select-charts').tap();
  const menu = await page.locator('#select-menu').boundingBox();
  assert.ok(menu.y >= 0 && menu.y + menu.height <= viewport.height);
  assert.ok(menu.x >= 0 && menu.x + menu.width <= viewport.width, 'the menu is on the screen');
  await page.locator('#select-menu [data-value="box"]').tap();
  assert.equal(await said(page), 'Drag a box around islands; a second finger cancels');
  let { x, y, width, height } = await page.locator('#layout-canvas').boundingBox();
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })),
    });
  await touch('touchStart', [x + 4, y + 4]);
  for (const share of [0.3, 0.6, 0.98])
    await touch('touchMove', [x + share * width, y + share * height]);
  await touch('touchEnd');
  assert.match(await selection(page), /^\d+ islands: /);
  // By mouse: a tap that follows a swift drag only stops it.
  await page.click('#selection-none');
  assert.ok(await page.isHidden('#selection'));
  ({ x, y, width, height } = await page.locator('#layout-canvas').boundingBox());
  await touch('touchStart', [x + 4, y + 4]);
  for (const by of [10, 20]) await touch('touchMove', [x + by, y + by]);
  await touch('touchEnd');
  assert.ok(await page.isHidden('#selection'), 'the next drag moves the view');
});
