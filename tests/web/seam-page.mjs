// Aiming at the mesh and its seams on the page.

import assert from 'node:assert/strict';
import { grid } from '../support/small-meshes.mjs';
import { metrics, openPage, textOf } from './page.mjs';

export const CANVAS = '#mesh-canvas';
/** A small view is drawn quickly. */
export const SMALL = { viewport: { width: 1040, height: 620 } };

/** n x n squares in the plane of the screen, each cut in two. */
export const flatGrid = (n) => grid(n).replace(/^(v \S+ \S+) \S+$/gm, '$1 0');

/** That grid, unwrapped. */
export const openGrid = (t, n, options = SMALL) =>
  openPage(t, { ...options, open: ['grid.obj', flatGrid(n)] });

export const charts = async (page) => Number((await metrics(page)).Islands);

const twoFrames = () =>
  new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
/** Waits until the effect of the pointer is on screen. */
export const drawn = (page) => page.evaluate(twoFrames);

export const hint = (page) => page.evaluate(() => document.querySelector('#seam-hint').textContent);

/** Moves the pointer to a place on the canvas, in fractions of its size; returns the hint. */
export async function point(page, x, y) {
  const box = await page.locator(CANVAS).boundingBox();
  await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
  await drawn(page);
  return hint(page);
}

/**
 * Where the mesh's vertices appear, as a Map from vertex to [x, y]. Found by pointing at the whole
 * canvas from inside the page, without a round trip to the browser per point.
 */
export async function vertices(page, steps = 12) {
  const found = await page.evaluate(async (steps) => {
    const canvas = document.querySelector('#mesh-canvas');
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const found = [];
    for (let i = 1; i < steps; ++i)
      for (let j = 1; j < steps; ++j) {
        const [x, y] = [i / steps, j / steps];
        const [clientX, clientY] = [left + x * width, top + y * height];
        const how = { clientX, clientY, pointerType: 'mouse', isPrimary: true };
        canvas.dispatchEvent(new PointerEvent('pointermove', { ...how, bubbles: true }));
        // The page responds earlier in the same frame.
        await new Promise((done) => requestAnimationFrame(done));
        const vertex = /^Vertex (\d+): start/.exec(
          document.querySelector('#seam-hint').textContent,
        );
        if (vertex) found.push([Number(vertex[1]), [x, y]]);
      }
    return found;
  }, steps);
  return new Map(found);
}

/** Clicks where the pointer is. */
export async function click(page) {
  await page.mouse.down();
  await page.mouse.up();
  await drawn(page);
}

export async function clickAt(page, [x, y]) {
  await point(page, x, y);
  await click(page);
}

export const edited = async (page) =>
  Number(
    /^seams edited: ([\d,]+) edge/.exec(await textOf(page, '#seams-state'))?.[1].replace(',', '') ??
      -1,
  );

/** A place on the canvas in pixels of the page. */
export async function pixelOf(page, [x, y]) {
  const box = await page.locator(CANVAS).boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}

/**
 * Points at places between two others until a double-click would cut a loop; returns the last place
 * and the hint.
 */
export async function pointAtLoop(page, [a, b], [c, d], steps = 40) {
  for (let i = 0; i <= steps; ++i) {
    const place = [a + ((c - a) * i) / steps, b + ((d - b) * i) / steps];
    const text = await point(page, ...place);
    if (/Double-(click|tap)/.test(text)) return { place, text };
  }
  throw new Error('There is no edge between these places.');
}

/** Moves the pointer to a seam between two vertices that were seen near these places. */
export async function pointAtSeam(page, [a, b], [c, d]) {
  const [x, y] = [(a + c) / 2, (b + d) / 2];
  for (const off of [0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5])
    if (/^Seam/.test(await point(page, x, y + off / 60))) return;
  assert.fail('there is no seam near');
}
