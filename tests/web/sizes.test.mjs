// The page in windows of many sizes: the views have priority, and everything else stays within
// reach.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { addMesh, emptyDocument, io, primitiveOf, randomRows } from '../support/gltf.mjs';
import { CUBE_OF_PARTS, grid } from '../support/small-meshes.mjs';
import { sphere } from '../support/surfaces.mjs';
import { choose, dropAndWait, openPage, settled } from './page.mjs';

/** As a fraction of the window's height. */
const SHARE = 0.6;

const VIEWS = ['#mesh-canvas', '#layout-canvas'];

/** The canvases get their size in the frame after that of their pane. */
async function resize(page, width, height) {
  await page.setViewportSize({ width, height });
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
}

async function assertRoom(page, { width, height }, what) {
  await resize(page, width, height);
  for (const id of VIEWS) {
    const box = await page.locator(id).boundingBox();
    assert.ok(box.height >= SHARE * height, `${id}, ${what}: ${box.height} of ${height}`);
    assert.ok(box.x >= 0 && box.x + box.width <= width, `${id}, ${what}`);
  }
  const overflow = await page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.documentElement;
    return [scrollWidth - innerWidth, scrollHeight - innerHeight];
  });
  assert.ok(Math.max(...overflow) <= 0, `${what}: the page itself does not scroll`);
}

const WINDOWS = [
  { width: 1280, height: 720 },
  { width: 900, height: 700 },
  { width: 1920, height: 1080 },
];

test('the views have most of the window, and each control of the dock can be reached', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(12)] });
  for (const size of WINDOWS) await assertRoom(page, size, `flatten, ${size.width}`);
  await page.click('#mode-unwrap');
  await settled(page);
  await page.click('#more-toggle');
  for (const size of WINDOWS) {
    await assertRoom(page, size, `unwrap, ${size.width}`);
    const dock = await page.locator('.dock').boundingBox();
    const controls = page.locator('.dock :is(button, input, select):visible');
    for (const control of await controls.all()) {
      // The panel of further options lies over the view of the mesh.
      if (await control.evaluate((element) => element.closest('#more') !== null)) continue;
      await control.scrollIntoViewIfNeeded();
      const box = await control.boundingBox();
      const name = await control.getAttribute('id');
      assert.ok(
        box.y >= dock.y && box.y + box.height <= dock.y + dock.height + 1,
        `${name} is shown`,
      );
      assert.ok(box.x >= dock.x && box.x + box.width <= dock.x + dock.width, `${name} is shown`);
    }
    const more = await page.locator('#more').boundingBox();
    assert.ok(more.x >= 0 && more.x + more.width <= size.width, 'further options are shown');
  }
});

test('labels of numbers can be read in full, and the dock needs no scrolling, in low windows too', async (t) => {
  const page = await openPage(t);
  for (const mode of ['unwrap', 'flatten']) {
    await choose(page, mode);
    for (const [width, height] of [
      [1280, 720],
      [1280, 675],
      [1366, 768],
      [1920, 675],
    ]) {
      await resize(page, width, height);
      const cut = await page.evaluate(() =>
        [
          ...[...document.querySelectorAll('.metric dt')].filter(
            (label) => label.scrollWidth > label.clientWidth,
          ),
          ...[...document.querySelectorAll('.ask, .result, .run')].filter(
            (part) => part.scrollHeight > part.clientHeight,
          ),
        ].map((part) => (part.matches('dt') ? part.textContent : part.className)),
      );
      assert.deepEqual(cut, [], `${mode}, ${width} x ${height}`);
    }
  }
});

test('with every source of seams the dock needs no scrolling', async (t) => {
  const page = await openPage(t, { open: ['cube.obj', CUBE_OF_PARTS.replace(/^f/m, 's 1\nf')] });
  for (const id of ['#seams-hard', '#seams-uv', '#seams-material', '#seams-sharp', '#more-toggle'])
    assert.ok(await page.isVisible(id), id);
  assert.ok(await page.locator('.ask').evaluate((e) => e.scrollHeight <= e.clientHeight));
});

test('a flattened mesh leaves nothing to scroll to in the dock of a narrow low window', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  for (const balance of ['Home', 'End']) {
    await page.focus('#flatten-balance');
    await page.keyboard.press(balance);
    await settled(page);
    await resize(page, 900, 700);
    for (const part of await page.locator('.ask, .result, .run').all())
      assert.ok(await part.evaluate((e) => e.scrollHeight <= e.clientHeight), balance);
  }
});

test('labels and names never push anything out of its place', async (t) => {
  const page = await openPage(t, { viewport: { width: 1440, height: 900 } });
  const before = await page.locator('#layout-canvas').boundingBox();
  await dropAndWait(page, 'ball.glb', await ballWithUvs());
  assert.ok(await page.isVisible('#read-texcoord'));
  const { height: now } = await page.locator('#layout-canvas').boundingBox();
  assert.equal(now, before.height, 'a choice of UV sets takes nothing from the views');
  const name = `${'a-mesh-with-a-very-long-name-'.repeat(3)}.obj`;
  await dropAndWait(page, name, CUBE_OF_PARTS);
  // All sources, with the choice of what is read.
  for (const id of ['#seams-uv', '#seams-material', '#seams-sharp']) {
    await page.click(id);
    await settled(page);
  }
  for (const [width, height] of [
    [1280, 720],
    [900, 700],
    [700, 800],
    [390, 844],
    [320, 640],
  ]) {
    await resize(page, width, height);
    const spilt = await page.evaluate(() => {
      const parts = [...document.querySelectorAll('.sources > *, .bar > *, .bar-group > *')];
      return parts
        .filter((part) => part.checkVisibility())
        .filter((part) => {
          const own = part.getBoundingClientRect();
          const around = part.parentElement.closest('.ask, .bar').getBoundingClientRect();
          return own.left < around.left || own.right > around.right + 0.5;
        })
        .map((part) => part.id || part.className);
    });
    assert.deepEqual(spilt, [], `${width} x ${height}`);
    const sideways = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(sideways <= 0, `no scrolling sideways at ${width}`);
  }
  // A glTF adds a choice to the bar at the top; beside the details, views are narrow.
  await dropAndWait(page, 'ball.glb', await ballWithUvs());
  assert.ok(await page.isVisible('#texcoord'));
  await page.click('#details-toggle');
  for (const width of [1280, 1181, 1024, 820, 768, 701]) {
    await resize(page, width, 800);
    assert.deepEqual(await outsideOfBars(page), [], `with details, ${width}`);
  }
});

/** With two UV sets, of which one can be chosen. */
function ballWithUvs() {
  const document = emptyDocument();
  const ball = primitiveOf(document, sphere(4));
  const count = ball.getAttribute('POSITION').getCount();
  for (const set of [0, 1])
    ball.setAttribute(`TEXCOORD_${set}`, randomRows(document, 'VEC2', Float32Array, count));
  addMesh(document, 'ball', ball);
  return io.writeBinary(document);
}

/** What cannot be reached, because it is beyond the end of its bar. */
const outsideOfBars = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('.bar, .pane-head, .pane-tools, .verdict')]
      .filter((bar) => bar.checkVisibility())
      .flatMap((bar) => {
        const { left, right } = bar.getBoundingClientRect();
        return [...bar.querySelectorAll('button, select, input')].filter((control) => {
          const own = control.getBoundingClientRect();
          return control.checkVisibility() && (own.left < left || own.right > right + 0.5);
        });
      })
      .map(({ id }) => id),
  );

/** What is cut off or can only be seen by scrolling. */
const cutOff = (page) =>
  page.evaluate(() =>
    [
      ...document.querySelectorAll(
        '.ask, .result, .run, .run-text, .reason, .bound-head label, .panel, #seam-hint',
      ),
    ]
      .filter((part) => part.checkVisibility())
      .filter(
        ({ scrollWidth, scrollHeight, clientWidth, clientHeight }) =>
          scrollWidth > clientWidth || scrollHeight > clientHeight,
      )
      .map((part) => part.id || part.className || part.textContent),
  );

test('a tablet, upright or not, shows all options and numbers at once, and larger views', async (t) => {
  const page = await openPage(t, { hasTouch: true, isMobile: true });
  for (const mode of ['unwrap', 'flatten']) {
    await choose(page, mode);
    for (const [width, height] of [
      [820, 1180],
      [768, 1024],
      [1180, 820],
    ]) {
      await resize(page, width, height);
      assert.deepEqual(await cutOff(page), [], `${mode}, ${width}`);
      const { height: own } = await page.locator('#layout-canvas').boundingBox();
      assert.ok(own >= 0.3 * height, `${mode}, ${width}: the view has ${own} of ${height}`);
    }
  }
});

test('beside the details nothing is cut off', async (t) => {
  const page = await openPage(t, { open: ['parts.obj', CUBE_OF_PARTS] });
  await page.click('#details-toggle');
  await resize(page, 1440, 900);
  const info = page.locator('#mesh-info');
  assert.match(await info.innerText(), /polygons, .* triangles$/);
  assert.ok(await info.evaluate((e) => e.scrollWidth <= e.clientWidth && e.clientHeight <= 30));
  await dropAndWait(page, 'ball.glb', await ballWithUvs());
  for (const [width, height] of [
    [1440, 900],
    [1024, 768],
  ]) {
    await resize(page, width, height);
    assert.deepEqual(await cutOff(page), [], String(width));
    const field = page.locator('#layout-scale');
    assert.ok(await field.evaluate((e) => e.scrollWidth <= e.clientWidth && e.clientWidth >= 44));
    for (const id of ['#source', '#layout-info'])
      assert.ok(await page.locator(id).evaluate((e) => e.scrollWidth <= e.clientWidth), id);
  }
});

test('on a phone both views of an atlas together have most of the screen', async (t) => {
  const page = await openPage(t);
  for (const [width, height] of [
    [390, 844],
    [675, 900],
  ]) {
    await resize(page, width, height);
    const boxes = await Promise.all(VIEWS.map((id) => page.locator(id).boundingBox()));
    const sum = boxes.reduce((all, box) => all + box.height, 0);
    assert.ok(sum >= SHARE * height - 2, `${width}: ${sum} of ${height}`);
  }
});

test('a page at 200 % shows everything, one thing above the other', async (t) => {
  const page = await openPage(t, { viewport: { width: 640, height: 360 }, deviceScaleFactor: 2 });
  await page.click('#mode-unwrap');
  await settled(page);
  for (const id of [...VIEWS, '#stretch', '#more-toggle', '#badge', '#cancel', '#layout-scale']) {
    await page.locator(id).scrollIntoViewIfNeeded();
    const box = await page.locator(id).boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 640, `${id} is inside`);
    assert.ok(box.height > 0);
  }
  for (const id of VIEWS)
    assert.ok((await page.locator(id).boundingBox()).height >= 120, `${id} has room`);
});
