// What is said once a file is exported; loaded with what does that.

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
  cameOutDifferently: 'This run gave a different layout. Unwrap again, then export.',
};

export const VIEWS_PICTURE = {
  notMade: 'The browser could not make the picture. Make the window smaller.',
  noMemory: 'The browser ran out of memory for the picture. Close other tabs.',
};
