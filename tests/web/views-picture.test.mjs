// The picture of both views, from the menu of formats.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { objText, sphere } from '../support/surfaces.mjs';
import { metrics, openPage, pathOf, settled, textOf } from './page.mjs';

const BALL = ['a ball.obj', objText(sphere(8))];

async function savePicture(page, press = 'click') {
  await page[press]('#export-formats');
  const item = page.getByRole('menuitem', { name: 'Picture of both views' });
  const [download] = await Promise.all([page.waitForEvent('download'), item[press]()]);
  assert.equal(await textOf(page, '#alert'), '');
  return { name: download.suggestedFilename(), bytes: readFileSync(await pathOf(download)) };
}

/** Size, and how much of each half and of the lower right corner has which colour, as hexadecimal numbers. */
function look(page, bytes) {
  return page.evaluate(async (text) => {
    const raw = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([raw]));
    const { width, height } = picture;
    const pen = new OffscreenCanvas(width, height).getContext('2d');
    pen.drawImage(picture, 0, 0);
    const countIn = (x, y, w, h) => {
      const { data } = pen.getImageData(x, y, w, h);
      const counts = {};
      for (let i = 0; i < data.length; i += 4) {
        const color = [...data.subarray(i, i + 3)].map((v) => v.toString(16).padStart(2, '0'));
        counts[`#${color.join('')}`] = (counts[`#${color.join('')}`] ?? 0) + 4 / data.length;
      }
      return counts;
    };
    const half = Math.floor(width / 2);
    return {
      width,
      height,
      left: countIn(0, 0, half, height),
      right: countIn(half + 2, 0, half - 2, height),
      corner: countIn(width - 200, height - 60, 180, 40),
    };
  }, bytes.toString('base64'));
}

const THEMES = {
  dark: { view: '#10151a', panel: '#14191f' },
  light: { view: '#fbfcfd', panel: '#ffffff' },
};

for (const [theme, { view, panel }] of Object.entries(THEMES))
  test(`both views are in the picture, with the legend if there is one, ${theme}`, async (t) => {
    const page = await openPage(t, { open: BALL, colorScheme: theme, deviceScaleFactor: 1 });
    const plain = await savePicture(page);
    assert.equal(plain.name, 'a ball-views.png');
    const sizes = await page.evaluate(() =>
      ['mesh', 'layout'].map((name) => {
        const { width, height } = document.querySelector(`#${name}-canvas`);
        return { width, height };
      }),
    );
    const seen = await look(page, plain.bytes);
    assert.equal(seen.width, sizes[0].width + 1 + sizes[1].width);
    assert.equal(seen.height, Math.max(...sizes.map(({ height }) => height)));
    assert.match(await textOf(page, '#run-text'), /^Saved a ball-views\.png, [\d,]+\s×\s\d+\spx$/);
    for (const half of [seen.left, seen.right]) {
      assert.ok(half[view] > 0.2 && half[view] < 0.9, `${half[view]} is background`);
      assert.ok(Object.keys(half).length > 3, 'something is drawn');
    }
    assert.ok(!(seen.corner[panel] > 0.3), 'no legend');
    await page.selectOption('#shading', 'area');
    const heat = await savePicture(page);
    assert.ok((await look(page, heat.bytes)).corner[panel] > 0.3, 'the legend');
    if (process.env.PICTURES)
      writeFileSync(`${process.env.PICTURES}/views-${theme}.png`, heat.bytes);
    if (process.env.PICTURES) {
      await page.click('#export-formats');
      await page.screenshot({ path: `${process.env.PICTURES}/menu-${theme}.png` });
    }
  });

test('a sharp phone gets a sharp picture, with the numbers of tiles', async (t) => {
  const page = await openPage(t, {
    open: BALL,
    viewport: { width: 390, height: 844 },
    deviceScaleFactor: 2,
    hasTouch: true,
  });
  await page.click('#more-toggle');
  const density = Number((await metrics(page))['Texels per unit']);
  await page.fill('#more-texel-density', `${Math.round(1.4 * density)}`);
  await page.click('#more-udim');
  await settled(page);
  assert.deepEqual(await page.locator('#tiles .tile').allTextContents(), ['1001', '1002']);
  const { bytes } = await savePicture(page, 'tap');
  const { width, right } = await look(page, bytes);
  const css = await page.evaluate(() => document.querySelector('#layout-canvas').clientWidth);
  assert.equal(width, 4 * css + 2);
  assert.ok(Object.keys(right).length > 3);
  if (process.env.PICTURES) writeFileSync(`${process.env.PICTURES}/views-phone.png`, bytes);
});

test('without WebGL there is nothing to save, and the page says so', async (t) => {
  const page = await openPage(t, { webgl: false });
  await page.click('#export-formats');
  await page.getByRole('menuitem', { name: 'Picture of both views' }).click();
  assert.equal(await textOf(page, '#run-text'), 'Nothing is drawn, so there is no picture');
});

test('choosing the picture leaves the format as it was', async (t) => {
  const page = await openPage(t, { open: BALL });
  await savePicture(page);
  assert.equal(await textOf(page, '#export'), 'Export OBJ');
});
