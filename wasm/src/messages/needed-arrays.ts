import type { MeshArrays, UnwrapOptions } from '../types/index.js';
import { ownFields } from './fields.js';

/** The mesh without the arrays that these options do not use. */
export function neededFor(
  options: Pick<UnwrapOptions, 'seams' | 'fixedFaces' | 'stack'>,
  mesh: MeshArrays,
): MeshArrays {
  const { seams, fixedFaces, stack = 'none' } = ownFields(options);
  const own = ownFields(mesh);
  const { positions, indices, texcoords, normals, cornerNormals, materials, vertexObjects } = own;
  // A value that is not a string is refused later, when it is used.
  const words = seams === undefined ? 'auto' : seams;
  const sources = typeof words === 'string' ? words.split(',').map((each) => each.trim()) : [];
  const wants = (source: string) => sources.includes(source);
  // Automatic seams are told where shading and materials change, too.
  const wantsHardEdges = wants('hard') || wants('auto');
  // Parts of different materials share no texels.
  const wantsMaterials = wants('material') || wants('auto') || stack !== 'none';
  return {
    positions,
    indices,
    ...(texcoords && (fixedFaces || wants('uv')) && { texcoords }),
    ...(normals && wantsHardEdges && { normals }),
    ...(cornerNormals && wantsHardEdges && { cornerNormals }),
    ...(materials && wantsMaterials && { materials }),
    ...(vertexObjects && { vertexObjects }),
  };
}
