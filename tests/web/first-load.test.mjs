// What a first visit costs until there is a layout.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { countPrograms, prepareLinking } from './graphics.mjs';
import { LATER, laterParts } from './later-parts.mjs';
import { drawn, openPage, settled } from './page.mjs';
import { takePage } from './pages.mjs';

/** In bytes, compressed. What is not needed for a first look is loaded when it is. */
const MOST = 500_000;
/** Loaded when they are asked for. */
const ON_REQUEST = [
  'draco',
  'meshopt',
  'fbx',
  'basis',
  'ktx2',
  'samples/',
  'pack-',
  'bake',
  'zip-',
];

/** Notes when the first layout came from its worker: what the page asks for then shows it. */
function noteLayout() {
  let saidAt = 0;
  const { Worker } = window;
  window.Worker = class extends Worker {
    constructor(...args) {
      super(...args);
      this.addEventListener('message', () => {
        saidAt = Date.now();
      });
    }
  };
  const look = () => {
    const text = document.querySelector('#run-text')?.textContent ?? 'Starting';
    if (text !== 'Starting' && !document.body.ariaBusy) window.layoutAt ??= saidAt;
  };
  const seen = { subtree: true, childList: true, attributes: true, characterData: true };
  new MutationObserver(look).observe(document, seen);
}

test('a first visit loads little before the first layout', async (t) => {
  const { page, url, end } = await takePage({ own: true, webgl: true });
  t.after(end);
  const sizes = new Map();
  page.context().on('response', (response) => {
    const { pathname } = new URL(response.url());
    const start = response.request().timing().startTime;
    sizes.set(pathname, [Number(response.headers()['content-length'] ?? 0), start]);
  });
  await page.addInitScript(noteLayout);
  await page.goto(url);
  await settled(page);
  // What it loads next may have come until a slow machine gets here.
  const layoutAt = await page.evaluate(() => window.layoutAt);
  assert.ok(layoutAt > 0);
  const all = [...sizes]
    .filter(([, [, start]]) => start <= layoutAt)
    .map(([name, [size]]) => [name, size])
    .sort((a, b) => b[1] - a[1]);
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

test('a first picture compiles no shader that it does not draw with', async (t) => {
  const page = await openPage(t, { prepare: prepareLinking });
  await drawn(page);
  const first = await countPrograms(page);
  assert.ok(first.drawn >= 4, 'the surface and the lines of two views');
  assert.equal(first.linked, first.drawn);
  await page.selectOption('#shading', 'stretch');
  await drawn(page);
  assert.ok((await countPrograms(page)).linked > first.linked, 'a heat map is compiled when shown');
});
