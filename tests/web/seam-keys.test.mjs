// Seams are edited with keys held, by keyboard and by touch.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settled, textOf } from './page.mjs';
import {
  CANVAS,
  click,
  clickAt,
  drawn,
  edited,
  hint,
  openGrid,
  point,
  pointAtSeam,
  SMALL,
  vertices,
} from './seam-page.mjs';

test('Escape lets go, a drag turns the view, Alt does the other thing, Shift goes on', async (t) => {
  const page = await openGrid(t, 4);
  const seen = await vertices(page);
  await clickAt(page, seen.get(6));
  assert.match(await point(page, ...seen.get(7)), /^Vertex 6 to 7/);
  await page.keyboard.press('Escape');
  await drawn(page);
  assert.match(await hint(page), /^Vertex 7: start a cut/);
  assert.equal(await textOf(page, '#run-text'), 'Cut cancelled');

  // From 6 to 8 and on to 18.
  await clickAt(page, seen.get(6));
  await point(page, ...seen.get(8));
  await page.keyboard.down('Shift');
  await click(page);
  await settled(page);
  assert.equal(await edited(page), 2);
  await clickAt(page, seen.get(18));
  await page.keyboard.up('Shift');
  await settled(page);
  assert.equal(await edited(page), 4);
  await page.keyboard.press('Escape');

  await page.keyboard.down('Alt');
  await pointAtSeam(page, seen.get(6), seen.get(7));
  assert.equal(await hint(page), 'Seam of 4 edges: join');
  await page.keyboard.down('Shift');
  await drawn(page);
  assert.equal(await hint(page), 'Seam of 1 edge: join');
  await click(page);
  await page.keyboard.up('Shift');
  await page.keyboard.up('Alt');
  await settled(page);
  assert.equal(await edited(page), 3);

  const before = await edited(page);
  const still = await page.locator(CANVAS).screenshot();
  const box = await page.locator(CANVAS).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  assert.notDeepEqual(await page.locator(CANVAS).screenshot(), still);
  assert.equal(await edited(page), before);
  assert.doesNotMatch(await hint(page), /^From vertex/);
});

test('seams are cut by keyboard and by touch', async (t) => {
  const page = await openGrid(t, 4, { ...SMALL, hasTouch: true });
  const seen = await vertices(page);
  await page.mouse.move(0, 0);
  const box = await page.locator(CANVAS).boundingBox();
  const tap = ([x, y]) => page.touchscreen.tap(box.x + x * box.width, box.y + y * box.height);
  await tap(seen.get(6));
  await drawn(page);
  assert.equal(await textOf(page, '#run-text'), 'Cut started at vertex 6');
  await page.locator('#seam-cancel').tap();
  await drawn(page);
  assert.equal(await textOf(page, '#run-text'), 'Cut cancelled');
  assert.ok(await page.isHidden('#seam-cancel'));
  await tap(seen.get(6));
  await drawn(page);
  await tap(seen.get(8));
  await drawn(page);
  await settled(page);
  assert.equal(await edited(page), 2);

  await page.focus(CANVAS);
  await page.keyboard.press('Home');
  await drawn(page);
  const first = /^Vertex (\d+): start/.exec(await hint(page));
  assert.ok(first, await hint(page));
  await page.keyboard.press('Enter');
  for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowLeft');
  await drawn(page);
  assert.match(await hint(page), /^(Vertex|From vertex) \d+/);
  await page.keyboard.press('Escape');
  await drawn(page);
  assert.match(await hint(page), /^Vertex \d+: start|^Click a vertex/);
  assert.equal(await edited(page), 2);
});
