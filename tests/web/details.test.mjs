// The pane beside the layout: how the layout was found, and what other values of t would give.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import { grid } from '../support/small-meshes.mjs';
import { dropAndWait, metrics, openPage, openSample, settled, textOf } from './page.mjs';

/** Cells of a chart's hidden table, without its head. */
const tableOf = (page, chart) =>
  page
    .locator(`${chart} table tr:not(:first-of-type)`)
    .evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));

const focused = (page) => page.evaluate(() => document.activeElement.id);

async function openSweep(page) {
  await page.click('#details-toggle');
  await page.click('#tab-sweep');
}

const sweepEnded = (page) =>
  page.waitForFunction(() => document.querySelector('#sweep').textContent === 'Plot against t');

/** The chart is drawn a moment after its last point is known; its table has a row of headings. */
const allDrawn = (page) =>
  page.waitForFunction(() => document.querySelectorAll('#sweep-chart table tr').length === 11);

test('the pane opens and closes; its tabs answer to arrow keys', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(6)] });
  assert.ok(await page.isHidden('#details'));
  await page.click('#details-toggle');
  assert.ok(await page.isVisible('#details'));
  assert.equal(await page.getAttribute('#details-toggle', 'aria-expanded'), 'true');
  assert.ok(await page.isVisible('#panel-solver'));
  await page.focus('#tab-solver');
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(page), 'tab-sweep');
  assert.equal(await page.getAttribute('#tab-sweep', 'aria-selected'), 'true');
  assert.ok(await page.isVisible('#panel-sweep'));
  assert.ok(await page.isHidden('#panel-solver'));
  await page.click('#details-close');
  assert.ok(await page.isHidden('#details'));
  assert.equal(await focused(page), 'details-toggle');
});

test('convergence: every step has its values, which are read out', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.fill('#t-number', '1');
  await settled(page);
  await page.click('#details-toggle');
  const rows = await tableOf(page, '#residual-chart');
  const steps = Number((await metrics(page))['Newton steps']);
  assert.ok(steps > 3);
  assert.ok(Math.abs(rows.length - steps) <= 1, `${rows.length} rows, ${steps} steps`);
  const [first, last] = [rows[0], rows.at(-1)].map((row) => Number(row[1]));
  assert.ok(last < 1e-6 * first, 'the residual falls');
  assert.match(await textOf(page, '#solver-summary'), /^Active set.*converged to/);

  const columns = page.locator('#residual-chart .chart-column');
  // Drawn in the frame after the pane has opened.
  await columns.first().waitFor({ state: 'attached' });
  assert.equal(await columns.count(), rows.length);
  await columns.nth(1).hover();
  assert.match(await textOf(page, '#solver-readout'), /^Step 2: /);
  assert.ok((await textOf(page, '#solver-readout')).includes(rows[1][1]));
  await page.mouse.move(0, 0);
  await columns.first().focus();
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowLeft');
  assert.match(await textOf(page, '#solver-readout'), new RegExp(`^Step ${rows.length - 1}: `));
  const active = await tableOf(page, '#active-chart');
  assert.equal(active.length, rows.length);
  assert.ok(Number(active.at(-1)[1]) > 0, 'a convex boundary holds vertices at their bound');
});

test('what was done beyond the plain solver is noted', { skip: withoutShared }, async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  assert.ok(await page.isHidden('#notes-button'));
  await page.fill('#t-number', '1');
  await settled(page);
  await page.setInputFiles('#file', sharedMesh('camel-cut.obj'));
  await page.waitForFunction(
    () => document.querySelector('#source').textContent === 'camel-cut.obj',
  );
  await settled(page);
  await page.click('#notes-button');
  assert.equal(await focused(page), 'tab-solver');
  assert.match(await textOf(page, '#notes'), /interior point/i);
});

test('a result that is not valid says why in full', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await openSample(page, 'alpha-band');
  await page.fill('#t-number', '2');
  await settled(page);
  assert.equal(await textOf(page, '#notes-button'), '1 note');
  await page.click('#notes-button');
  assert.equal(await textOf(page, '#notes'), `${await textOf(page, '#reason')}.`);
  assert.match(await textOf(page, '#notes'), /^The boundary crosses itself/);
});

test('distortion against t: point by point, valid and not, a point selects its t', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await openSample(page, 'alpha-band');
  await openSweep(page);
  await page.click('#sweep');
  await page.waitForFunction(() => document.querySelector('#sweep-chart .chart-mark'));
  await sweepEnded(page);
  await allDrawn(page);
  const rows = await tableOf(page, '#sweep-chart');
  assert.deepEqual(
    rows.map(([bound]) => bound),
    ['auto', '2', '1.8', '1.6', '1.4', '1.2', '1.1', '1.05', '1', '0.98'],
  );
  const possible = rows.filter(([, distortion]) => distortion !== 'not possible');
  const valid = possible.filter((row) => row[2] === 'yes' && row[0] !== 'auto');
  const counted = (shape) => page.locator(`#sweep-chart .chart-picture .${shape}`).count();
  assert.equal(await counted('filled'), valid.length);
  assert.equal(await counted('hollow'), possible.length - valid.length - 1);
  assert.equal(await counted('diamond'), 1);
  assert.ok(valid.length > 0 && valid.length < possible.length - 1, 'both kinds are there');

  const convex = rows.find(([bound]) => bound === '1');
  await page.click(`#sweep-chart [aria-label^="t = 1:"]`);
  await settled(page);
  assert.equal(await textOf(page, '#layout-info'), 't = 1');
  assert.equal(await page.inputValue('#t-number'), '1');
  assert.equal((await metrics(page))['Angular distortion'], convex[1]);
  await page.locator('#sweep-chart [aria-label^="t = auto:"]').focus();
  await page.keyboard.press('Enter');
  await settled(page);
  assert.match(await textOf(page, '#layout-info'), /^t = auto/);
  assert.equal((await metrics(page))['Angular distortion'], rows[0][1]);
  assert.equal((await tableOf(page, '#sweep-chart')).length, rows.length, 'the points stay');

  await openSample(page, 'head');
  assert.deepEqual(await tableOf(page, '#sweep-chart'), [], 'they belong to their mesh');
});

test('a sweep can be stopped, and gives way to the run the user asks for', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  // So large that its ten points take far longer than what is done here in the meantime.
  await dropAndWait(page, 'large.obj', grid(150));
  await openSweep(page);
  await page.click('#sweep');
  await page.focus('#t');
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  assert.equal(await textOf(page, '#layout-info'), 't = 1.99');
  assert.equal(await textOf(page, '#sweep'), 'Stop', 'it goes on');
  await page.keyboard.press('Escape');
  await sweepEnded(page);
  assert.equal(await textOf(page, '#sweep-text'), 'Stopped');
  const points = (await tableOf(page, '#sweep-chart')).length;
  assert.ok(points < 10);

  await page.click('#sweep');
  await sweepEnded(page);
  await allDrawn(page);
});
