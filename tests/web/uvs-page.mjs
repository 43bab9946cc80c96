// The page with the UVs of a file on screen, whose islands can be selected.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { parseObj } from '../support/atlas.mjs';
import { middleOf, pixelOf } from './layout.mjs';
import { choose, exportMesh, openPage, settled } from './page.mjs';
import { CORNERS, squares } from './squares.mjs';

/** Opens squares with these rectangles in uv. */
export async function openUvs(t, rectangles, options = {}) {
  const page = await openPage(t, { open: ['squares.obj', squares(rectangles)], ...options });
  await choose(page, 'pack');
  await layoutReady(page);
  return page;
}

/** Islands can be selected once they are told apart, and all keys work once the rest is loaded. */
export async function layoutReady(page) {
  await page.locator('#select-charts').waitFor();
  await page.locator('#layout-canvas').focus();
  await page.waitForFunction(() => {
    const canvas = document.querySelector('#layout-canvas');
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'a', bubbles: true }));
    return !document.querySelector('#selection').hidden;
  });
  await page.keyboard.press('Alt+a');
  await page.locator('#selection').waitFor({ state: 'hidden' });
}

/** The corners in uv of each face of the export. */
export async function exported(page) {
  const { path } = await exportMesh(page);
  const { texcoords, faces } = parseObj(readFileSync(path, 'utf8'));
  return faces.map((face) => face.map(([, t]) => texcoords[t]));
}

/** The corners of a rectangle. */
export const squareOf = ([u, v, width, height]) =>
  CORNERS.map(([x, y]) => [u + x * width, v + y * height]);

/** Clicks the island with this rectangle. */
export async function select(page, rectangle, options = {}) {
  const [x, y] = await pixelOf(page, middleOf(squareOf(rectangle)));
  await page.mouse.click(x, y, options);
}

/** By an entry of the menu Select…. */
export async function selectBy(page, how) {
  await page.click('#select-charts');
  await page.locator(`#select-menu [data-value="${how}"]`).click();
}

/** Twice the area of a corner; negative if it is mirrored. */
export const turnOf = ([a, b, c]) => (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);

export function assertNear(found, wanted, what) {
  const [now, then] = [found, wanted].map((all) => all.flat(Infinity));
  assert.equal(now.length, then.length);
  for (const [i, x] of now.entries())
    assert.ok(Math.abs(x - then[i]) < 1e-6, `${what}: ${x}, not ${then[i]}`);
}

/** Waits until the last run begins to say so. */
export const changed = async (page, what) => {
  await page.waitForFunction(
    (what) => document.querySelector('#run-text').textContent.startsWith(what),
    what,
  );
  await settled(page);
};
