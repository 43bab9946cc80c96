// An image of the user's own, on the mesh and under its layout.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { madePng } from '../support/made-png.mjs';
import { BLUE, fourColors, GREEN, oneColor, RED, YELLOW } from '../support/painted.mjs';
import { CUBE, grid } from '../support/small-meshes.mjs';
import { objText, sphere } from '../support/surfaces.mjs';
import { countTextures, loseContexts, prepareCounting } from './graphics.mjs';
import { pixelOf } from './layout.mjs';
import { loadModule } from './modules.mjs';
import {
  drawn,
  dropAndWait,
  dropFiles,
  metrics,
  openPage,
  pathOf,
  settled,
  textOf,
} from './page.mjs';

const { areImages } = await loadModule('opening/chosen-files');
const { toUnitSquare } = await loadModule('mesh/unit-square');

const MESH = '#mesh-canvas';
const LAYOUT = '#layout-canvas';
const COLORS = { red: RED, green: GREEN, blue: BLUE, yellow: YELLOW };
const BALL = ['ball.obj', objText(sphere(8))];

/** Waits until the image is shown. */
async function shows(page, name) {
  await page.waitForFunction((text) => {
    const { value, selectedOptions } = document.querySelector('#shading');
    return value === 'image' && selectedOptions[0].textContent === text;
  }, `Image: ${name}`);
  await drawn(page);
}

async function dropImage(page, name, content) {
  await dropFiles(page, { [name]: content });
  await shows(page, name);
}

const options = (page) => page.locator('#shading option').allTextContents();

const screenshot = async (page, canvas) => page.locator(canvas).screenshot();

/**
 * The pixels of a picture whose hue is that of one of COLORS, whatever the light: how many there
 * are, and the box around them in fractions of the picture.
 */
function seen(page, bytes) {
  return page.evaluate(
    async ({ text, colors }) => {
      const raw = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([raw]));
      const { width, height } = image;
      const pen = new OffscreenCanvas(width, height).getContext('2d');
      pen.drawImage(image, 0, 0);
      const { data } = pen.getImageData(0, 0, width, height);
      const unit = (color) => {
        const least = Math.min(...color);
        const rest = color.map((value) => value - least);
        const size = Math.hypot(...rest);
        return size < 60 ? null : rest.map((value) => value / size);
      };
      const wanted = Object.entries(colors).map(([name, color]) => [name, unit(color)]);
      const found = {};
      for (let i = 0; i < width * height; i++) {
        const hue = unit([...data.subarray(4 * i, 4 * i + 3)]);
        if (!hue) continue;
        for (const [name, other] of wanted) {
          if (hue.reduce((sum, value, d) => sum + value * other[d], 0) < 0.99) continue;
          found[name] ??= { count: 0, left: 1, right: 0, top: 1, bottom: 0 };
          const [x, y] = [(i % width) / width, Math.floor(i / width) / height];
          const box = found[name];
          box.count += 1;
          box.left = Math.min(box.left, x);
          box.right = Math.max(box.right, x);
          box.top = Math.min(box.top, y);
          box.bottom = Math.max(box.bottom, y);
        }
      }
      return found;
    },
    { text: bytes.toString('base64'), colors: COLORS },
  );
}

/** What is seen of COLORS, without the few pixels of blended edges. */
async function names(page, bytes) {
  const found = Object.entries(await seen(page, bytes));
  return found.filter(([, { count }]) => count > 50).map(([name]) => name);
}

const mostNames = ['blue', 'green', 'red', 'yellow'];

/** The colour at a point of the layout, in fractions of the unit square. */
async function colorAt(page, u, v) {
  const bytes = await screenshot(page, LAYOUT);
  const box = await page.locator(LAYOUT).boundingBox();
  const [x, y] = await pixelOf(page, [u, v]);
  return page.evaluate(
    async ({ text, across, down }) => {
      const raw = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([raw]));
      const { width, height } = image;
      const pen = new OffscreenCanvas(width, height).getContext('2d');
      pen.drawImage(image, 0, 0);
      const [x, y] = [Math.floor(across * width), Math.floor(down * height)];
      return [...pen.getImageData(x, y, 1, 1).data].slice(0, 3);
    },
    {
      text: bytes.toString('base64'),
      across: (x - box.x) / box.width,
      down: (y - box.y) / box.height,
    },
  );
}

function assertColor(found, wanted, tolerance, what) {
  const isNear = found.every((value, d) => Math.abs(value - wanted[d]) <= tolerance);
  assert.ok(isNear, `${what}: ${found} in place of ${wanted}`);
}

/** Charts tint it by less than `tint`. */
async function assertUpright(page, tint = 40) {
  const corners = { red: [0, 1], green: [1, 1], blue: [0, 0], yellow: [1, 0] };
  for (const [name, [u, v]] of Object.entries(corners)) {
    const inside = (x) => 0.5 + 0.97 * (x - 0.5);
    assertColor(await colorAt(page, inside(u), inside(v)), COLORS[name], tint, name);
  }
}

test('an image that is dropped is on the mesh and under the layout, v upwards', async (t) => {
  const page = await openPage(t, { open: BALL, deviceScaleFactor: 1 });
  const before = await metrics(page);
  assert.equal((await options(page)).at(-1), 'Image…');
  await dropImage(page, 'four.png', fourColors());
  assert.deepEqual((await options(page)).slice(-2), ['Image: four.png', 'Other image…']);
  assert.equal(await textOf(page, '#run-text'), 'Showing four.png');
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#source'), 'ball.obj');
  assert.deepEqual(await metrics(page), before);
  // No chart reaches into the corners; where there is one, it hardly tints the image.
  await assertUpright(page, 4);
  for (const [u, v, name] of [
    [0.25, 0.75, 'red'],
    [0.75, 0.25, 'yellow'],
  ])
    assertColor(await colorAt(page, u, v), COLORS[name], 40, name);
  const layout = await seen(page, await screenshot(page, LAYOUT));
  assert.ok(layout.red.right <= layout.green.left + 0.02, 'red is on the left');
  assert.ok(layout.red.bottom <= layout.blue.top + 0.02, 'red is above');
  // All of the atlas is on the mesh, part of it on the other side.
  const sides = await names(page, await screenshot(page, MESH));
  await page.click('#other-side');
  sides.push(...(await names(page, await screenshot(page, MESH))));
  assert.deepEqual([...new Set(sides)].sort(), mostNames);

  await page.focus(LAYOUT);
  await page.keyboard.press('z');
  assert.equal(await page.inputValue('#shading'), 'plain');
  await page.keyboard.press('z');
  assert.equal(await page.inputValue('#shading'), 'image');
  await assertUpright(page);
});

test('a disk lies where its texcoords are exported, all of the image in view', async (t) => {
  // Half as high as wide.
  const strip = grid(8).replaceAll(/^v (\S+) (\S+)/gm, (_, x, y) => `v ${x} ${y / 2}`);
  const page = await openPage(t, { mode: 'flatten', open: ['strip.obj', strip] });
  await dropImage(page, 'four.png', fourColors());
  await assertUpright(page);
  await page.click('#fit');
  await drawn(page);
  await assertUpright(page);
  assert.ok((await names(page, await screenshot(page, MESH))).length >= 2);
});

test('an image is chosen from the list, by pointer or keyboard, and can be replaced', async (t) => {
  const page = await openPage(t, { open: BALL });
  const picture = { name: 'red.png', mimeType: 'image/png', buffer: oneColor(RED) };
  // For the whole test: a key could reach the page before the browser knows that someone listens.
  const listen = () => undefined;
  page.on('filechooser', listen);
  t.after(() => page.off('filechooser', listen));
  const ask = async (act) => {
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), act()]);
    return chooser;
  };
  // Cancelled: nothing has changed.
  await page.selectOption('#shading', 'grid');
  await ask(() => page.selectOption('#shading', 'ask'));
  assert.equal(await page.inputValue('#shading'), 'grid');

  const chooser = await ask(() => page.selectOption('#shading', 'ask'));
  await chooser.setFiles(picture);
  await shows(page, 'red.png');
  assert.deepEqual(await names(page, await screenshot(page, MESH)), ['red']);

  // Arrow keys go through the list, Enter asks.
  await page.focus('#shading');
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.inputValue('#shading'), 'ask');
  assert.equal(await textOf(page, '#run-text'), 'Press Enter to choose an image');
  const other = await ask(() => page.keyboard.press('Enter'));
  assert.equal(await page.inputValue('#shading'), 'image');
  await other.setFiles({ ...picture, name: 'blue.png', buffer: oneColor(BLUE) });
  await shows(page, 'blue.png');
  assert.deepEqual(await names(page, await screenshot(page, MESH)), ['blue']);
  assert.equal(await page.locator('#shading option[value="image"]').count(), 1);

  // Who leaves the list has chosen nothing.
  await page.focus('#shading');
  await page.keyboard.press('ArrowDown');
  await page.focus(MESH);
  assert.equal(await page.inputValue('#shading'), 'image');

  // The dialog for meshes takes images, too.
  await page.setInputFiles('#file', { ...picture, name: 'again.png' });
  await shows(page, 'again.png');
  assert.deepEqual(await names(page, await screenshot(page, MESH)), ['red']);
});

test('of images that are dropped fast the last one stays, also while a mesh is opened', async (t) => {
  const page = await openPage(t, { open: BALL });
  await dropFiles(page, { 'large.png': oneColor(RED, 2000) });
  await dropFiles(page, { 'blue.png': oneColor(BLUE) });
  await dropFiles(page, { 'next.obj': CUBE });
  await dropFiles(page, { 'four.png': fourColors() });
  await shows(page, 'four.png');
  await page.waitForFunction(() => document.querySelector('#source').textContent === 'next.obj');
  await settled(page);
  await drawn(page);
  assert.equal(await textOf(page, '#alert'), '');
  await assertUpright(page);
  await shows(page, 'four.png');
});

test('the next image frees the last one', async (t) => {
  const page = await openPage(t, { prepare: prepareCounting, open: BALL });
  const before = await countTextures(page);
  for (const name of ['red.png', 'blue.png', 'green.png']) {
    await dropImage(page, name, oneColor(RED));
    await screenshot(page, MESH);
    assert.equal(await countTextures(page), before + 2, name);
  }
});

test('an image that is pasted is shown', async (t) => {
  const page = await openPage(t, { open: BALL });
  await page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    clipboardData.items.add(new File([bytes], 'image.png', { type: 'image/png' }));
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
  }, fourColors().toString('base64'));
  await shows(page, 'image.png');
  await assertUpright(page);
});

test('the next mesh keeps the image; an image that comes with a mesh belongs to that', async (t) => {
  const page = await openPage(t, { open: BALL });
  await dropImage(page, 'four.png', fourColors());
  await dropAndWait(page, 'cube.obj', CUBE);
  assert.equal(await page.inputValue('#shading'), 'image');
  await assertUpright(page);
  await page.selectOption('#shading', 'plain');
  await dropAndWait(page, 'ball.obj', BALL[1], { 'red.png': oneColor(RED) });
  assert.equal(await page.inputValue('#shading'), 'plain');
  assert.deepEqual((await options(page)).slice(-2), ['Image: four.png', 'Other image…']);
  await page.focus(MESH);
  await page.keyboard.press('z');
  await shows(page, 'four.png');
  await assertUpright(page);
});

test('an image that cannot be shown is named, and the last one stays', async (t) => {
  const page = await openPage(t, { open: BALL });
  await dropImage(page, 'red.png', oneColor(RED));
  for (const [name, sentence] of [
    ['torn.png', 'torn.png is damaged or too large to show. Save it again as PNG, JPEG or WebP.'],
    ['wall.tga', 'This browser cannot decode wall.tga. Save it as PNG, JPEG or WebP.'],
  ]) {
    await dropFiles(page, { [name]: 'no picture' });
    await page.waitForFunction(
      (name) => document.querySelector('#alert').textContent.includes(name),
      name,
    );
    await settled(page);
    assert.equal(await textOf(page, '#alert .alert-text p:first-child'), sentence);
    assert.equal(await textOf(page, '.alert-detail'), 'Still showing ball.obj.');
    await shows(page, 'red.png');
  }
  await dropImage(page, 'blue.png', oneColor(BLUE));
  assert.equal(await textOf(page, '#alert'), '');
});

test('an image that is too large is scaled down; of several, one is shown', async (t) => {
  const page = await openPage(t, { open: BALL });
  const most = await page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    return gl.getParameter(gl.MAX_TEXTURE_SIZE);
  });
  const wide = madePng(2 * most, 4, (x) => (x < most ? RED : BLUE));
  await dropFiles(page, { 'wide.png': wide, 'other.png': oneColor(GREEN) });
  await shows(page, 'wide.png');
  const number = (n) => n.toLocaleString('en-US');
  assert.equal(
    await textOf(page, '#notice p'),
    `You chose 2 images. wide.png is shown. wide.png is ${number(2 * most)} × 4 pixels, more than your graphics card supports. It is shown at ${number(most)} × 2.`,
  );
  assertColor(await colorAt(page, 0.02, 0.98), RED, 4, 'left');
  assertColor(await colorAt(page, 0.98, 0.98), BLUE, 4, 'right');
});

test('each tile has the image', async (t) => {
  const page = await openPage(t, { open: BALL });
  await dropImage(page, 'four.png', fourColors());
  const one = await seen(page, await screenshot(page, LAYOUT));
  await page.click('#more-toggle');
  const density = Number((await metrics(page))['Texels per unit']);
  await page.fill('#more-texel-density', `${Math.round(1.4 * density)}`);
  await page.click('#more-udim');
  await settled(page);
  await drawn(page);
  assert.deepEqual(await page.locator('#tiles .tile').allTextContents(), ['1001', '1002']);
  const two = await seen(page, await screenshot(page, LAYOUT));
  const width = ({ left, right }) => right - left;
  assert.ok(width(one.red) < 0.5);
  assert.ok(two.red.left < 0.3 && two.red.right > 0.5, 'red is in both tiles');
  assert.ok(two.green.right > 0.7, 'and so is green');
});

test('where the image is transparent, the mesh and what is behind the layout are seen', async (t) => {
  const page = await openPage(t, { open: BALL });
  const half = madePng(16, 16, (x) => [...RED, x < 8 ? 255 : 0]);
  await dropImage(page, 'half.png', half);
  assertColor(await colorAt(page, 0.02, 0.98), RED, 4, 'left');
  assertColor(await colorAt(page, 0.98, 0.98), [16, 21, 26], 4, 'right');
});

test('the picture of both views shows the image', async (t) => {
  const page = await openPage(t, { open: BALL });
  await dropImage(page, 'four.png', fourColors());
  await page.click('#export-formats');
  const item = page.getByRole('menuitem', { name: 'Picture of both views' });
  const [download] = await Promise.all([page.waitForEvent('download'), item.click()]);
  const found = await seen(page, readFileSync(await pathOf(download)));
  assert.deepEqual(Object.keys(found).sort(), mostNames);
  assert.ok(Object.values(found).some(({ left }) => left < 0.5) && found.green.right > 0.6);
});

test('the image comes back with a lost context', async (t) => {
  const page = await openPage(t, { own: true, open: BALL, expected: /WebGL|Context/ });
  await dropImage(page, 'four.png', fourColors());
  await loseContexts(page, [MESH, LAYOUT]);
  await drawn(page);
  await assertUpright(page);
  assert.notDeepEqual(await names(page, await screenshot(page, MESH)), []);
});

test('without WebGL there is nothing to show an image on, and the page says so', async (t) => {
  const page = await openPage(t, { webgl: false });
  await dropFiles(page, { 'four.png': fourColors() });
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(
    await textOf(page, '#alert .alert-text p:first-child'),
    /^WebGL 2 is off or missing in this browser/,
  );
});

test('files are images only if all of them are', () => {
  const files = (...names) => names.map((name) => new File([], name));
  assert.ok(areImages(files('a.png', 'B.JPG', 'c.tga')));
  assert.ok(areImages([new File([], 'photo', { type: 'image/avif' })]));
  for (const names of [['a.obj', 'a.png'], ['a.mtl', 'a.png'], ['a.txt'], ['a']])
    assert.ok(!areImages(files(...names)), names.join());
});

test('a layout is scaled into the unit square in its proportions', () => {
  const uv = Float64Array.from([10, -5, 30, -5, 30, 5, 99, 99]);
  const square = toUnitSquare(uv, Uint32Array.from([0, 1, 2]));
  assert.deepEqual([...square].slice(0, 6), [0, 0, 1, 0, 1, 0.5]);
});
