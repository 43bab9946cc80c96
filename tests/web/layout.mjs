// What the layout view shows, and where.

import { readFileSync } from 'node:fs';
import { chartsOf, parseObj } from '../support/atlas.mjs';
import { exportMesh } from './page.mjs';

/** The corners in uv of each exported face, and the chart of each. Then the layout has the focus. */
export async function atlas(page) {
  const { path } = await exportMesh(page);
  await page.focus('#layout-canvas');
  const obj = parseObj(readFileSync(path, 'utf8'));
  const { ofFace } = chartsOf(obj);
  return { ofFace, uv: obj.faces.map((face) => face.map(([, t]) => obj.texcoords[t])) };
}

/** Where the layout shows a point of the unit square, once it is fitted: an atlas leaves room for a bar. */
export async function pixelOf(page, [u, v]) {
  const { x, y, width, height } = await page.locator('#layout-canvas').boundingBox();
  const isAtlas = (await page.getAttribute('body', 'data-mode')) !== 'flatten';
  const margin = isAtlas ? 8 : Math.min(28, width / 14, height / 14);
  const above = await page
    .locator('#layout-canvas')
    .evaluate((canvas) => Number.parseFloat(getComputedStyle(canvas).getPropertyValue('--above')));
  const top = isAtlas ? above : margin;
  const side = Math.min(width - 2 * margin, height - top - margin);
  const middle = y + (top + height - margin) / 2;
  return [x + width / 2 + (u - 0.5) * side, middle - (v - 0.5) * side, side];
}

export const middleOf = (corners) =>
  [0, 1].map((d) => corners.reduce((sum, corner) => sum + corner[d], 0) / corners.length);

/** Whether a part of the page has a single colour. */
export async function isPlain(page, clip) {
  const png = [...(await page.screenshot({ clip }))];
  return page.evaluate(async (png) => {
    const picture = await createImageBitmap(new Blob([Uint8Array.from(png)]));
    const { width, height } = picture;
    const copy = new OffscreenCanvas(width, height).getContext('2d');
    copy.drawImage(picture, 0, 0);
    const pixels = new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer);
    return pixels.every((pixel) => pixel === pixels[0]);
  }, png);
}

/** Moves, turns or scales all charts that may be moved: `key` and the number that follows it. */
export async function arrangeAll(page, key, number) {
  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  await page.keyboard.press(key);
  await page.keyboard.type(number);
  await page.keyboard.press('Enter');
}
