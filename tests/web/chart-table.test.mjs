// The table of charts in the details.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText, sphere } from '../support/surfaces.mjs';
import { openPage, settled } from './page.mjs';
import { CANVAS, charts, drawn, SMALL } from './seam-page.mjs';

test('the table of charts: sorted by any column, and its charts are shown', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['ball.obj', objText(sphere(12))] });
  await page.click('#seams-sharp');
  await page.fill('#sharp-degrees', '9');
  await settled(page);
  const count = await charts(page);
  assert.ok(count > 2, `${count} charts`);
  await page.click('#details-toggle');
  const column = (i) =>
    page
      .locator(`#charts tbody tr > :nth-child(${i})`)
      .evaluateAll((cells) =>
        cells.map((cell) => Number.parseFloat(cell.textContent.replaceAll(',', ''))),
      );
  assert.equal((await column(1)).length, Math.min(200, count));
  const isSorted = (values, sign) =>
    values.every((x, i) => i === 0 || sign * (x - values[i - 1]) >= 0);
  assert.ok(isSorted(await column(2), -1), 'by faces, the most first');
  for (const [name, at] of [
    ['Area', 3],
    ['Stretch', 4],
    ['Angle', 5],
  ]) {
    const header = page.locator('#charts th').filter({ hasText: name });
    await header.locator('button').click();
    assert.equal(await header.getAttribute('aria-sort'), 'descending');
    assert.ok(isSorted(await column(at), -1), name);
    await header.locator('button').click();
    assert.equal(await header.getAttribute('aria-sort'), 'ascending');
    assert.ok(isSorted(await column(at), 1), name);
  }
  const pictures = async () => {
    await drawn(page);
    return [
      await page.locator(CANVAS).screenshot(),
      await page.locator('#layout-canvas').screenshot(),
    ];
  };
  await page.mouse.move(0, 0);
  const plain = await pictures();
  await page.locator('#charts .chart-name').first().focus();
  const lit = await pictures();
  plain.forEach((picture, i) => {
    assert.notDeepEqual(lit[i], picture);
  });
  await page.focus('#tab-charts');
  assert.deepEqual(await pictures(), plain);
  await page.locator('#charts .chart-name').first().focus();
  await page.keyboard.press('Enter');
  const close = await pictures();
  close.forEach((picture, i) => {
    assert.notDeepEqual(picture, lit[i]);
  });
});
