// Shading of both views: the numbered grid, and heat maps with their legend.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { objText, torus } from '../support/surfaces.mjs';
import { isPlain } from './layout.mjs';
import { choose, drawn, dropAndWait, openPage, settled, textOf } from './page.mjs';

const TORUS = objText(torus(24, 12));
const VIEWS = ['#mesh-canvas', '#layout-canvas'];

/** As they are in the end: what lies on them may still be fading. */
async function pictures(page) {
  await drawn(page);
  return Promise.all(
    VIEWS.map(async (id) =>
      createHash('md5')
        .update(await page.locator(id).screenshot({ animations: 'disabled' }))
        .digest('hex'),
    ),
  );
}

/** Both views have changed. */
function assertOther(now, before) {
  now.forEach((picture, i) => {
    assert.notEqual(picture, before[i], VIEWS[i]);
  });
}

test('every shading paints both views, and heat maps say what their colours mean', async (t) => {
  const page = await openPage(t, { open: ['torus.obj', TORUS] });
  const plain = await pictures(page);
  let before = plain;
  for (const [shading, title, low, high] of [
    ['grid'],
    ['angle', 'Angle error', /^0\s%$/, /^25\s% or more$/],
    ['area', 'Area', /^×0\.50 or less$/, /^×2\.00 or more$/],
    ['stretch', 'Stretch', /^1\.00$/, /^1\.30 or more$/],
    ['texels', 'Texels per unit', /^[\d.]+ or less$/, /^[\d.]+ or more$/],
  ]) {
    await page.selectOption('#shading', shading);
    const now = await pictures(page);
    assertOther(now, before);
    before = now;
    assert.equal(await page.isVisible('#legend'), title !== undefined, shading);
    if (!title) continue;
    assert.equal(await textOf(page, '#legend-title'), title);
    assert.match(await textOf(page, '#legend-low'), low);
    assert.match(await textOf(page, '#legend-most'), high);
  }
  await page.selectOption('#shading', 'plain');
  assert.ok(await page.isHidden('#legend'));
  assert.deepEqual(await pictures(page), plain);
});

test('a bar of the histogram lights its triangles, and the button the worst', async (t) => {
  // Without transitions the corners of the button are not drawn the same once it was pointed at.
  const page = await openPage(t, { reducedMotion: 'no-preference', open: ['torus.obj', TORUS] });
  await page.selectOption('#shading', 'stretch');
  const all = await pictures(page);
  const bar = page.locator('.legend-column').nth(2);
  await bar.click();
  assert.equal(await bar.getAttribute('aria-pressed'), 'true');
  assert.match(
    await textOf(page, '#legend-said'),
    /^Stretch 1\.\d\d to 1\.\d\d: .*of the surface$/,
  );
  const some = await pictures(page);
  assertOther(some, all);
  await page.click('#legend-worst');
  assert.equal(await bar.getAttribute('aria-pressed'), 'false');
  assertOther(await pictures(page), some);
  await page.click('#legend-worst');
  await page.mouse.move(0, 0);
  assert.deepEqual(await pictures(page), all, 'all are lit again');

  // One stop of the Tab key; arrows go from bar to bar.
  await page.locator('.legend-column').first().focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('.legend-column').nth(1).getAttribute('aria-pressed'), 'true');
  await page.keyboard.press('End');
  assert.match(await textOf(page, '#legend-said'), /^Stretch 1\.29 or more: /);
});

test('the shading stays with the next mesh, with a histogram of its own', async (t) => {
  const page = await openPage(t, { open: ['torus.obj', TORUS] });
  await page.selectOption('#shading', 'area');
  await page.locator('.legend-column').nth(12).click();
  const sentences = () =>
    page
      .locator('.legend-column')
      .evaluateAll((bars) => bars.map((each) => each.getAttribute('aria-label')));
  const before = await sentences();
  await dropAndWait(page, 'thin.obj', objText(torus(30, 8, 0.15)));
  await settled(page);
  assert.equal(await page.inputValue('#shading'), 'area');
  assert.ok(await page.isVisible('#legend'));
  assert.notDeepEqual(await sentences(), before);
  assert.equal(await page.locator('.legend-column[aria-pressed="true"]').count(), 0);
});

test('a click on a number of the result shows where it is worst', async (t) => {
  const page = await openPage(t, { open: ['torus.obj', TORUS] });
  await page.click('#all-figures');
  const plain = await pictures(page);
  for (const [label, title] of [
    ['Stretch', 'Stretch'],
    ['Angular distortion', 'Angle error'],
  ]) {
    await page.locator('.metric', { hasText: label }).getByRole('button').click();
    assert.equal(await textOf(page, '#legend-title'), title);
    assert.equal(await page.getAttribute('#legend-worst', 'aria-pressed'), 'true');
    assertOther(await pictures(page), plain);
  }
  await page.selectOption('#shading', 'plain');
  await page.mouse.move(0, 0);
  assert.deepEqual(await pictures(page), plain);
});

/** Whether nothing is drawn where the legend lies. */
async function isFreeOfLayout(page) {
  const legend = page.locator('#legend');
  const clip = await legend.boundingBox();
  const show = (visibility) =>
    legend.evaluate((element, visibility) => {
      element.style.visibility = visibility;
    }, visibility);
  await show('hidden');
  const isFree = await isPlain(page, clip);
  await show('');
  return isFree;
}

test('a fitted layout leaves its legend free, in one piece and in charts', async (t) => {
  const page = await openPage(t, { open: ['grid.obj', grid(6)] });
  await page.selectOption('#shading', 'area');
  for (const mode of ['flatten', 'unwrap']) {
    await choose(page, mode);
    for (const [width, height] of [
      [1440, 900],
      [1024, 768],
      [390, 844],
    ]) {
      await page.setViewportSize({ width, height });
      await page.locator('#layout-canvas').scrollIntoViewIfNeeded();
      await drawn(page);
      assert.ok(await isFreeOfLayout(page), `${mode}, ${width}`);
    }
  }
});
