// What the page says besides goes away by itself, but not before it can be read.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { dropAndWait, dropFiles, openPage, textOf } from './page.mjs';

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
