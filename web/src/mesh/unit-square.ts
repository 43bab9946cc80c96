import { boundingBox } from './mesh';

/** Texcoords moved and scaled into the unit square, in their proportions. */
export function toUnitSquare(uv: Float64Array, indices: Uint32Array): Float64Array {
  const { min, max } = boundingBox(uv, 2, indices);
  const side = Math.max(max[0] - min[0], max[1] - min[1]) || 1;
  return uv.map((x, i) => (x - min[i % 2]) / side);
}
