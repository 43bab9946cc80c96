import type { MeshArrays } from './types.js';

/** A mesh without what these seams do not look at. */
export function neededFor(
  seams: string | undefined,
  { positions, indices, texcoords, materials }: MeshArrays,
): MeshArrays {
  const wants = (source: string) => seams?.split(',').some((each) => each.trim() === source);
  return {
    positions,
    indices,
    ...(texcoords && wants('uv') && { texcoords }),
    ...(materials && wants('material') && { materials }),
  };
}
