/** Coordinates scaled and moved into the unit square, keeping their proportions. */
export function normalized(uv: Float64Array): Float32Array<ArrayBuffer> {
  const least = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const most = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
  uv.forEach((value, i) => {
    least[i % 2] = Math.min(least[i % 2], value);
    most[i % 2] = Math.max(most[i % 2], value);
  });
  const extent = Math.max(most[0] - least[0], most[1] - least[1]);
  return Float32Array.from(uv, (value, i) => (value - least[i % 2]) / extent);
}
