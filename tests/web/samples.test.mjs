// The menu of samples, with their pictures, and the sample that is a file.

import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { WebIO } from '@gltf-transform/core';
import axe from 'axe-core';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { pumpkinGlb } from '../../web/scripts/pumpkin.mjs';
import { openPage, openSample, sampleNames, sampleOf, settled, textOf } from './page.mjs';

const FOLDER = join(ROOT, 'web/public/samples');

const focused = (page) => page.evaluate(() => document.activeElement.dataset.value);

/** Whether all pictures have been drawn. */
const pictured = (page) =>
  page.waitForFunction(() =>
    [...document.querySelectorAll('.sample-picture')].every(
      ({ complete, naturalWidth }) => complete && naturalWidth > 0,
    ),
  );

test('pictures are fetched when the menu is opened, not before', async (t) => {
  const asked = [];
  const page = await openPage(t, {
    prepare: (page) =>
      page.on('request', (request) => {
        if (request.url().includes('/samples/')) asked.push(request.url());
      }),
  });
  assert.deepEqual(asked, []);
  await page.click('#sample');
  await pictured(page);
  const names = await sampleNames(page);
  assert.equal(asked.length, names.length);
  const sizes = names.map((name) => statSync(join(FOLDER, `${name}.webp`)).size);
  assert.ok(Math.max(...sizes) < 10_000, `${sizes}`);
});

test('the menu works by keyboard, in rows and columns', async (t) => {
  const page = await openPage(t);
  await page.focus('#sample');
  assert.equal(await page.getAttribute('#sample', 'aria-label'), 'Sample: Head');
  await page.keyboard.press('ArrowDown');
  assert.equal(await focused(page), 'head');
  const names = await sampleNames(page);
  for (const [key, at] of [
    ['Home', 0],
    ['ArrowRight', 1],
    ['ArrowDown', 4],
    ['ArrowDown', 1],
    ['ArrowUp', 4],
    ['ArrowLeft', 3],
    ['ArrowUp', 0],
    ['ArrowLeft', 5],
    ['ArrowRight', 0],
    ['End', 5],
  ]) {
    await page.keyboard.press(key);
    assert.equal(await focused(page), names[at], key);
  }
  await page.keyboard.press('Escape');
  assert.ok(await page.isHidden('#sample-menu'));
  assert.equal(await page.evaluate(() => document.activeElement.id), 'sample');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Home');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('#sample').value === 'hemisphere');
  await settled(page);
  assert.equal(await textOf(page, '#sample'), 'Hemisphere');
  await page.click('#sample');
  const checked = page.locator('.sample-item[aria-checked="true"]');
  assert.deepEqual(await checked.evaluateAll((items) => items.map((e) => e.dataset.value)), [
    'hemisphere',
  ]);
});

for (const [name, options] of [
  ['dark', {}],
  ['light', { colorScheme: 'light' }],
  ['phone', { viewport: { width: 390, height: 844 }, hasTouch: true }],
])
  test(`the menu is on the screen and without faults, ${name}`, async (t) => {
    const page = await openPage(t, { ...options });
    const { width, height } = page.viewportSize();
    await (options.hasTouch ? page.tap('#sample') : page.click('#sample'));
    await pictured(page);
    if (process.env.PICTURES)
      await page.screenshot({ path: `${process.env.PICTURES}/samples-${name}.png` });
    const box = await page.locator('#sample-menu').boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= width, JSON.stringify(box));
    assert.ok(box.y >= 0 && box.y + box.height <= height, JSON.stringify(box));
    await page.evaluate(axe.source);
    const found = await page.evaluate(async () => (await globalThis.axe.run('.bar')).violations);
    assert.deepEqual(
      found.map(({ id }) => id),
      [],
    );
    const item = page.locator('.sample-item[data-value="three-balls"]');
    await (options.hasTouch ? item.tap() : item.click());
    await page.waitForFunction(() => document.querySelector('#sample').value === 'three-balls');
    await settled(page);
  });

test('one sample is a file: closed, with a texture, as the script makes it', async (t) => {
  const bytes = readFileSync(join(FOLDER, 'pumpkin.glb'));
  assert.ok(bytes.length < 60_000, `${bytes.length} bytes`);
  const document = await new WebIO().readBinary(new Uint8Array(bytes));
  const [texture] = document.getRoot().listTextures();
  const again = await pumpkinGlb(texture.getImage());
  assert.ok(bytes.equals(Buffer.from(again)), 'run web/scripts/samples.mjs');
  const page = await openPage(t);
  await openSample(page, 'pumpkin');
  assert.equal(await textOf(page, '#source'), 'pumpkin.glb');
  assert.equal(await textOf(page, '#sample'), 'Samples');
  assert.equal(await sampleOf(page), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await textOf(page, '#export'), 'Export GLB');
  assert.match(await page.getAttribute('#mode-unwrap', 'title'), /islands in one texture$/);
  const edges = new Map();
  const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
  const position = primitive.getAttribute('POSITION');
  const key = (v) => position.getElement(v, []).join();
  const indices = primitive.getIndices().getArray();
  for (let h = 0; h < indices.length; ++h) {
    const next = h % 3 === 2 ? h - 2 : h + 1;
    const edge = [key(indices[h]), key(indices[next])];
    assert.ok(!edges.has(edge.join('>')), 'each edge has one triangle on its left');
    edges.set(edge.join('>'), edge.reverse().join('>'));
  }
  for (const [edge, opposite] of edges) assert.ok(edges.has(opposite), `${edge} has another side`);
});
