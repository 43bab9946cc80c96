// Vertices are rows of attributes: what copies them knows neither three.js nor glTF.

/** The typed arrays that attributes come in. */
interface Row {
  readonly length: number;
  [index: number]: number;
}

/** How the rows of an attribute lie in its array. */
export interface RowLayout {
  size: number;
  stride?: number;
  offset?: number;
}

/** The rows that `rows` names, as they are stored, in an array of the same kind. */
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

/** Indices of `count` rows in as few bytes as that takes, but no fewer than `leastBytes`. The largest number of a kind is no index. */
export function indexArray(indices: Uint32Array, count: number, leastBytes = 2): IndexArray {
  if (leastBytes < 2 && count <= 255) return new Uint8Array(indices);
  return leastBytes < 4 && count <= 65535 ? new Uint16Array(indices) : new Uint32Array(indices);
}
