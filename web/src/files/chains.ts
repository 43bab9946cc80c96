/**
 * Joins edges, given as pairs of points, to runs as long as possible; each edge is in one of them.
 * `bothWays`: edges may be traversed backwards.
 */
export function chains(pairs: ArrayLike<number>, bothWays: boolean): number[][] {
  const edgeCount = pairs.length / 2;
  const edgesAt = new Map<number, number[]>();
  const meet = (point: number, edge: number) => {
    const edges = edgesAt.get(point);
    if (edges) edges.push(edge);
    else edgesAt.set(point, [edge]);
  };
  for (let e = 0; e < edgeCount; ++e) {
    meet(pairs[2 * e], e);
    if (bothWays) meet(pairs[2 * e + 1], e);
  }
  const isUsed = new Uint8Array(edgeCount);
  const freeAt = (point: number) => {
    const edges = edgesAt.get(point) ?? [];
    while (edges.length > 0 && isUsed[edges[edges.length - 1]]) edges.pop();
    return edges.at(-1);
  };
  const found: number[][] = [];
  for (let first = 0; first < edgeCount; ++first) {
    if (isUsed[first]) continue;
    let point = pairs[2 * first];
    const chain = [point];
    for (let e: number | undefined = first; e !== undefined; e = freeAt(point)) {
      isUsed[e] = 1;
      point = pairs[2 * e] === point ? pairs[2 * e + 1] : pairs[2 * e];
      chain.push(point);
    }
    found.push(chain);
  }
  return found;
}
