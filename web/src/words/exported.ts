// What is said once a file is exported or saved; loaded with what does that.

import { count, listed } from './format';

/** `format` in capitals; `set`: a texcoord set of a glTF, by the name that its choice gives it. */
export const EXPORTED = {
  writing: (format: string) => `Writing ${format}`,
  exported: (name: string, size: string) => `Exported ${name}, ${size}`,
  shapeOnly: ', shape and UVs only',
  uncompressed: ', uncompressed',
  rounded:
    'GLB stores single precision, and rounding makes some triangles flip or overlap. OBJ keeps all digits',
  replaced: (set: number) => `New UVs replaced UV\u00a0${set}`,
  replacedPainted: (set: number) => `New UVs replaced UV\u00a0${set}, which textures use`,
  added: (set: number) => `New UVs are UV\u00a0${set}`,
  addedToPainted: (set: number) => `New UVs are UV\u00a0${set}; textures keep theirs`,
  /** glTF has no set without those before it. */
  filled: (sets: number[]) =>
    `UV\u00a0${listed(sets.map(String))} ${sets.length > 1 ? 'are' : 'is'} the same, since glTF numbers sets without gaps`,
  cameOutDifferently: 'This run gave a different layout. Unwrap again, then export.',
};

/** Files that were saved. */
export const SAVED = {
  saved: (name: string, size: string) => `Saved ${name}, ${size}`,
  kilobytes: (bytes: number) => `${count(Math.ceil(bytes / 1024))}\u202fKB`,
  pixels: (width: number, height: number) => `${count(width)}\u202f×\u202f${count(height)}\u202fpx`,
};

/** Pictures of an atlas. */
export const ATLAS_PICTURE = {
  tooLarge: (most: number) =>
    `a picture can have at most ${most} pixels per side. Lower the resolution, or save SVG`,
  noMemory:
    'the browser does not have enough memory for a picture this large. Lower the resolution, or save SVG',
};

export const VIEWS_PICTURE = {
  notMade: 'The browser could not make the picture. Make the window smaller.',
  noMemory: 'The browser ran out of memory for the picture. Close other tabs.',
};
