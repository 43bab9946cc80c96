// What edits seams is loaded after the first layout.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { openPage, pathOf, settled, textOf } from './page.mjs';
import { click, point, SMALL } from './seam-page.mjs';

/** On a first visit what edits seams comes after the first layout; here it does not come before `release` is called. */
async function openHeld(t, options = SMALL) {
  let release;
  const held = new Promise((resolve) => {
    release = resolve;
  });
  const prepare = (page) =>
    page.route(/\/assets\/solid-/, async (route) => {
      await held;
      await route.continue();
    });
  return { page: await openPage(t, { ...options, prepare }), release };
}

test('what is done to seams before they can be edited waits for that', async (t) => {
  const { page, release } = await openHeld(t);
  await page.click('#details-toggle');
  assert.ok(await page.isEnabled('#seam-cut'));
  assert.equal(
    await point(page, 0.5, 0.5),
    'Click a vertex to start a cut, double-click to cut a loop',
  );
  await click(page);
  const saving = page.waitForEvent('download');
  await page.click('#seams-save');
  assert.doesNotMatch(await textOf(page, '#run-text'), /Cut|Saved/);
  release();
  const saved = await saving;
  assert.match(readFileSync(await pathOf(saved), 'utf8'), /^\d+ \d+$/m);
  await point(page, 0.5, 0.5);
  await page.waitForFunction(() =>
    /^Vertex \d+ to|^From vertex/.test(document.querySelector('#seam-hint').textContent),
  );
});

test('if what edits seams cannot be loaded, the page says so and tries again', async (t) => {
  const script = /\/assets\/solid-/;
  const page = await openPage(t, {
    ...SMALL,
    prepare: (page) => page.route(script, (route) => route.abort()),
    expected: /ERR_FAILED/,
  });
  await point(page, 0.5, 0.5);
  await click(page);
  const said =
    'Seams cannot be edited: a part of this page could not be loaded. Check the connection, then try again.';
  await page.waitForFunction(
    (said) => document.querySelector('#run-text').textContent === said,
    said,
  );
  assert.ok(await page.isDisabled('#seam-cut'));
  await page.unroute(script);
  await page.click('#seams-sharp');
  await settled(page);
  await point(page, 0.5, 0.5);
  await page.waitForFunction(() =>
    /^Vertex \d+: start/.test(document.querySelector('#seam-hint').textContent),
  );
});
