// Meshes and images to bake.

import { imageOf, waves } from '../../support/made-images.mjs';
import { parsePng } from '../../support/png.mjs';

export { imageOf, waves };

export const oneColour = (...colour) => imageOf(4, 4, () => colour);

/** A square in the plane z = 0 whose texcoords, v upwards, fill the image. */
export const SQUARE = {
  positions: new Float64Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
  indices: new Uint32Array([0, 1, 2, 0, 2, 3]),
  texcoords: new Float64Array([0, 0, 1, 0, 1, 1, 0, 1]),
  normals: new Float64Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]),
};

/** uv turned about the centre of the image, counter-clockwise, and scaled. */
export function turnedUv(uv, degrees, scale = 1) {
  const [c, s] = [Math.cos, Math.sin].map((of) => of((degrees * Math.PI) / 180));
  return new Float64Array(uv.length).map((_, i) => {
    const [x, y] = [uv[i - (i % 2)] - 0.5, uv[i - (i % 2) + 1] - 0.5];
    return 0.5 + scale * (i % 2 === 0 ? c * x - s * y : s * x + c * y);
  });
}

export const pixelOf = ({ data, width }, x, y) => [
  ...data.subarray(4 * (y * width + x), 4 * (y * width + x + 1)),
];

/** For `bake.decode`: PNG files of 8 bits. */
export function decodePng({ bytes }) {
  const { width, height, channels, at } = parsePng(Buffer.from(bytes));
  return imageOf(width, height, (x, y) => {
    const pixel = at(x, y);
    return channels < 3 ? [pixel[0], pixel[0], pixel[0]] : pixel;
  });
}

/** The largest difference of numbers at the same place. */
export function mostDifference(a, b) {
  let most = 0;
  for (let i = 0; i < a.length; ++i) most = Math.max(most, Math.abs(a[i] - b[i]));
  return most;
}
