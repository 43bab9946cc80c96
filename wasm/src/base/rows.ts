// Vertices are rows of attributes. Copying them takes no knowledge of three.js or glTF.

/** The typed arrays that attributes come in. */
interface Row {
  readonly length: number;
  [index: number]: number;
}

/** How the rows of an attribute are laid out in its array, in elements. */
export interface RowLayout {
  size: number;
  stride?: number;
  offset?: number;
}

/** Copies the given rows, as they are stored, to an array of the same type. */
export function pickRows<T extends Row>(
  array: T,
  rows: Uint32Array,
  { size, stride = size, offset = 0 }: RowLayout,
): T {
  const Kind = array.constructor as new (length: number) => T;
  const picked = new Kind(size * rows.length);
  rows.forEach((row, i) => {
    for (let k = 0; k < size; ++k)
      (picked as Row)[size * i + k] = array[stride * row + offset + k] as number;
  });
  return picked;
}

type IndexArray = Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

/**
 * Indices of `count` rows in the smallest type that holds them, but with at least `leastBytes`
 * bytes. The largest value of a type is not an index.
 */
export function indexArray(indices: Uint32Array, count: number, leastBytes = 2): IndexArray {
  if (leastBytes < 2 && count <= 255) return new Uint8Array(indices);
  return leastBytes < 4 && count <= 65535 ? new Uint16Array(indices) : new Uint32Array(indices);
}
