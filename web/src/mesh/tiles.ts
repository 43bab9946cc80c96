/** UDIM: tile 1001 is the unit square, and there are ten tiles in a row. */
const FIRST = 1001;
const IN_A_ROW = 10;

/** Tiles along u and v. */
export function tileGrid(tiles: number): [number, number] {
  return [Math.min(tiles, IN_A_ROW), Math.ceil(tiles / IN_A_ROW)];
}

/** The lower left corner of the tile with this index, and its number. */
export function tileAt(index: number): { u: number; v: number; number: number } {
  return { u: index % IN_A_ROW, v: Math.floor(index / IN_A_ROW), number: FIRST + index };
}

/** Outlines of all tiles: points in uv, 2 numbers each, and sides as pairs of points. */
export function tileFrames(tiles: number): { points: Float64Array; sides: Uint32Array } {
  const points: number[] = [];
  const sides: number[] = [];
  for (let i = 0; i < tiles; ++i) {
    const { u, v } = tileAt(i);
    points.push(u, v, u + 1, v, u + 1, v + 1, u, v + 1);
    for (let k = 0; k < 4; ++k) sides.push(4 * i + k, 4 * i + ((k + 1) % 4));
  }
  return { points: Float64Array.from(points), sides: Uint32Array.from(sides) };
}
