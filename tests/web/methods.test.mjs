// The Delaunay condition, and the same mesh by other methods.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import { grid } from '../support/small-meshes.mjs';
import { drop, dropAndWait, exportMesh, metrics, openPage, settled, textOf } from './page.mjs';

/** In pixels: a pane's corners are round, and not always drawn alike to the last bit. */
const CORNER = 10;

async function picture(page, id) {
  const { x, y, width, height } = await page.locator(id).boundingBox();
  const inside = { width: width - 2 * CORNER, height: height - 2 * CORNER };
  return page.screenshot({ clip: { x: x + CORNER, y: y + CORNER, ...inside } });
}

const compared = (page) =>
  page.waitForFunction(() => document.querySelector('#compare').textContent === 'Compare methods');

async function compare(page) {
  await page.click('#details-toggle');
  await page.click('#tab-methods');
  await page.click('#compare');
  await compared(page);
  await page.waitForFunction(() => document.querySelector('.method-table'));
}

const rows = (page) =>
  page
    .locator('.method-table tbody tr')
    .evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.innerText)));

test('Delaunay changes the layout, says what it costs, and can be taken back', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(10)] });
  const before = await metrics(page);
  const plain = await picture(page, '#layout-canvas');
  await page.click('#delaunay');
  await settled(page);
  assert.equal(await page.getAttribute('#delaunay', 'aria-pressed'), 'true');
  const after = await metrics(page);
  const [from, to] = (await textOf(page, '#marks'))
    .match(/^Delaunay: distortion (\S+) → (\S+)$/)
    .slice(1);
  assert.equal(from, before['Angular distortion']);
  assert.equal(to, after['Angular distortion']);
  assert.ok(Number(to) > Number(from), 'a condition more costs distortion');
  assert.notDeepEqual(await picture(page, '#layout-canvas'), plain);
  await page.click('#notes-button');
  assert.match(await textOf(page, '#active-chart'), /Interior edges/);
  assert.match(await textOf(page, '#notes'), /^Edges that are not Delaunay: [1-9]\d* of .*, 0 now/);
  await page.click('#details-close');

  await page.click('#delaunay');
  await settled(page);
  assert.deepEqual(await metrics(page).then((now) => now['Angular distortion']), from);
  assert.ok(await page.isHidden('#marks'));
});

test('edges that resist the Delaunay condition are marked', { skip: withoutShared }, async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.fill('#t-number', '1');
  await settled(page);
  await page.setInputFiles('#file', sharedMesh('camel-cut.obj'));
  await page.waitForFunction(
    () => document.querySelector('#source').textContent === 'camel-cut.obj',
  );
  await settled(page);
  const plain = await picture(page, '#layout-canvas');
  await page.click('#delaunay');
  await settled(page);
  assert.match(await textOf(page, '#marks'), /^\d+ edges cannot be made Delaunay$/);
  assert.notDeepEqual(await picture(page, '#layout-canvas'), plain);
});

test('methods are compared; a selected one is shown, marked, and not exported', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(12)] });
  const { path } = await exportMesh(page);
  const exported = readFileSync(path, 'utf8');
  await compare(page);
  const table = await rows(page);
  assert.ok(table.length >= 6);
  const names = table.map(([name]) => name.replaceAll('\n', ', '));
  assert.ok(names.some((name) => /^LSCM/.test(name)) && names.some((name) => /^Tutte/.test(name)));
  for (const width of [1440, 1024]) {
    await page.setViewportSize({ width, height: 768 });
    const panel = page.locator('#panel-methods');
    assert.ok(
      await panel.evaluate((e) => e.scrollWidth <= e.clientWidth),
      `all columns at ${width}`,
    );
  }
  // abflat's own free layout changes angles least, since that is what it minimises.
  const angular = (pattern) => Number(table[names.findIndex((name) => pattern.test(name))][2]);
  assert.ok(angular(/^abflat.*free/) < angular(/^Tutte/));
  const shown = await metrics(page);

  const [layout, mesh] = [
    await picture(page, '#layout-canvas'),
    await picture(page, '#mesh-canvas'),
  ];
  await page.getByRole('button', { name: /^Tutte/ }).click();
  await page.locator('#method-note').waitFor();
  assert.match(await textOf(page, '#method-note-text'), /^Comparison, not exported: Tutte/);
  assert.match(await textOf(page, '#layout-info'), /^Tutte/);
  assert.equal(await textOf(page, '#reason'), "Figures of abflat's layout");
  assert.notDeepEqual(await picture(page, '#layout-canvas'), layout);
  assert.notDeepEqual(await picture(page, '#mesh-canvas'), mesh);
  assert.equal(readFileSync((await exportMesh(page)).path, 'utf8'), exported);

  await page.click('#method-back');
  assert.ok(await page.isHidden('#method-note'));
  assert.match(await textOf(page, '#layout-info'), /^t = auto/);
  assert.deepEqual(await metrics(page), shown);
  await page.locator('#layout-canvas').blur();
  assert.deepEqual(await picture(page, '#layout-canvas'), layout);
});

test('Escape, another tab, closing, another t and another mesh lead back from a method', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(6)] });
  await compare(page);
  const lscm = page.getByRole('button', { name: /^LSCM/ });
  const ways = {
    again: () => lscm.click(),
    escape: () => page.keyboard.press('Escape'),
    tab: () => page.click('#tab-solver'),
    close: () => page.click('#details-close'),
    t: () => page.fill('#t-number', '1.5'),
  };
  for (const [name, leave] of Object.entries(ways)) {
    if (await page.isHidden('#details')) await page.click('#details-toggle');
    await page.click('#tab-methods');
    await lscm.focus();
    await page.keyboard.press('Enter');
    await page.locator('#method-note').waitFor();
    assert.equal(await lscm.getAttribute('aria-pressed'), 'true');
    await leave();
    await settled(page);
    assert.ok(await page.isHidden('#method-note'), name);
    assert.match(await textOf(page, '#layout-info'), /^t = /, name);
  }
  await lscm.click();
  await dropAndWait(page, 'next.obj', grid(5));
  assert.ok(await page.isHidden('#method-note'));
  assert.deepEqual(await rows(page), [], 'a comparison belongs to its mesh');
});

test('a comparison can be stopped', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await drop(page, 'large.obj', grid(150));
  await page.waitForFunction(() => document.querySelector('#source').textContent === 'large.obj');
  await settled(page);
  await page.click('#details-toggle');
  await page.click('#tab-methods');
  await page.click('#compare');
  await page.click('#compare');
  await compared(page);
  assert.equal(await textOf(page, '#compare-text'), 'Stopped');
  assert.equal(await page.locator('.method-table').count(), 0);
  await dropAndWait(page, 'small.obj', grid(3));
  assert.equal(await textOf(page, '#badge'), 'Valid');
});
