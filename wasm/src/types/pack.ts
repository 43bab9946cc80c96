// `pack`: the layout that a mesh has, packed again.

import type { PackOptionValues, PackStage } from '../base/generated.js';
import type { PackReport } from '../base/generated-report.js';
import type { Layout, LayoutOptions, Progress } from './layout.js';

/** `stage` and `fraction` tell how far the run is; the numbers of Newton's method are 0. */
export interface PackProgress extends Omit<Progress, 'stage'> {
  stage: PackStage;
}

/** PACK_OPTIONS describes the plain values and their defaults. */
export interface PackOptions extends LayoutOptions, PackArrays, Partial<PackOptionValues> {
  onProgress?: (progress: PackProgress) => void;
}

/** Arrays among the options, which are copied. */
export interface PackArrays {
  /** 2 per corner of the mesh's triangles, in place of the texcoords that it has. */
  uv?: Float32Array | Float64Array;
  /**
   * Only these islands are packed, by their numbers in `islandOfTriangle`, and what they are stacked
   * with. The others stay where they are. Without any, all are packed.
   */
  islands?: Uint32Array;
  /**
   * The tile that each island goes to: 0 is UDIM 1001, and a row has ten. Each tile is packed by
   * itself, as tight as it can be.
   */
  tileOfIsland?: Uint32Array;
}

/**
 * The output vertices are those of the input in their order, then a copy for every further uv that a
 * vertex has. `uv` is in [0, 1], or with `udim` in the square of a tile, but for triangles that stay
 * as they are, which with `keepPlaces` are all; it is 0 for vertices without texcoords. Unless only
 * `obj` is asked for, its numbers are rounded to single precision.
 */
export interface PackResult extends Layout<PackReport> {
  /** For each triangle, the number of its uv island; 2^32 - 1 for one without texcoords. */
  islandOfTriangle: Uint32Array;
  /** For each triangle, what is wrong with it in uv: a sum of the bits in UV_FAULT, or 0. */
  faults: Uint8Array;
}
