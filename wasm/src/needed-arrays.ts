import type { MeshArrays, UnwrapOptions } from './types.js';

/** A mesh without what these options do not look at. */
export function neededFor(
  { seams, fixedFaces }: Pick<UnwrapOptions, 'seams' | 'fixedFaces'>,
  { positions, indices, texcoords, materials }: MeshArrays,
): MeshArrays {
  const wants = (source: string) => seams?.split(',').some((each) => each.trim() === source);
  return {
    positions,
    indices,
    ...(texcoords && (fixedFaces || wants('uv')) && { texcoords }),
    ...(materials && wants('material') && { materials }),
  };
}
