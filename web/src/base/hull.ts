/** Indices of the corners of the convex hull of points in the plane (Andrew's monotone chain). */
export function hull(x: Float64Array, y: Float64Array): number[] {
  const order = new Uint32Array(x.length);
  for (let i = 0; i < order.length; ++i) order[i] = i;
  order.sort((a, b) => x[a] - x[b] || y[a] - y[b]);
  const turn = (a: number, b: number, c: number) =>
    (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
  const half = (sign: number) => {
    const chain: number[] = [];
    for (let at = 0; at < order.length; ++at) {
      const i = order[at];
      while (
        chain.length > 1 &&
        sign * turn(chain[chain.length - 2], chain[chain.length - 1], i) <= 0
      )
        chain.pop();
      chain.push(i);
    }
    return chain;
  };
  return [...new Set([...half(1), ...half(-1)])];
}
