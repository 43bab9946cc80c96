/** In css pixels: lines that are closer are not told apart. */
const LEAST_DISTANCE = 24;

/**
 * Texels from one line of a grid to the next: the least power of two that is far enough on screen,
 * or a whole tile. `resolution`: texels along a side of a tile, which has that many pixels.
 */
export function texelsBetween(resolution: number, pixels: number): number {
  let texels = 1;
  while (texels < resolution && texels * (pixels / resolution) < LEAST_DISTANCE) texels *= 2;
  return Math.min(texels, resolution);
}
