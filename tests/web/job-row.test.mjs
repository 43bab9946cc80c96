// The job on one row, and nothing cut off, in a usual window; on a phone, its end in sight.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { oneColor, RED } from '../support/painted.mjs';
import { CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { objText, torus } from '../support/surfaces.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';
import { choose, dropAndWait, exportMesh, metrics, openPage, settled, textOf } from './page.mjs';

const WINDOW = { viewport: { width: 1440, height: 900 } };

/** What has to be scrolled, or is cut off without its whole text in a title. */
const cutOff = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('body *')]
      .filter((part) => part.checkVisibility() && !part.matches('.visually-hidden, canvas, option'))
      .filter((part) => {
        const { overflowX, overflowY, textOverflow } = getComputedStyle(part);
        const across = part.scrollWidth > part.clientWidth + 1;
        const scrolls = (overflow) => overflow === 'auto' || overflow === 'scroll';
        if (across && textOverflow === 'ellipsis')
          return !part.closest('[title]')?.title.includes(part.textContent);
        const down = part.scrollHeight > part.clientHeight + 1;
        return (across && scrolls(overflowX)) || (down && scrolls(overflowY));
      })
      .map((part) => part.id || part.className || part.tagName),
  );

test('open, unwrap, bake and export are on one row in their order, and nothing scrolls', async (t) => {
  const page = await openPage(t, WINDOW);
  assert.deepEqual(await cutOff(page), [], 'on a first visit');
  await dropAndWait(page, 'parts.obj', CUBE_OF_PARTS);
  const job = ['open', 'mode-unwrap', 'mode-flatten', 'mode-pack', 'bake-too', 'export'];
  const boxes = await Promise.all(job.map((id) => page.locator(`#${id}`).boundingBox()));
  boxes.forEach((box, i) => {
    assert.ok(box, `${job[i]} is shown`);
    assert.ok(Math.abs(box.y + box.height / 2 - (boxes[0].y + boxes[0].height / 2)) < 2, job[i]);
    if (i > 0) assert.ok(box.x >= boxes[i - 1].x + boxes[i - 1].width - 1, `${job[i]} comes later`);
  });
  for (const mode of ['unwrap', 'pack']) {
    await choose(page, mode);
    assert.deepEqual(await cutOff(page), [], mode);
  }
  await page.click('#pack-islands');
  await settled(page);
  assert.deepEqual(await cutOff(page), [], 'repacked');
});

test('the figures that matter most are in sight, all others behind a button', async (t) => {
  const page = await openPage(t, { ...WINDOW, open: ['torus.obj', objText(torus(24, 12))] });
  const shown = () =>
    page
      .locator('.metric dt')
      .evaluateAll((labels) =>
        labels.filter((label) => label.checkVisibility()).map((label) => label.textContent),
      );
  const first = ['Islands', 'Stretch', 'Space used', 'Texels per unit'];
  assert.deepEqual(await shown(), first);
  await page.click('#all-figures');
  assert.deepEqual(await shown(), Object.keys(await metrics(page)));
  assert.deepEqual(await cutOff(page), []);
  await page.click('#all-figures');
  assert.deepEqual(await shown(), first);
});

test('a reason is whole, however long it is', async (t) => {
  const page = await openPage(t, {
    ...WINDOW,
    open: ['parts.obj', objText(torus(24, 12)).replace(/^f/m, 'usemtl a\nf')],
  });
  await page.click('#seams-auto');
  await settled(page);
  assert.match(await textOf(page, '#reason'), /limit 1\.02$/);
  for (const width of [1440, 1200, 900, 390]) {
    await page.setViewportSize({ width, height: 900 });
    const reason = page.locator('#reason');
    assert.ok(
      await reason.evaluate(
        (e) => e.scrollWidth <= e.clientWidth && e.scrollHeight <= e.clientHeight,
      ),
      String(width),
    );
  }
});

/** Buttons that a finger does not reach or that something covers, of those that end a job. */
const outOfReach = (page) =>
  page.evaluate(() =>
    ['undo', 'redo', 'texcoord', 'export', 'export-formats']
      .map((id) => document.getElementById(id))
      .filter((button) => button.checkVisibility())
      .filter((button) => {
        const { x, y, width, height, right } = button.getBoundingClientRect();
        const there = document.elementFromPoint(x + width / 2, y + height / 2);
        const isFree = there !== null && button.contains(there);
        const isCut = button.scrollWidth > button.clientWidth + 1;
        return !isFree || isCut || x < 0 || right > innerWidth || Math.min(width, height) < 40;
      })
      .map(({ id }) => id),
  );

for (const [width, height] of [
  [390, 844],
  [360, 740],
])
  test(`on a phone, Export and Undo are in sight wherever the page is scrolled, ${width} wide`, async (t) => {
    const page = await openPage(t, { viewport: { width, height }, hasTouch: true });
    const check = async (what) => {
      for (const share of [0, 0.5, 1]) {
        await page.evaluate((share) => scrollTo(0, share * document.body.scrollHeight), share);
        assert.deepEqual(await outOfReach(page), [], `${what}, scrolled by ${share}`);
      }
      const across = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(across <= 0, what);
    };
    await check('a first visit');
    await dropAndWait(page, 'torus.obj', objText(torus(24, 12)));
    await check('an OBJ');
    await dropAndWait(page, 'cube.glb', texturedGlb([texturedCube()], oneTexture(oneColor(RED))));
    assert.ok(await page.isVisible('#texcoord'));
    await check('a choice of UV sets');
    await page.tap('#export-formats');
    await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).tap();
    await page.getByRole('menuitemradio', { name: 'OBJ' }).evaluate((item) => item.click());
    await page.waitForFunction(() =>
      /^Exported/.test(document.querySelector('#run-text').textContent),
    );
    assert.equal(await textOf(page, '#export'), 'Export baked OBJ (zip)');
    await check('a long label');
    // A selection has its bar at the foot.
    await page.focus('#layout-canvas');
    await page.keyboard.press('a');
    assert.ok(await page.isVisible('#selection'));
    await check('a selection');
    assert.equal((await exportMesh(page)).name, 'cube-uv.zip');
  });
