// The tab that verifies the layout on screen.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import axe from 'axe-core';
import { runAbflat } from '../support/run-abflat.mjs';
import { CUBE } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { choose, dropAndWait, openPage, pathOf, textOf } from './page.mjs';
import { squares } from './squares.mjs';
import { changed, openUvs } from './uvs-page.mjs';

/** Two that overlap, a mirrored one, and one that leaves the square. */
const RECTANGLES = [
  [0.1, 0.1, 0.4, 0.1],
  [0.3, 0.15, 0.3, 0.3],
  [0.5, 0.6, -0.1, 0.3],
  [0.9, 0.9, 0.2, 0.05],
];

async function openTab(page) {
  if (await page.isHidden('#details')) await page.click('#details-toggle');
  await page.click('#tab-verify');
  await page.locator('#verify').waitFor();
}

const verdict = (page) => textOf(page, '.verify-verdict');
/** Waits until it was judged, and returns the findings: names and what they are about. */
async function judged(page) {
  await page
    .locator('.verify-verdict')
    .getByText(/^(Valid|Not valid)/)
    .waitFor();
  return page
    .locator('.finding')
    .evaluateAll((found) =>
      found.map((button) => [...button.children].slice(0, 2).map((part) => part.textContent)),
    );
}

test('findings are listed in plain words, and a click shows one in both views', async (t) => {
  const page = await openUvs(t, RECTANGLES);
  await openTab(page);
  assert.ok(await page.isDisabled('#verify-save'));
  await page.click('#verify');
  assert.deepEqual(await judged(page), [
    ['Turned over', '1 face of island 2'],
    ['Overlap', 'Islands 0 and 1'],
    ['Outside', '1 face of island 3'],
  ]);
  assert.equal(await verdict(page), 'Not valid: 3 findings');
  const overlap = page.locator('.finding').nth(1);
  await overlap.click();
  assert.equal(await overlap.getAttribute('aria-pressed'), 'true');
  assert.match(await textOf(page, '#selection-text'), /^2 islands: /);
  await page.locator('.finding').nth(2).click();
  assert.equal(await overlap.getAttribute('aria-pressed'), 'false');
  assert.match(await textOf(page, '#selection-text'), /^Island 3: /);
  await page.locator('.finding').nth(2).click();
  await page.locator('#selection').waitFor({ state: 'hidden' });
  await overlap.click();
  await page.keyboard.press('Escape');
  assert.equal(await overlap.getAttribute('aria-pressed'), 'false', 'nothing is selected');
});

test('what is outlined is seen in the layout, until nothing is chosen', async (t) => {
  const page = await openUvs(t, RECTANGLES, { deviceScaleFactor: 1 });
  await openTab(page);
  await page.click('#verify');
  await judged(page);
  await page.locator('.finding').first().click();
  const chosen = await page.locator('#layout-canvas').screenshot();
  await page.locator('.finding').first().click();
  await page.locator('#selection').waitFor({ state: 'hidden' });
  const left = await page.locator('#layout-canvas').screenshot();
  assert.notDeepEqual(chosen, left);
});

test('rules that change are judged at once, and what is allowed is no finding', async (t) => {
  const page = await openUvs(t, RECTANGLES);
  await openTab(page);
  await page.click('#verify');
  await judged(page);
  await page.getByRole('button', { name: 'Mirrored', exact: true }).click();
  await page.locator('.verify-verdict').getByText('Not valid: 2 findings').waitFor();
  await page.getByRole('button', { name: 'Outside', exact: true }).click();
  await page
    .locator('.verify-verdict')
    .getByText('Not valid: 1 finding', { exact: true })
    .waitFor();
  await page.fill('#verify-maxStretch', '1.5');
  await page.locator('.finding', { hasText: 'Stretched' }).first().waitFor();
  await page.fill('#verify-maxStretch', '');
  await page
    .locator('.verify-verdict')
    .getByText('Not valid: 1 finding', { exact: true })
    .waitFor();
});

test('the report that is saved is that of the program', async (t) => {
  const page = await openUvs(t, RECTANGLES);
  await openTab(page);
  await page.fill('#verify-padding', '3');
  await page.click('#verify');
  await judged(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#verify-save')]);
  assert.equal(download.suggestedFilename(), 'squares-verify.json');
  const saved = JSON.parse(readFileSync(await pathOf(download), 'utf8'));
  const at = tempFolder(t);
  writeFileSync(at('squares.obj'), squares(RECTANGLES));
  await runAbflat(['verify', 'squares.obj', '--padding', '3', '--report', 'r.json', '-q'], {
    cwd: at(),
  });
  const native = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  const comparable = ({ timings, input, ...report }) => report;
  assert.deepEqual(comparable(saved), comparable(native));
});

test('an atlas that was just made is valid, and its islands have the numbers of the page', async (t) => {
  const page = await openPage(t, { open: ['cube.obj', CUBE] });
  await openTab(page);
  await page.fill('#verify-padding', '2');
  await page.click('#verify');
  assert.deepEqual(await judged(page), []);
  assert.match(await verdict(page), /^Valid: \d+ islands?, nothing found$/);
  await page.fill('#verify-padding', '');
  await dropAndWait(page, 'squares.obj', squares(RECTANGLES));
  assert.equal(await verdict(page), '', 'of another mesh nothing is known yet');
  await page.fill('#verify-padding', '900');
  await page.click('#verify');
  const found = await judged(page);
  assert.ok(found.length > 0);
  for (const [name, detail] of found) {
    assert.equal(name, 'Too near');
    assert.match(detail, /^Islands \d and \d: [\d.]+\u202fpx, asked for 900\u202fpx$/);
  }
  const [, first] = found[0][1].match(/^Islands (\d)/);
  await page.locator('.finding').first().click();
  assert.match(await textOf(page, '#selection-text'), /^2 islands: /);
  await page.click('#tab-charts');
  const marked = await page
    .locator('#charts tbody tr[aria-selected="true"]')
    .evaluateAll((rows) => rows.map((row) => row.dataset.chart));
  assert.ok(marked.includes(first), `${marked}`);
});

test('in one piece there is nothing to verify; another layout is judged anew', async (t) => {
  const page = await openUvs(t, RECTANGLES);
  await openTab(page);
  await page.click('#verify');
  await judged(page);
  await page.click('#pack-islands');
  await changed(page, 'Repacked in');
  assert.equal(await verdict(page), '');
  await page.click('#verify');
  assert.deepEqual(await judged(page), [['Turned over', '1 face of island 2']]);
  await choose(page, 'unwrap');
  assert.equal(await verdict(page), '');
  await page.click('#verify');
  assert.deepEqual(await judged(page), []);
});

test('the tab fits a phone, and axe finds nothing in it', async (t) => {
  const page = await openUvs(t, RECTANGLES, {
    viewport: { width: 360, height: 740 },
    hasTouch: true,
  });
  await openTab(page);
  await page.click('#verify');
  await judged(page);
  await page.locator('.finding').first().click();
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 360, `${width}`);
  await page.evaluate(axe.source);
  for (let i = 0; i < 2; ++i) {
    const found = await page.evaluate(async () => {
      const { violations } = await globalThis.axe.run(document.querySelector('#panel-verify'));
      return violations.map(({ id }) => id);
    });
    assert.deepEqual(found, []);
    await page.evaluate(() => document.querySelector('#theme').click());
  }
});
