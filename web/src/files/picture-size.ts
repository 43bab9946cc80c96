import { tileGrid } from '../mesh/tiles';
import { ATLAS_PICTURE } from '../words/exported';
import type { AtlasDrawing } from './svg-text';

/** The most pixels that browsers draw along a side. */
export const MOST_PIXELS = 16_384;

/** Size of the picture in pixels, or why there can be none. */
export function pictureSize({ resolution, tiles }: AtlasDrawing): {
  width: number;
  height: number;
} {
  const [columns, rows] = tileGrid(tiles);
  const [width, height] = [resolution * columns, resolution * rows];
  if (Math.max(width, height) > MOST_PIXELS) throw new Error(ATLAS_PICTURE.tooLarge(MOST_PIXELS));
  return { width, height };
}
