// Images as pixels, in rows from the top: red, green, blue and alpha.

/** An image of `at(x, y)`: three or four numbers of a pixel. */
export function imageOf(width, height, at) {
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const [red, green, blue, alpha = 255] = at(x, y);
      data.set([red, green, blue, alpha], 4 * (y * width + x));
    }
  return { data, width, height };
}

/** A smooth picture that goes on beyond its edges. */
export const waves = (width, height = width, phase = 0) =>
  imageOf(width, height, (x, y) =>
    [0, 1, 2].map((d) =>
      Math.round(
        128 +
          100 *
            Math.sin((4 * Math.PI * x) / width + 2 * d + phase) *
            Math.cos((2 * Math.PI * y) / height + d + phase),
      ),
    ),
  );
