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

/** Where the layout shows a point of the unit square, once it is fitted: that of an atlas is a little below the middle. */
export async function pixelOf(page, [u, v]) {
  const { x, y, width, height } = await page.locator('#layout-canvas').boundingBox();
  const isAtlas = (await page.getAttribute('body', 'data-mode')) === 'unwrap';
  const margin = Math.min(28, width / 14, height / 14);
  const side = Math.min(width - 2 * margin, height - 2 * margin);
  const lower = isAtlas ? (5 / 7) * margin : 0;
  return [x + width / 2 + (u - 0.5) * side, y + height / 2 + lower - (v - 0.5) * side, side];
}

export const middleOf = (corners) =>
  [0, 1].map((d) => corners.reduce((sum, corner) => sum + corner[d], 0) / corners.length);
