// The view of the mesh is moved as in Blender.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText, sphere } from '../support/surfaces.mjs';
import { isPlain } from './layout.mjs';
import { drawn, dropAndWait, openPage } from './page.mjs';

const CANVAS = '#mesh-canvas';

const shot = (page) => page.locator(CANVAS).screenshot();

async function middleOf(page) {
  const { x, y, width, height } = await page.locator(CANVAS).boundingBox();
  return [x + width / 2, y + height / 2];
}

/** The picture after a drag from the middle of a reset view. */
async function afterDrag(page, { button = 'left', key } = {}) {
  await page.click('#reset');
  const [x, y] = await middleOf(page);
  await page.mouse.move(x, y);
  if (key) await page.keyboard.down(key);
  await page.mouse.down({ button });
  await page.mouse.move(x + 60, y + 20, { steps: 3 });
  await page.mouse.up({ button });
  if (key) await page.keyboard.up(key);
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.activeElement.blur());
  await drawn(page);
  return shot(page);
}

/** Two squares that face the eye, the right one six times as far behind it. */
const NEAR_AND_FAR = [
  [-3, 0],
  [1, -12],
]
  .map(([x, z], i) =>
    [
      ...[`v ${x} 0 ${z}`, `v ${x + 2} 0 ${z}`, `v ${x + 2} 2 ${z}`, `v ${x} 2 ${z}`],
      `f ${[1, 2, 3, 4].map((k) => 4 * i + k).join(' ')}`,
    ].join('\n'),
  )
  .join('\n');

/** At the left and at the right end of what is drawn, how many rows have something other than background. */
async function heights(page) {
  const picture = (await shot(page)).toString('base64');
  return page.evaluate(async (picture) => {
    const bytes = Uint8Array.from(atob(picture), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    const { width, height } = image;
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(image, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
    const background = pixels[20 * width + 20];
    const rowsAt = (x) => {
      let rows = 0;
      for (let y = 8; y < height - 8; ++y) rows += pixels[y * width + x] !== background;
      return rows;
    };
    const drawn = Array.from({ length: width - 16 }, (_, i) => i + 8).filter((x) => rowsAt(x) > 20);
    return [drawn[4], drawn.at(-5)].map(rowsAt);
  }, picture);
}

test('the middle button rotates and with Shift moves, and digits look from all sides', async (t) => {
  const page = await openPage(t);
  const turned = await afterDrag(page);
  assert.deepEqual(await afterDrag(page, { button: 'middle' }), turned);
  const moved = await afterDrag(page, { button: 'right' });
  assert.notDeepEqual(moved, turned);
  assert.deepEqual(await afterDrag(page, { button: 'middle', key: 'Shift' }), moved);

  await page.focus(CANVAS);
  const seen = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
    await drawn(page);
    return shot(page);
  };
  const [front, right, top] = [await seen('1'), await seen('3'), await seen('7')];
  const opposite = [await seen('Control+1'), await seen('Control+3'), await seen('Control+7')];
  assert.equal(new Set([front, right, top, ...opposite].map(String)).size, 6);
  assert.deepEqual(await seen('1', '9'), opposite[0]);
  assert.deepEqual(await seen('Numpad3'), right);
});

test('without perspective, what is far away is as large as what is near', async (t) => {
  const page = await openPage(t, { settles: false });
  await dropAndWait(page, 'two.obj', NEAR_AND_FAR);
  await page.focus(CANVAS);
  await page.keyboard.press('1');
  await drawn(page);
  const before = await shot(page);
  const [near, far] = await heights(page);
  assert.ok(far < 0.8 * near, `${far} beside ${near}`);
  await page.keyboard.press('5');
  await drawn(page);
  const [left, right] = await heights(page);
  assert.ok(Math.abs(right / left - 1) < 0.05, `${right} beside ${left}`);
  await page.keyboard.press('5');
  await drawn(page);
  assert.deepEqual(await shot(page), before);
});

test('the wheel brings what is under the pointer as near as one likes', async (t) => {
  const page = await openPage(t, { settles: false });
  // A small ball on the corner of a large floor.
  const ball = objText(sphere(8)).replace(/^v (\S+) (\S+) (\S+)/gm, (_, ...at) => {
    const [x, y, z] = at.slice(0, 3).map((value) => 0.005 * Number(value));
    return `v ${x + 0.8} ${y + 0.8} ${z}`;
  });
  const corners = ball.match(/^v /gm).length;
  const floor = [
    ...['v -1 -1 0', 'v 1 -1 0', 'v 1 1 0', 'v -1 1 0'],
    `f ${[1, 2, 3, 4].map((k) => corners + k).join(' ')}`,
  ].join('\n');
  await dropAndWait(page, 'floor.obj', `${ball}\n${floor}\n`);
  await page.focus(CANVAS);
  await page.keyboard.press('1');
  await drawn(page);
  const { x, y, width, height } = await page.locator(CANVAS).boundingBox();
  const side = Math.min(width, height);
  const at = [x + width / 2 + 0.4 * 0.88 * side, y + height / 2 - 0.4 * 0.88 * side];
  await page.mouse.move(...at);
  for (let i = 0; i < 40; ++i) await page.mouse.wheel(0, -200);
  await drawn(page);
  await page.mouse.move(0, 0);
  await drawn(page);
  const around = await page.locator(CANVAS).boundingBox();
  const [px, py] = [Math.round(at[0] - 40), Math.round(at[1] - 40)];
  const clip = { x: px, y: py, width: 80, height: 80 };
  assert.ok(px > around.x && py > around.y);
  assert.ok(!(await isPlain(page, { ...clip })), 'the ball has not been passed');
});
