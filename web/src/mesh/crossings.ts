/** Twice the signed area of the triangle (a, b, c); each is the index of a point in `p`, 2 coordinates a point. */
function turn(p: Float64Array, a: number, b: number, c: number): number {
  return (
    (p[2 * b] - p[2 * a]) * (p[2 * c + 1] - p[2 * a + 1]) -
    (p[2 * b + 1] - p[2 * a + 1]) * (p[2 * c] - p[2 * a])
  );
}

/**
 * Where the open segments (a, b) and (c, d) cross, or null. Rounded, so only for display: the
 * report decides what is valid.
 */
function crossing(p: Float64Array, [a, b, c, d]: number[]): [number, number] | null {
  if (a === c || a === d || b === c || b === d) return null;
  const [sideC, sideD] = [turn(p, a, b, c), turn(p, a, b, d)];
  const [sideA, sideB] = [turn(p, c, d, a), turn(p, c, d, b)];
  if (sideC * sideD >= 0 || sideA * sideB >= 0) return null;
  const s = sideA / (sideA - sideB);
  return [p[2 * a] + s * (p[2 * b] - p[2 * a]), p[2 * a + 1] + s * (p[2 * b + 1] - p[2 * a + 1])];
}

/**
 * Points where edges (pairs of vertices) cross in the plane, xy each, at most `most` of them.
 * Sweeps along x: an edge is compared only with those that begin before it ends.
 */
export function crossings(uv: Float64Array, edges: Uint32Array, most: number): Float64Array {
  const left = (e: number) => Math.min(uv[2 * edges[2 * e]], uv[2 * edges[2 * e + 1]]);
  const right = (e: number) => Math.max(uv[2 * edges[2 * e]], uv[2 * edges[2 * e + 1]]);
  const order = Array.from({ length: edges.length / 2 }, (_, e) => e);
  order.sort((e, g) => left(e) - left(g));
  const points: number[] = [];
  let open: number[] = [];
  for (const e of order) {
    open = open.filter((other) => right(other) >= left(e));
    for (const other of open) {
      const ends = [e, other].flatMap((each) => [edges[2 * each], edges[2 * each + 1]]);
      const point = crossing(uv, ends);
      if (point && points.length < 2 * most) points.push(...point);
    }
    open.push(e);
  }
  return Float64Array.from(points);
}
