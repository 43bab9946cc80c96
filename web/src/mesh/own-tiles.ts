// The UDIM tiles that islands are in, or get. Coordinates are those of corners, 2 each.

/** Triangles without uv have no island. */
export const isIsland = (island: number) => island !== 0xffffffff;

/** The tile that has a point, or the nearest to it. */
export function tileAt(u: number, v: number): number {
  const [column, row] = [u, v].map((x) => Math.max(0, Math.floor(x) || 0));
  return 10 * row + Math.min(9, column);
}

/** The tile of each island's middle. */
export function tilesOfFile(
  corners: Float64Array,
  islandOfTriangle: Uint32Array,
  islands: number,
): Uint32Array {
  const low = new Float64Array(2 * islands).fill(Infinity);
  const high = new Float64Array(2 * islands).fill(-Infinity);
  corners.forEach((x, i) => {
    const island = islandOfTriangle[Math.floor(i / 6)];
    if (!isIsland(island)) return;
    const at = 2 * island + (i % 2);
    low[at] = Math.min(low[at], x);
    high[at] = Math.max(high[at], x);
  });
  const middle = (at: number) => (low[at] + high[at]) / 2;
  return Uint32Array.from({ length: islands }, (_, i) => tileAt(middle(2 * i), middle(2 * i + 1)));
}

/** Runs of triangles: the first, and how many. */
interface Part {
  runs: readonly (readonly [number, number])[];
}

/**
 * One for each part that has an island: that of the island's first triangle. `together`: islands
 * that go where the first of them goes.
 */
export function tilesOfParts(
  parts: readonly Part[],
  islandOfTriangle: Uint32Array,
  islands: number,
  together: readonly (readonly number[])[] = [],
): Uint32Array {
  const partOf = new Int32Array(islandOfTriangle.length).fill(-1);
  for (const [number, { runs }] of parts.entries())
    for (const [first, length] of runs) partOf.fill(number, first, first + length);
  const found = new Int32Array(islands).fill(-2);
  islandOfTriangle.forEach((island, f) => {
    if (isIsland(island) && found[island] === -2) found[island] = partOf[f];
  });
  for (const [first, ...others] of together) for (const each of others) found[each] = found[first];
  const used = [...new Set(found)].filter((part) => part >= 0).sort((a, b) => a - b);
  const tiles = new Map(used.map((part, tile) => [part, tile]));
  return Uint32Array.from(found, (part) => tiles.get(part) ?? 0);
}

/** The corners with all that goes to a tile beside what goes to others. */
export function movedApart(
  corners: Float64Array,
  islandOfTriangle: Uint32Array,
  tileOfIsland: Uint32Array,
): Float64Array {
  let [low, high] = [Infinity, -Infinity];
  const islandAt = (i: number) => islandOfTriangle[Math.floor(i / 6)];
  for (let i = 0; i < corners.length; i += 2) {
    if (!isIsland(islandAt(i))) continue;
    low = Math.min(low, corners[i]);
    high = Math.max(high, corners[i]);
  }
  const step = Math.ceil(high - low) + 1;
  return corners.map((x, i) =>
    i % 2 === 0 && isIsland(islandAt(i)) ? x + step * tileOfIsland[islandAt(i)] : x,
  );
}
