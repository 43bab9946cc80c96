// Colours of the vertices of a PLY or an OBJ: sRGB, from 0 to 1.

import { plyVertexNumbers } from './ply-vertices';

/** Red, green and blue per vertex; NaN where there are none. */
export type VertexColors = ArrayLike<number>;

/** Under the names that programs use. */
const NAMES = [
  ['red', 'green', 'blue'],
  ['diffuse_red', 'diffuse_green', 'diffuse_blue'],
  ['r', 'g', 'b'],
];

/** Integers are fractions of the largest value of their type. */
export function plyColors(bytes: Uint8Array): VertexColors | null {
  for (const names of NAMES) {
    const found = plyVertexNumbers(bytes, names);
    if (!found) continue;
    const { values, largest } = found;
    return largest === 1 ? ranged(values) : values.map((each) => each / largest);
  }
  return null;
}

/** Where any is above 1, they were from 0 to 255. */
export function ranged<T extends number[] | Float64Array>(colors: T): T {
  if (!colors.some((each) => each > 1)) return colors;
  return colors.map((each) => each / 255) as T;
}
