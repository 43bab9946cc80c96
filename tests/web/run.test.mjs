// Long runs: progress, cancelling, and newer requests.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { generatedDisk, toObj } from '../support/disks.mjs';
import { grid } from '../support/small-meshes.mjs';
import { drop, dropAndWait, metrics, openPage, settled, textOf } from './page.mjs';

/**
 * Needles that take the solver many seconds at this t, but few enough for fast frames without a
 * graphics card.
 */
const LARGE = toObj(generatedDisk(197, 40000));
const SLOW_T = '1.05';

/**
 * Waits until the large mesh is on screen and the solver is running. Does not wait for frames,
 * which take seconds without a graphics card.
 */
async function solving(page) {
  await page.waitForFunction(
    () =>
      document.querySelector('#source').textContent === 'large.obj' &&
      /step \d/.test(document.querySelector('#run-text').textContent),
    null,
    { polling: 50 },
  );
}

test('a run in flight shows progress, leaves the page usable and can be cancelled', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.fill('#t-number', SLOW_T);
  await dropAndWait(page, 'waves.obj', grid(6));
  await drop(page, 'large.obj', LARGE);
  await solving(page);
  assert.ok(await page.evaluate(() => document.querySelector('#progress').value > 0));
  await page.click('#wireframe');
  assert.equal(await page.getAttribute('#wireframe', 'aria-pressed'), 'true');

  await page.click('#cancel');
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
  assert.ok(await page.isDisabled('#cancel'));
  assert.ok(await page.isVisible('#again'));
  // Nothing of the mesh before stands beside the one on screen.
  await page.locator('#layout-note').waitFor();
  assert.equal(await textOf(page, '#layout-note'), 'No layout yet');
  assert.equal(await textOf(page, '#badge'), 'No result');
  assert.ok(await page.isDisabled('#export'));

  // The next run works.
  await dropAndWait(page, 'next.obj', grid(5));
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal((await metrics(page)).Faces, '50');
  assert.ok(await page.isHidden('#again'));
});

test('a newer mesh replaces a run in flight; Escape cancels', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.fill('#t-number', SLOW_T);
  await settled(page);
  await drop(page, 'large.obj', LARGE);
  await solving(page);
  await dropAndWait(page, 'small.obj', grid(3));
  assert.equal((await metrics(page)).Faces, '18');
  await drop(page, 'large.obj', LARGE);
  await solving(page);
  await page.keyboard.press('Escape');
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
});

test('of many wishes for t the last one is shown', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.focus('#t');
  for (let i = 0; i < 40; i++) await page.keyboard.press('ArrowLeft');
  for (let i = 0; i < 10; i++) await page.keyboard.press('ArrowRight');
  await settled(page);
  assert.equal(await page.inputValue('#t-number'), '1.7');
  assert.equal(await textOf(page, '#layout-info'), 't = 1.7');
  assert.equal(await textOf(page, '#alert'), '');
});

test('the page runs the build of the module that suits the browser', async (t) => {
  const modules = (page) =>
    page.evaluate(() =>
      performance
        .getEntriesByType('resource')
        .map(({ name }) => /(abflat-(?:simd|threads))-[^/]*\.wasm$/.exec(name)?.[1])
        .filter(Boolean),
    );
  const isolated = await openPage(t, { prepare: withProcessors(2) });
  assert.deepEqual(await modules(isolated), ['abflat-threads']);
  assert.equal(await textOf(isolated, '#badge'), 'Valid');
  await dropAndWait(isolated, 'large.obj', grid(60));
  assert.equal(await textOf(isolated, '#badge'), 'Valid');

  const alone = await openPage(t, { headers: {}, prepare: withProcessors(2) });
  assert.deepEqual(await modules(alone), ['abflat-simd']);
  assert.equal(await textOf(alone, '#badge'), 'Valid');
});

/**
 * Makes the page believe that the machine has this many processors; the worker counts for itself.
 */
function withProcessors(count) {
  return (page) =>
    page.addInitScript((value) => {
      Object.defineProperty(navigator, 'hardwareConcurrency', { value });
    }, count);
}
