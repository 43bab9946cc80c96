// Work by hand stays with its mesh while others are open, and nothing of it goes without a question.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { dropAndWait, exportMesh, openPage, settled, textOf } from './page.mjs';

const BOTH = objText(
  together([
    [torus(16, 8), [0, 0, 0]],
    [sphere(6), [3, 0, 0]],
  ]),
);

const bytes = async (page) => readFileSync((await exportMesh(page)).path);
const names = (page) => page.locator('.mesh-tab-name').allTextContents();
const tab = (page, name) => page.locator('#mesh-tabs').getByRole('tab', { name });
const marked = (page) =>
  page.locator('.mesh-tab:has(.mesh-tab-dot) .mesh-tab-name').allTextContents();

const shows = async (page, name) => {
  await page.waitForFunction(
    (name) => document.querySelector('#source').textContent === name,
    name,
  );
  await settled(page);
};

/** Work without views, so that nothing is drawn. */
const openBoth = (t, options = {}) =>
  openPage(t, { webgl: false, open: ['both.obj', BOTH], ...options });

async function cut(page, edges) {
  await page.setInputFiles('#seams-file', {
    name: 'own.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from(edges),
  });
  const count = edges.trim().split('\n').length;
  await page.waitForFunction(
    (count) =>
      document.querySelector('#seams-state').textContent.startsWith(`seams edited: ${count} `),
    count,
  );
  await settled(page);
}

const steps = (page) => page.locator('#history .step').allTextContents();

test('a mesh with work by hand stays open in a tab, and is shown again as it was left', async (t) => {
  const page = await openBoth(t);
  await page.fill('#padding', '9');
  await settled(page);
  await cut(page, '1 2\n2 3\n');
  await page.fill('#padding', '5');
  await settled(page);
  const before = { steps: await steps(page), bytes: await bytes(page) };
  await dropAndWait(page, 'next.obj', grid(4));
  assert.deepEqual(await names(page), ['both.obj', 'next.obj']);
  assert.equal(await textOf(page, '#seams-state'), '', 'it has seams of its own');
  assert.ok(await page.isDisabled('#undo'));
  await page.fill('#padding', '3');
  await settled(page);

  await tab(page, 'both.obj').click();
  await shows(page, 'both.obj');
  assert.equal(await textOf(page, '#run-text'), 'both.obj is as you left it');
  assert.match(await textOf(page, '#seams-state'), /^seams edited: 2 edges/);
  assert.equal(await page.inputValue('#padding'), '5');
  assert.deepEqual(await steps(page), before.steps);
  assert.ok(before.bytes.equals(await bytes(page)), 'the same file');

  // Its history goes on, back to what was before the other mesh was opened, and forth.
  for (const padding of ['9', '9', '2']) {
    await page.click('#undo');
    await settled(page);
    assert.equal(await page.inputValue('#padding'), padding);
  }
  assert.equal(await textOf(page, '#seams-state'), '');
  assert.ok(await page.isDisabled('#undo'));
  for (let i = 0; i < 3; i++) await page.click('#redo');
  await settled(page);
  assert.ok(before.bytes.equals(await bytes(page)), 'the same file again');

  // So has the other one.
  await tab(page, 'next.obj').click();
  await shows(page, 'next.obj');
  assert.equal(await page.inputValue('#padding'), '3');
  assert.equal((await steps(page)).length, 2);
});

test('a mesh without work by hand gives way to the next one', async (t) => {
  const page = await openBoth(t);
  await page.fill('#padding', '9');
  await settled(page);
  await dropAndWait(page, 'next.obj', grid(4));
  assert.ok(await page.isHidden('#mesh-tabs'));
  assert.equal(await page.inputValue('#padding'), '9', 'options stay');
});

test('a tab with edits that no file has is marked, and asks before it is closed', async (t) => {
  const page = await openBoth(t);
  await cut(page, '1 2\n2 3\n');
  await dropAndWait(page, 'next.obj', grid(4));
  assert.deepEqual(await marked(page), ['both.obj']);
  const sheet = page.getByRole('dialog');
  await tab(page, 'both.obj').focus();
  await page.keyboard.press('Delete');
  assert.equal(
    await sheet.getByRole('heading').innerText(),
    'Close both.obj without exporting it?',
  );
  assert.deepEqual(await sheet.locator('.primary').allInnerTexts(), ['Cancel']);
  await page.keyboard.press('Escape');
  await sheet.waitFor({ state: 'detached' });
  assert.deepEqual(await names(page), ['both.obj', 'next.obj']);
  await tab(page, 'both.obj').click();
  await shows(page, 'both.obj');
  await exportMesh(page);
  await page.waitForFunction(() => !document.querySelector('.mesh-tab-dot'));
  // Undone, it is another layout; done again, it is in the file.
  await page.click('#undo');
  await settled(page);
  assert.deepEqual(await marked(page), []);
  await cut(page, '1 2\n');
  assert.deepEqual(await marked(page), ['both.obj']);
  await page.locator('.mesh-tab-close').first().click();
  await sheet.getByRole('button', { name: 'Close without exporting' }).click();
  await shows(page, 'next.obj');
  assert.ok(await page.isHidden('#mesh-tabs'));
});

test('the browser asks before a page with edits that no file has is closed', async (t) => {
  const page = await openBoth(t, { own: true });
  const wouldAsk = () =>
    page.evaluate(() => {
      const event = new Event('beforeunload', { cancelable: true });
      window.dispatchEvent(event);
      return event.defaultPrevented;
    });
  assert.equal(await wouldAsk(), false);
  await cut(page, '1 2\n2 3\n');
  assert.equal(await wouldAsk(), true);
  await page.click('#undo');
  await settled(page);
  assert.equal(await wouldAsk(), false);
  await page.click('#redo');
  await settled(page);
  await dropAndWait(page, 'next.obj', grid(4));
  assert.equal(await wouldAsk(), true, 'of a mesh in another tab');
  await tab(page, 'both.obj').click();
  await shows(page, 'both.obj');
  await exportMesh(page);
  await page.waitForFunction(() => !document.querySelector('.mesh-tab-dot'));
  assert.equal(await wouldAsk(), false);
});
