// What the page says besides goes away by itself, but not before it can be read.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { dropAndWait, dropFiles, openPage, settled, textOf } from './page.mjs';

const LACKING = ['square.obj', `mtllib square.mtl\nusemtl wood\n${grid(3)}`];

/** Timers of many seconds end when `globalThis.pass` is called, however long this machine takes. */
function playTimers() {
  const { setTimeout, clearTimeout } = globalThis;
  const late = new Map();
  let last = 0;
  globalThis.setTimeout = (work, delay, ...rest) => {
    if (!(delay >= 10_000)) return setTimeout(work, delay, ...rest);
    late.set(--last, work);
    return last;
  };
  globalThis.clearTimeout = (timer) => {
    if (!late.delete(timer)) clearTimeout(timer);
  };
  globalThis.pass = () => {
    const due = [...late.values()];
    late.clear();
    for (const work of due) work();
  };
}

const open = (t) => openPage(t, { prepare: (page) => page.addInitScript(playTimers) });
const muchLater = (page) => page.evaluate(() => globalThis.pass());

const says = (page, id) =>
  page.waitForFunction((id) => document.getElementById(id).textContent !== '', id);

test('a notice goes away, but not while the pointer or the focus is on it', async (t) => {
  const page = await open(t);
  await dropAndWait(page, ...LACKING);
  await says(page, 'notice');
  await page.hover('#notice p');
  await muchLater(page);
  assert.match(await textOf(page, '#notice p'), /square\.mtl not found/);
  await page.focus('#notice .alert-close');
  await page.mouse.move(0, 0);
  await muchLater(page);
  assert.match(await textOf(page, '#notice p'), /square\.mtl not found/);
  await page.focus('#mesh-canvas');
  await muchLater(page);
  assert.equal(await textOf(page, '#notice'), '');
});

test('what went wrong stays, and so does a notice that asks', async (t) => {
  const page = await open(t);
  await dropFiles(page, { 'one.obj': grid(3), 'two.obj': grid(4) });
  await says(page, 'notice');
  await muchLater(page);
  assert.match(await textOf(page, '#notice p'), /^You chose 2 meshes\./);
  await dropFiles(page, { 'empty.obj': '' });
  await says(page, 'alert');
  await muchLater(page);
  assert.match(await textOf(page, '#alert'), /^empty\.obj is empty\./);
});

const TWO = { 'one.obj': grid(3), 'two.obj': grid(4) };
const shown = (page) =>
  page.evaluate(() =>
    ['alert', 'notice'].map((id) => document.getElementById(id).textContent !== ''),
  );

test('Escape closes the newest message, before it leaves a tool or selects nothing', async (t) => {
  const page = await openPage(t);
  await dropFiles(page, TWO);
  await says(page, 'notice');
  await settled(page);
  await dropFiles(page, { 'thing.xyz': 'no mesh' });
  await says(page, 'alert');
  await settled(page);
  assert.deepEqual(await shown(page), [true, true]);
  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  await page.focus('#mesh-canvas');
  for (const left of [
    [false, true],
    [false, false],
  ]) {
    await page.keyboard.press('Escape');
    assert.deepEqual(await shown(page), left);
    assert.equal(await page.getAttribute('#seam-cut', 'aria-pressed'), 'true');
    assert.ok(await page.isVisible('#selection'));
  }
  await page.keyboard.press('Escape');
  assert.equal(await page.getAttribute('#seam-cut', 'aria-pressed'), 'false');
});

test('a question goes once the user works on, an error once something goes well', async (t) => {
  const page = await openPage(t);
  await dropFiles(page, TWO);
  await says(page, 'notice');
  await settled(page);
  assert.deepEqual(await shown(page), [false, true]);
  await page.selectOption('#resolution', '512');
  await settled(page);
  assert.deepEqual(await shown(page), [false, false]);
  await dropFiles(page, { 'thing.xyz': 'no mesh' });
  await says(page, 'alert');
  await Promise.all([page.waitForEvent('download'), page.click('#export')]);
  await page.waitForFunction(() =>
    /^Exported/.test(document.getElementById('run-text').textContent),
  );
  assert.deepEqual(await shown(page), [false, false]);
});

test('if the first of several meshes fails, the question of the others is in view beside that', async (t) => {
  const page = await openPage(t);
  await page.click('#more-toggle');
  await page.fill('#more-texel-density', '9000');
  await page.press('#more-texel-density', 'Enter');
  await settled(page);
  await dropFiles(page, TWO);
  await says(page, 'notice');
  await settled(page);
  assert.match(
    await textOf(page, '#alert'),
    /^one\.obj was not unwrapped: .*\bSet Texel density, under More/,
  );
  // At its corners, nothing covers either, not even the options.
  for (const id of ['alert', 'notice']) {
    const isInView = await page.locator(`#${id}`).evaluate((box) => {
      const { left, right, top, bottom } = box.getBoundingClientRect();
      const at = (x, y) => box.contains(document.elementFromPoint(x, y));
      return [left + 8, right - 8].every((x) => [top + 8, bottom - 8].every((y) => at(x, y)));
    });
    assert.ok(isInView, id);
  }
  await page.getByRole('button', { name: 'Open as tabs' }).click();
  assert.equal(await page.locator('#mesh-tabs [role="tab"]').count(), 2);
});
