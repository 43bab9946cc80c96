// Locked charts stay where they are while everything else changes.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { chartsOf, parseObj } from '../support/atlas.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { arrangeAll } from './layout.mjs';
import { loadModule } from './modules.mjs';
import { dropAndWait, exportMesh, metrics, openPage, settled, textOf } from './page.mjs';

const BOTH = objText(
  together([
    [torus(24, 12), [0, 0, 0]],
    [sphere(6), [3, 0, 0]],
  ]),
);

/** The corners in uv of each exported face. */
async function atlas(page) {
  const { path } = await exportMesh(page);
  const text = readFileSync(path, 'utf8');
  const obj = parseObj(text);
  return { text, obj, uv: obj.faces.map((face) => face.map(([, t]) => obj.texcoords[t])) };
}

const lock = (page, row) => page.locator('#charts tbody tr').nth(row).locator('.lock');

test('a locked island stays bit by bit until it is unlocked', async (t) => {
  const page = await openPage(t, { open: ['both.obj', BOTH] });
  await page.click('#details-toggle');
  const before = await atlas(page);
  // The first row is the chart with the most faces.
  const { ofFace: chartOf } = chartsOf(before.obj);
  const sizes = new Map();
  for (const chart of chartOf) sizes.set(chart, (sizes.get(chart) ?? 0) + 1);
  const [largest] = [...sizes].sort((a, b) => b[1] - a[1])[0];
  await lock(page, 0).focus();
  await page.keyboard.press('Enter');
  assert.equal(await lock(page, 0).getAttribute('aria-pressed'), 'true');
  assert.equal(await textOf(page, '#locks-summary'), '1 island locked');
  assert.equal((await atlas(page)).text, before.text, 'locking moves nothing');

  const isSame = (after, f) => JSON.stringify(after.uv[f]) === JSON.stringify(before.uv[f]);
  const checkStays = async (what) => {
    const after = await atlas(page);
    chartOf.forEach((chart, f) => {
      if (chart === largest) assert.ok(isSame(after, f), `${what}: face ${f} stays`);
    });
    assert.ok(!after.uv.every((_, f) => isSame(after, f)), `${what}: others change`);
    // Not every option keeps this limit.
    assert.match(await textOf(page, '#badge'), /^(Valid|Stretched)$/);
    assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 1);
  };
  await page.focus('#stretch');
  await page.keyboard.press('Home');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /1 (of \d+ islands )?locked$/);
  await checkStays('less stretch');
  await page.click('#seams-sharp');
  await settled(page);
  await checkStays('sharp seams');
  await page.click('#more-toggle');
  await page.click('#more-straight-seams');
  await settled(page);
  await checkStays('straight seams');

  await page.locator('.lock[aria-pressed="true"]').click();
  assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 0);
  await page.click('#pack-again');
  await settled(page);
  const packed = await atlas(page);
  const ofLargest = [...chartOf.keys()].filter((f) => chartOf[f] === largest);
  assert.ok(!ofLargest.every((f) => isSame(packed, f)), 'it moves');
  const { ofFace } = chartsOf(packed.obj);
  assert.equal(new Set(ofLargest.map((f) => ofFace[f])).size, 1, 'but is cut no further');
  // Only another layout cuts it as the options say.
  await page.focus('#stretch');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Home');
  await settled(page);
  const path = tempFolder(t);
  writeFileSync(path('in.obj'), BOTH);
  const { code, stderr } = await runAbflat([
    ...['unwrap', path('in.obj'), '-o', path('out.obj'), '--max-stretch', '1.005'],
    ...['--seams', 'auto,sharp=60', '--straight-seams'],
  ]);
  assert.equal(code, 0, stderr);
  assert.equal(
    (await atlas(page)).text,
    readFileSync(path('out.obj'), 'utf8'),
    'as if never locked',
  );
});

test('locks belong to one mesh', async (t) => {
  const page = await openPage(t, { open: ['both.obj', BOTH] });
  await page.click('#details-toggle');
  await lock(page, 0).click();
  const charts = (await metrics(page)).Islands;
  await dropAndWait(page, 'again.obj', BOTH);
  assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 0);
  assert.equal((await metrics(page)).Islands, charts);
  for (const button of await page.locator('.lock').all())
    assert.match(await button.getAttribute('aria-label'), /^Lock island \d+$/);
});

/** Squares in a row; all but the last have uv, a quarter as wide as the tile. */
const ROW = [0, 1, 2]
  .flatMap((i) => [
    ...[0, 2].flatMap((y) => [`v ${3 * i} ${y} 0`, `v ${3 * i + 2} ${y} 0`]),
    ...(i < 2
      ? [0.25, 0.5].flatMap((v) => [`vt ${0.4 * i} ${v}`, `vt ${0.4 * i + 0.25} ${v}`])
      : []),
    `f ${[1, 2, 4, 3].map((k) => `${4 * i + k}${i < 2 ? `/${4 * i + k}` : ''}`).join(' ')}`,
  ])
  .join('\n');

test('islands that keep the uv of the file are locked: nothing is said to move them', async (t) => {
  const page = await openPage(t, { open: ['row.obj', ROW] });
  await page.click('#more-toggle');
  await page.click('#more-keep-uv');
  await settled(page);
  const before = await atlas(page);
  const undone = await page.getAttribute('#undo', 'title');
  await page.click('#details-toggle');
  assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 2);
  assert.equal(await textOf(page, '#locks-summary'), '2 islands keep their UVs');
  const first = page.locator('.lock[aria-pressed="true"]').first();
  await first.focus();
  await page.keyboard.press('Enter');
  assert.match(await textOf(page, '#run-text'), /^Kept UVs stay in place; switch Keep UVs off/);
  assert.equal(await first.getAttribute('aria-pressed'), 'true');
  await page.click(`tr[data-chart="${await first.getAttribute('data-chart')}"] .chart-name`);
  assert.ok(await page.isHidden('#selection-density'));
  for (const how of ['scale', 'left', 'stacked']) {
    await page.click('#selection-arrange');
    await page.click(`#arrange-menu [data-value="${how}"]`);
    await settled(page);
    assert.match(await textOf(page, '#run-text'), /^Kept UVs stay in place; switch Keep UVs off/);
  }
  assert.equal(await page.getAttribute('#undo', 'title'), undone, 'no step to undo');
  assert.equal((await atlas(page)).text, before.text);

  // Of all charts, the one that is new moves.
  await arrangeAll(page, 's', '.5');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Scaled island \d+, checked in/);
  const after = await atlas(page);
  const width = (face) => Math.max(...face.map(([u]) => u)) - Math.min(...face.map(([u]) => u));
  assert.deepEqual(after.uv.slice(0, 2), before.uv.slice(0, 2));
  assert.ok(Math.abs(width(after.uv[2]) / width(before.uv[2]) - 0.5) < 1e-3);
});

test('what is locked while a run is under way is kept by the next one', async () => {
  const { Locks } = await loadModule('details/locks');
  /** A result with one triangle per chart, or as many as `chartOfTriangle` says. */
  const result = (fixed, chartOfTriangle = fixed.map((_, i) => i)) => ({
    report: { charts: fixed.map((fixed) => ({ fixed })) },
    chartOfTriangle: Uint32Array.from(chartOfTriangle),
  });
  const locks = new Locks();
  const first = result([false, false, false]);
  const shown = (result, kept, fixedFaces) =>
    locks.show({ result, settings: { kept, fixedFaces } });
  shown(first, locks.kept);
  assert.deepEqual([...locks.kept.charts], []);
  locks.toggle(2);
  assert.deepEqual([...locks.charts], [2]);
  const asked = locks.kept;
  assert.equal(asked.layout, first);
  // During a run with these locks, another chart is locked; the result of the run only has one of
  // them.
  locks.toggle(0);
  const second = result([true, false, false], [1, 2, 0]);
  shown(second, asked);
  assert.deepEqual([...locks.charts], [0], 'of what is on screen');
  assert.equal(locks.kept.layout, first);
  assert.deepEqual([...locks.kept.charts].sort(), [0, 2]);
  const third = result([false, true, true], [1, 0, 2]);
  shown(third, locks.kept);
  assert.equal(locks.kept.layout, third);
  assert.deepEqual([...locks.kept.charts], [1, 2]);
  // A chart that the file has uv for is also fixed, but not locked.
  const fourth = result([true, true, true], [1, 0, 2]);
  shown(fourth, locks.kept);
  assert.deepEqual([...locks.charts], [1, 2]);
  locks.toggle(1);
  locks.toggle(2);
  assert.deepEqual([...locks.charts], []);
  // With Keep UVs, such a chart stays as well.
  const fifth = result([true, true, false]);
  for (const chart of fifth.report.charts) chart.solver = chart.fixed ? 'given' : 'activeSet';
  locks.toggle(1);
  shown(fifth, locks.kept, 'uv');
  assert.deepEqual([...locks.charts], [0]);
  assert.deepEqual([...locks.keptUvs], [1]);
  assert.deepEqual([...locks.staying].sort(), [0, 1]);
  locks.toggle(1);
  assert.deepEqual([...locks.charts], [0], 'it has no lock of its own');
  locks.clear();
  assert.equal(locks.kept, undefined);
  assert.deepEqual([...locks.staying], []);
});
