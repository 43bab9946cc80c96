import type { MeshArrays, UnwrapOptions } from '../types/index.js';
import { ownFields } from './fields.js';

/** The mesh without the arrays that these options do not use. */
export function neededFor(
  options: Pick<UnwrapOptions, 'seams' | 'fixedFaces'>,
  mesh: MeshArrays,
): MeshArrays {
  const { seams, fixedFaces } = ownFields(options);
  const { positions, indices, texcoords, materials } = ownFields(mesh);
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
