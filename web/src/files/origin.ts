/** How a GLB stores positions in single precision: less what its node is translated by. */

export type Offset = [number, number, number];

/**
 * The translation: 0 along each axis on which the mesh is no further from the origin than it is
 * large, and everywhere if rounding shows nowhere. It shows if more than one edge in a hundred
 * changes by more than a thousandth of its length.
 */
export function originOf(positions: Float64Array, indices: Uint32Array): Offset {
  const none: Offset = [0, 0, 0];
  return isVisible(positions, indices) ? middleOf(positions, indices) : none;
}

export const relativeTo = (offset: Offset, positions: Float64Array) =>
  Float32Array.from(positions, (x, i) => x - (offset[i % 3] as number));

function middleOf(positions: Float64Array, indices: Uint32Array): Offset {
  const box = [0, 1, 2].map((d) => {
    let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (const v of indices) {
      const x = positions[3 * v + d] as number;
      least = Math.min(least, x);
      most = Math.max(most, x);
    }
    return { middle: least / 2 + most / 2, size: most - least };
  });
  const size = Math.max(...box.map((side) => side.size));
  // A number that people can read is as good as the middle itself.
  const unit = 2 ** (Math.floor(Math.log2(size)) - 2);
  const rounded = box.map(({ middle }) => Math.round(middle / unit) * unit);
  return rounded.map((x) => (Math.abs(x) > size ? Math.fround(x) : 0)) as Offset;
}

function isVisible(positions: Float64Array, indices: Uint32Array): boolean {
  let changed = 0;
  for (let c = 0; c < indices.length; ++c) {
    const a = 3 * (indices[c] as number);
    const b = 3 * (indices[c % 3 === 2 ? c - 2 : c + 1] as number);
    let [length, change] = [0, 0];
    for (let d = 0; d < 3; ++d) {
      const [p, q] = [positions[a + d] as number, positions[b + d] as number];
      length = Math.max(length, Math.abs(q - p));
      change = Math.max(change, Math.abs(Math.fround(q) - Math.fround(p) - (q - p)));
    }
    if (change > 1e-3 * length) ++changed;
  }
  return changed > indices.length / 100;
}
