// What becomes of the images of an OBJ.

import { listed } from './format';

export const BAKED_OBJ = {
  missing: (files: string[]) =>
    `${listed(files)} ${files.length > 1 ? 'were' : 'was'} left out, because ${files.length > 1 ? 'they were' : 'it was'} not among the files. Drop all of them together`,
  unknown: (keywords: string[]) =>
    `Images for ${listed(keywords)} were left out, because they are not baked`,
  noPixels: 'This browser cannot read the pixels of images',
  noPlace: (maps: string[]) =>
    `Images for ${listed(maps)} were left out, because a GLB has no place for them`,
  noOcclusion: 'Occlusion was left out, because materials of an OBJ have no such map',
};
