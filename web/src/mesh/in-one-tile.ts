/** Coordinates of an atlas, moved by whole tiles and made smaller by a power of two, so that all lie in the first tile. */
export function inOneTile(uv: Float64Array): Float64Array {
  const low = [0, 0];
  let high = 0;
  uv.forEach((x, i) => {
    low[i % 2] = Math.min(low[i % 2], Math.floor(x));
  });
  uv.forEach((x, i) => {
    high = Math.max(high, x - low[i % 2]);
  });
  const scale = 2 ** -Math.ceil(Math.log2(Math.max(1, high)));
  return uv.map((x, i) => scale * (x - low[i % 2]));
}
