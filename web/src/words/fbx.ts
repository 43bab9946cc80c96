// Files of FBX that are read.

import { listed } from './format';

const LEFT_OUT: Record<string, string> = {
  maps: 'textures other than colour, normals, occlusion and emission',
  skins: 'skins',
  morphAnimations: 'animations of morph targets',
  cameras: 'cameras',
  lights: 'lights',
  curves: 'curves',
};

export const FBX = {
  notFbx: (name: string) =>
    `${name} is not an FBX file, because it does not begin like one. Export or download it again.`,
  /** `version` as the file has it, such as 6100. */
  tooOld: (name: string, version: number) =>
    `${name} is FBX ${Math.floor(version / 100) / 10}, which is too old to read. Save it as FBX 7.4 (2014) or newer, or as GLB.`,
  damaged: (name: string, reason: string) =>
    `${name} is damaged, or holds what this page cannot read (${reason}). Export it again, or save it as GLB in the program that made it.`,
  vertexMissing: 'a face has a vertex that is not there',
  opened: (name: string) => `${name} is exported as GLB or OBJ, not as FBX.`,
  triangles: 'Its polygons become triangles.',
  leftOut: (lost: string[]) => {
    const names = lost.flatMap((each) => LEFT_OUT[each] ?? []);
    return names.length > 0 ? `Left out: ${listed(names)}.` : '';
  },
};
