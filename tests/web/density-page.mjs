// Tiles whose texel densities can be told.

import assert from 'node:assert/strict';
import { objText, together } from '../support/surfaces.mjs';
import { atlas } from './layout.mjs';

/** A square that is a chart as it is. */
const TILE = {
  positions: [0, 1, 2, 3, 4, 5, 6, 7, 8].map((i) => [i % 3, Math.floor(i / 3), 0]),
  faces: [0, 1, 3, 4].map((i) => [i, i + 1, i + 4, i + 3]),
};
export const FACES = TILE.faces.length;
export const TILES = objText(together([0, 3, 6].map((x) => [TILE, [x, 0, 0]])));

const areaOf = (corners) =>
  corners.reduce((sum, [x1, y1], i) => {
    const [x2, y2] = corners[(i + 1) % corners.length];
    return sum + (x1 * y2 - x2 * y1) / 2;
  }, 0);

/** Of a face, beside that of the last one; charts are flat, so it is that of the whole chart. */
export const densityOf = ({ uv }, face) => Math.sqrt(areaOf(uv[face]) / areaOf(uv.at(-1)));

/** Of each tile, beside the first one. */
export async function tileDensities(page) {
  const now = await atlas(page);
  return [0, 1, 2].map((tile) => densityOf(now, FACES * tile) / densityOf(now, 0));
}

/** In the bar of what is selected. */
export const shownDensity = (page) => page.inputValue('#selection-density');

export function isNear(value, wanted) {
  assert.ok(Math.abs(value / wanted - 1) < 0.01, `${value} is ${wanted}`);
}
