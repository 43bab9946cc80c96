import type { Texture } from 'three';
import { GRID } from '../words/view';
import { uvPicture } from './uv-picture';

/** Cells along a side of the unit square of uv. */
export const CELLS = 8;
/** Pixels along a side of a cell. */
const CELL = 128;

/** Numbered cells, each with its own colour and an upright label: a part that is turned, mirrored or stretched shows it. */
export const gridPicture = (): Texture => uvPicture(drawGrid());

function drawGrid(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = CELLS * CELL;
  const context = canvas.getContext('2d');
  if (!context) throw new Error(GRID.notDrawn);
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.font = `600 ${0.42 * CELL}px system-ui, sans-serif`;
  for (let row = 0; row < CELLS; ++row)
    for (let column = 0; column < CELLS; ++column) drawCell(context, row, column);
  return canvas;
}

/** Rows count from the bottom, as v does. */
function drawCell(context: CanvasRenderingContext2D, row: number, column: number): void {
  const [x, y] = [column * CELL, (CELLS - 1 - row) * CELL];
  const hue = (360 * (column + row / 2)) / CELLS;
  const lightness = (row + column) % 2 === 0 ? 62 : 80;
  context.fillStyle = `hsl(${hue} 55% ${lightness}%)`;
  context.fillRect(x, y, CELL, CELL);
  context.fillStyle = 'rgb(20 24 30 / 80%)';
  context.fillText(`${'ABCDEFGH'[column]}${row + 1}`, x + CELL / 2, y + CELL / 2);
}
