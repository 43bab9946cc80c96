// What a first visit is told.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { dropAndWait, openPage, openSample, settled } from './page.mjs';

test('a first visit is told what this is, until a mesh of its own was opened', async (t) => {
  const page = await openPage(t);
  const welcome = page.locator('#welcome');
  assert.match(
    await welcome.innerText(),
    /^Unwrap a 3D model for texturing\. .*OBJ.*GLB.*sample\.$/s,
  );
  await openSample(page, 'hemisphere');
  assert.ok(await welcome.isVisible(), 'a sample is not of their own');
  await dropAndWait(page, 'nothing.obj', 'v 0 0 0\n');
  assert.ok(await welcome.isVisible(), 'nothing was opened');
  await dropAndWait(page, 'waves.obj', grid(4));
  assert.ok(await welcome.isHidden());
  await page.reload();
  await settled(page);
  assert.ok(await welcome.isHidden());
});

for (const [width, height] of [
  [1920, 1080],
  [1280, 720],
  [1024, 768],
  [900, 700],
  [768, 1024],
  [390, 844],
  [320, 640],
])
  test(`what a first visit is told can be read and covers nothing, ${width} wide`, async (t) => {
    const page = await openPage(t, { viewport: { width, height }, hasTouch: width < 1000 });
    const wrong = await page.evaluate(() => {
      const welcome = document.querySelector('#welcome');
      const own = welcome.getBoundingClientRect();
      const others = [...document.querySelectorAll('.bar > :not(#welcome), .pane, .dock')];
      const meets = (element) => {
        const box = element.getBoundingClientRect();
        const isBeside = box.right <= own.left || box.left >= own.right;
        return box.width > 0 && !isBeside && box.bottom > own.top && box.top < own.bottom;
      };
      const isCut = welcome.scrollHeight > welcome.clientHeight || own.right > innerWidth;
      return [...others.filter(meets).map((e) => e.id || e.className), ...(isCut ? ['cut'] : [])];
    });
    assert.deepEqual(wrong, []);
  });
