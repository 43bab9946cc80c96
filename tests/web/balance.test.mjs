// The slider between angles and lengths, in both kinds of layout.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText, sphere } from '../support/surfaces.mjs';
import { choose, dropAndWait, metrics, openPage, openSample, settled, textOf } from './page.mjs';

const picture = (page, id) => page.locator(id).screenshot();

async function press(page, mode, ...keys) {
  await page.focus(`#${mode}-balance`);
  for (const key of keys) await page.keyboard.press(key);
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
}

test('a disk is refined as the slider says, by keyboard, and its numbers tell what that gained', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  assert.equal(await textOf(page, '#flatten-balance-value'), '0');
  const [before, layout] = [await metrics(page), await picture(page, '#layout-canvas')];
  assert.equal(before.Energy, undefined);
  const stretch = [Number(before.Stretch)];
  for (const [keys, value] of [
    [['ArrowRight', 'ArrowRight'], '0.1'],
    [['End'], '1'],
  ]) {
    await press(page, 'flatten', ...keys);
    assert.equal(await textOf(page, '#flatten-balance-value'), value);
    assert.match(
      await page.getAttribute('#flatten-balance', 'aria-valuetext'),
      RegExp(`^${value}: `),
    );
    const shown = await metrics(page);
    stretch.push(Number(shown.Stretch));
    const [from, to] = shown.Energy.split(' \u2192 ').map(Number);
    assert.ok(to < from && to >= 1, shown.Energy);
  }
  assert.ok(stretch[2] < stretch[1] && stretch[1] < stretch[0] && stretch[2] >= 1, `${stretch}`);
  assert.notDeepEqual(await picture(page, '#layout-canvas'), layout);
  await press(page, 'flatten', 'Home');
  const { Time, ...again } = await metrics(page);
  const { Time: _, ...first } = before;
  assert.deepEqual(again, first);
});

test('islands are refined as well; each kind of layout has a balance of its own', async (t) => {
  const page = await openPage(t, { open: ['ball.obj', objText(sphere(6))] });
  const usual = await textOf(page, '#unwrap-balance-value');
  const before = await metrics(page);
  await press(page, 'unwrap', 'End');
  assert.equal(await textOf(page, '#unwrap-balance-value'), '1');
  const after = await metrics(page);
  const angular = (shown) => Number(shown['Angular distortion']);
  assert.ok(angular(after) > angular(before), 'lengths for angles');
  assert.match(after.Energy, /^1\.\d+ \u2192 1\.\d+$/);
  await dropAndWait(page, 'other.obj', objText(sphere(4)));
  assert.equal(await textOf(page, '#unwrap-balance-value'), '1', 'settings outlive a mesh');
  await openSample(page, 'head');
  await choose(page, 'flatten');
  assert.equal(await textOf(page, '#flatten-balance-value'), '0');
  await choose(page, 'unwrap');
  await press(page, 'unwrap', 'Home');
  assert.equal(await textOf(page, '#unwrap-balance-value'), '0');
  assert.equal(usual, '0.2');
});

test('both sliders, their names and values are within windows of all widths, and what they gained can be read', async (t) => {
  const page = await openPage(t);
  await page.click('#all-figures');
  for (const mode of ['flatten', 'unwrap']) {
    await choose(page, mode);
    await press(page, mode, 'End', 'ArrowLeft');
    const shown = Object.keys(await metrics(page));
    assert.ok(shown.includes('Energy') && shown.length === 8, `${shown}`);
    for (const [width, height] of [
      [1280, 720],
      [1200, 675],
      [1030, 675],
      [900, 800],
      [675, 800],
      [390, 844],
    ]) {
      const where = `${mode}, ${width} x ${height}`;
      await page.setViewportSize({ width, height });
      const slider = page.locator(`#${mode}-balance`);
      await slider.scrollIntoViewIfNeeded();
      const box = await slider.boundingBox();
      assert.ok(box.width >= 60, `${where}: ${box.width} wide`);
      const ask = await page.locator('.ask').boundingBox();
      const row = page.locator('.balance').filter({ has: slider });
      const parts = [
        row.locator('b'),
        row.locator('output'),
        ...(await row.locator('.bound-hint').all()),
      ];
      for (const part of parts) {
        const { x, width: wide } = await part.boundingBox();
        assert.ok(x >= ask.x && x + wide <= ask.x + ask.width, where);
        assert.ok(x + wide <= box.x || x >= box.x + box.width, 'nothing lies on the slider');
        assert.ok(await part.evaluate((e) => e.scrollWidth <= e.clientWidth || !e.clientWidth));
      }
      const energy = page.locator('.metric dt', { hasText: 'Energy' });
      assert.ok(await energy.evaluate((e) => e.scrollWidth <= e.clientWidth), where);
    }
  }
});
