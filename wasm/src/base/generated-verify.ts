// Generated from core/schema by scripts/generate.mjs, do not edit.

/** What a layout must keep to, as plain values, with their defaults. */
export interface VerifyOptionValues {
  resolution: number | readonly [width: number, height: number];
  udim: boolean;
  padding: number;
  margin: number;
  mipLevels: number;
  minIslandWidth: number;
  minTexelDensity: number | 'none';
  maxTexelDensity: number | 'none';
  maxDensityRatio: number | 'none';
  maxStretch: number | 'none';
  minUtilization: number;
  maxIslands: number | 'none';
  allowStacked: boolean;
  allowMirrored: boolean;
  allowOverlaps: boolean;
  allowOutsideTiles: boolean;
  allowEmpty: boolean;
  allowUnmapped: boolean;
}

export const VERIFY_DEFAULTS: Readonly<VerifyOptionValues> & { readonly resolution: number } = {
  resolution: 1024,
  udim: false,
  padding: 0,
  margin: 0,
  mipLevels: 0,
  minIslandWidth: 0,
  minTexelDensity: 'none',
  maxTexelDensity: 'none',
  maxDensityRatio: 'none',
  maxStretch: 'none',
  minUtilization: 0,
  maxIslands: 'none',
  allowStacked: false,
  allowMirrored: false,
  allowOverlaps: false,
  allowOutsideTiles: false,
  allowEmpty: false,
  allowUnmapped: false,
};

/** Type, default, bounds and help text of every option, in the order of the C++ side; `range` says the bounds in words. */
export const VERIFY_OPTIONS = {
  resolution: { type: 'size', default: 1024, atLeast: 16, atMost: 32768, text: 'side of the texture in texels, or its width and height: for distances, widths and texel densities', range: 'at least 16 and at most 32768, whole, or two of these, as in [2048, 1024]' },
  udim: { type: 'boolean', default: false, text: 'islands may lie in any UDIM tile: from 1001 on, ten per row, u from 0 to 10', range: '' },
  padding: { type: 'number', default: 0, atLeast: 0, atMost: 1024, text: 'least distance between two islands in texels', range: 'at least 0 and at most 1024' },
  margin: { type: 'number', default: 0, atLeast: 0, atMost: 1024, text: 'least distance between an island and the edge of its tile in texels', range: 'at least 0 and at most 1024' },
  mipLevels: { type: 'integer', default: 0, atLeast: 0, atMost: 15, text: 'mip levels below the texture in which padding and margin must hold, too: distances are half as many texels in each', range: 'at least 0 and at most 15, whole' },
  minIslandWidth: { type: 'number', default: 0, atLeast: 0, atMost: 32768, text: 'least width of an island in texels, across the shorter side of its smallest box', range: 'at least 0 and at most 32768' },
  minTexelDensity: { type: 'number', default: 'none', above: 0, words: { none: 0 }, text: 'least texels per mesh unit of a face; a glTF is in metres', range: 'above 0, or none' },
  maxTexelDensity: { type: 'number', default: 'none', above: 0, words: { none: 0 }, text: 'most texels per mesh unit of a face', range: 'above 0, or none' },
  maxDensityRatio: { type: 'number', default: 'none', atLeast: 1, words: { none: 0 }, text: 'how many times as dense as another an island may be', range: 'at least 1, or none' },
  maxStretch: { type: 'number', default: 'none', above: 1, words: { none: 0 }, text: 'largest stretch of an island: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths', range: 'above 1, or none' },
  minUtilization: { type: 'number', default: 0, atLeast: 0, atMost: 1, text: 'least share of the tiles that islands cover', range: 'at least 0 and at most 1' },
  maxIslands: { type: 'integer', default: 'none', atLeast: 1, atMost: 1000000000, words: { none: 0 }, text: 'most islands', range: 'at least 1 and at most 1000000000, whole, or none' },
  allowStacked: { type: 'boolean', default: false, text: 'islands may lie on each other if they cover the same place', range: '' },
  allowMirrored: { type: 'boolean', default: false, text: 'whole islands may run clockwise', range: '' },
  allowOverlaps: { type: 'boolean', default: false, text: 'islands may overlap others and themselves', range: '' },
  allowOutsideTiles: { type: 'boolean', default: false, text: 'islands may leave their tile, as with textures that repeat', range: '' },
  allowEmpty: { type: 'boolean', default: false, text: 'faces with area may have none in uv', range: '' },
  allowUnmapped: { type: 'boolean', default: false, text: 'faces may be without texcoords', range: '' },
} as const;
