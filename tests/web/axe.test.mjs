// axe-core finds nothing wrong with contrasts, names, roles and labels, in either theme.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import axe from 'axe-core';
import { paintedCube } from '../support/painted-cube.mjs';
import { CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { drop, dropAndWait, openPage, openSample, settled } from './page.mjs';

/** Violations by rule, with the place and the problem. */
async function findings(page) {
  return page.evaluate(async () => {
    const { violations } = await globalThis.axe.run(document, {
      rules: { 'label-content-name-mismatch': { enabled: true } },
    });
    return violations.flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id}: ${target}: ${failureSummary}`),
    );
  });
}

async function openWithAxe(t, mode) {
  const page = await openPage(t, { mode });
  await page.evaluate(axe.source);
  return page;
}

async function assertNothingFound(page, what) {
  await page.mouse.move(0, 0);
  for (let i = 0; i < 2; ++i) {
    const theme = await page.evaluate(() => document.documentElement.dataset.theme);
    assert.deepEqual(await findings(page), [], `${what}, ${theme}`);
    // By script, so that what is open stays open.
    await page.evaluate(() => document.querySelector('#theme').click());
  }
}

test('axe finds nothing in a flattened mesh and its details', async (t) => {
  const page = await openWithAxe(t, 'flatten');
  await assertNothingFound(page, 'flattened');
  await page.click('#details-toggle');
  await page.selectOption('#shading', 'angle');
  await assertNothingFound(page, 'details');
  await page.click('#tab-methods');
  await page.click('#compare');
  await page.waitForFunction(() => document.querySelector('.method-table'));
  await page.locator('.method-name').nth(1).click();
  await page.locator('#method-note').waitFor();
  await assertNothingFound(page, 'methods');
});

test('axe finds nothing in an atlas, its options and its charts', async (t) => {
  const page = await openWithAxe(t);
  await dropAndWait(page, 'cube.obj', CUBE_OF_PARTS);
  for (const id of ['#seams-uv', '#seams-sharp', '#more-toggle']) await page.click(id);
  await page.click('#more-straight-seams');
  await settled(page);
  await page.click('#details-toggle');
  await page.locator('.lock').first().click();
  await assertNothingFound(page, 'atlas');
});

test('axe finds nothing in a message and in a layout that is not valid', async (t) => {
  const page = await openWithAxe(t, 'flatten');
  await openSample(page, 'alpha-band');
  await page.fill('#t-number', '2');
  await settled(page);
  await drop(page, 'nothing.obj', 'v 0 0 0\n');
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  await settled(page);
  await assertNothingFound(page, 'message');
});

test('axe finds nothing in the menu of formats and in the sheet of keys', async (t) => {
  const page = await openWithAxe(t);
  await dropAndWait(page, 'cube.glb', paintedCube());
  await page.click('#export-formats');
  await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).click();
  await assertNothingFound(page, 'menu');
  await page.keyboard.press('Escape');
  await page.click('#select-charts');
  await assertNothingFound(page, 'selecting');
  await page.keyboard.press('Escape');
  await page.click('#help');
  await assertNothingFound(page, 'sheet');
});
