// The grid below the charts of an atlas: how many texels from line to line, down to single ones.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxArray, objText } from '../support/surfaces.mjs';
import { pixelOf } from './layout.mjs';
import { loadModule as load } from './modules.mjs';
import { choose, drawn, openPage, settled, textOf } from './page.mjs';

test('lines are a power of two of texels apart, as near as can be told apart', async () => {
  const { texelsBetween } = await load('mesh/texels');
  for (const resolution of [64, 256, 1024, 4096])
    for (let pixels = 10; pixels < 1e6; pixels *= 1.3) {
      const texels = texelsBetween(resolution, pixels);
      assert.ok(Number.isInteger(Math.log2(texels)) && texels <= resolution);
      const distance = (texels * pixels) / resolution;
      assert.ok(distance >= 24 || texels === resolution, `${distance} pixels`);
      assert.ok(distance < 48 || texels === 1, `${distance} pixels`);
    }
});

/** The brightness of the pixels in a row of the layout. */
async function row(page, x, y, length) {
  const clip = { x, y, width: length, height: 1 };
  const picture = (await page.screenshot({ clip })).toString('base64');
  return page.evaluate(async (picture) => {
    const bytes = Uint8Array.from(atob(picture), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    const context = new OffscreenCanvas(image.width, 1).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, 1);
    return Array.from({ length: image.width }, (_, i) => data[4 * i] + data[4 * i + 1]);
  }, picture);
}

test('the grid gets finer when one zooms in, ends with single texels, and follows the resolution', async (t) => {
  const page = await openPage(t, { open: ['box.obj', objText(boxArray(1))] });
  const info = () => textOf(page, '#grid-info');
  const texels = async () => Number(/^grid (\d+) texels?$/.exec(await info())[1]);
  const first = await texels();
  await page.selectOption('#resolution', '2048');
  await settled(page);
  await drawn(page);
  assert.equal(await texels(), 2 * first, 'the same lines have twice as many texels between them');
  // Above the tile there are none.
  const [x, y] = await pixelOf(page, [0.002, 0.998]);
  await page.mouse.move(x, y);
  for (let i = 0; i < 60 && (await texels()) > 1; i++) {
    await page.mouse.wheel(0, -200);
    await drawn(page);
  }
  assert.equal(await info(), 'grid 1 texel');
  const box = await page.locator('#layout-canvas').boundingBox();
  const line = await row(page, box.x + box.width / 2, y + 60, 200);
  assert.ok(new Set(line).size > 1, 'lines are seen');
  await page.click('#fit');
  await drawn(page);
  assert.equal(await texels(), 2 * first);
  await page.selectOption('#shading', 'grid');
  await drawn(page);
  assert.equal(await info(), 'cells of 256 texels');
});

test('a layout in one piece has no texels', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  assert.equal(await textOf(page, '#grid-info'), '');
  await choose(page, 'unwrap');
  await settled(page);
  await drawn(page);
  assert.match(await textOf(page, '#grid-info'), /^grid \d+ texels$/);
});
