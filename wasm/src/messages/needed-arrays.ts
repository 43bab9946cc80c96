import type { MeshArrays, UnwrapOptions } from '../types/index.js';

/** A mesh without what these options do not look at. */
export function neededFor(
  { seams, fixedFaces }: Pick<UnwrapOptions, 'seams' | 'fixedFaces'>,
  { positions, indices, texcoords, materials }: MeshArrays,
): MeshArrays {
  // What is no string is refused when it is used.
  const sources = typeof seams === 'string' ? seams.split(',').map((each) => each.trim()) : [];
  const wants = (source: string) => sources.includes(source);
  return {
    positions,
    indices,
    ...(texcoords && (fixedFaces || wants('uv')) && { texcoords }),
    ...(materials && wants('material') && { materials }),
  };
}
