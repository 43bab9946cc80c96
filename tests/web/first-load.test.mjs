// What a first visit costs until there is a layout.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LATER, laterParts } from './later-parts.mjs';
import { settled } from './page.mjs';
import { takePage } from './pages.mjs';

/** In bytes, compressed. What is not needed for a first look is loaded when it is. */
const MOST = 500_000;
/** Loaded when they are asked for. */
const ON_REQUEST = ['draco', 'meshopt', 'samples/'];

test('a first visit loads little before the first layout', async (t) => {
  const { page, url, end } = await takePage({ own: true, webgl: true });
  t.after(end);
  const sizes = new Map();
  page.context().on('response', (response) => {
    const { pathname } = new URL(response.url());
    sizes.set(pathname, Number(response.headers()['content-length'] ?? 0));
  });
  await page.goto(url);
  await settled(page);
  const all = [...sizes].sort((a, b) => b[1] - a[1]);
  const total = all.reduce((sum, [, size]) => sum + size, 0);
  t.diagnostic(`${Math.round(total / 1000)} kB in ${all.length} files`);
  assert.ok(all.some(([name]) => name.endsWith('.wasm')));
  assert.ok(total < MOST, all.map(([name, size]) => `${name} ${size}`).join('\n'));
  for (const part of [...LATER, ...ON_REQUEST])
    assert.ok(!all.some(([name]) => name.includes(part)), part);
});

test('what was left out comes without being asked for', async (t) => {
  const { page, url, end } = await takePage({ own: true, webgl: true });
  t.after(end);
  const parts = laterParts(page);
  await page.goto(url);
  for (const response of await parts) assert.equal(response.status(), 200);
});
