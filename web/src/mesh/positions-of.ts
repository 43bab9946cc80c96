import type { DisplayMesh } from './mesh';

/** The vertices of a layout: where they are in 3D, or which they are of the input. */
export interface PlacedVertices {
  positions?: Float64Array;
  vertexMap: Uint32Array;
}

/** Positions of a layout's vertices; `input` has them if the layout comes without. */
export function positionsOf(
  { positions, vertexMap }: PlacedVertices,
  input: Pick<DisplayMesh, 'positions'>,
): Float64Array {
  return positions ?? pick(input.positions, 3, vertexMap);
}

/** Copies the given rows of `size` numbers each. */
export function pick<T extends Float64Array | Float32Array>(
  values: T,
  size: number,
  rows: Uint32Array,
): T {
  const Kind = values.constructor as new (length: number) => T;
  const picked = new Kind(size * rows.length);
  for (let i = 0; i < rows.length; ++i)
    for (let d = 0; d < size; ++d) picked[size * i + d] = values[size * rows[i] + d];
  return picked;
}
