import type { MeshArrays, UnwrapOptions } from '../types/index.js';

/** The mesh without the arrays that these options do not use. */
export function neededFor(
  { seams, fixedFaces }: Pick<UnwrapOptions, 'seams' | 'fixedFaces'>,
  { positions, indices, texcoords, materials }: MeshArrays,
): MeshArrays {
  // A value that is not a string is refused later, when it is used.
  const sources = typeof seams === 'string' ? seams.split(',').map((each) => each.trim()) : [];
  const wants = (source: string) => sources.includes(source);
  return {
    positions,
    indices,
    ...(texcoords && (fixedFaces || wants('uv')) && { texcoords }),
    ...(materials && wants('material') && { materials }),
  };
}
