// `unwrap`: an atlas for any mesh.

import type { UnwrapArrays, UnwrapOptionValues, UnwrapStage } from '../base/generated.js';
import type { UnwrapReport } from '../base/generated-report.js';
import type { Layout, LayoutOptions, PinOptions, Progress } from './layout.js';

/** `stage` and `fraction` tell how far the run is; the numbers of Newton's method are 0. */
export interface UnwrapProgress extends Omit<Progress, 'stage'> {
  stage: UnwrapStage;
}

/** The result of an earlier call for the same mesh, or at least this much of it. */
export interface KnownLayout {
  unpacked: Float64Array;
  /** Only needed for `fixedCharts` and `keepsPlaces`. */
  uv?: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  chartOfTriangle: Uint32Array;
  report: {
    options: Pick<UnwrapOptionValues, 't' | 'straightSeams'> &
      Partial<Pick<UnwrapOptionValues, 'balance'>>;
  };
}

/** UNWRAP_OPTIONS describes the plain values and their defaults. */
export interface UnwrapOptions
  extends LayoutOptions,
    PinOptions,
    Partial<UnwrapOptionValues>,
    UnwrapArrays {
  /** Where to cut: `auto` (the default), `hard`, `uv`, `material`, `none`, `sharp=DEGREES`, or `auto,sharp=60`. */
  seams?: string;
  /**
   * Islands of `fixedFaces` that cannot stay are unwrapped like the others, and a note in the report
   * names them: where a face is mirrored, degenerate in uv or outside its tile, or where the island
   * overlaps itself or another one. Otherwise they are an error. Default: false.
   */
  keepsValidOnly?: boolean;
  /**
   * Charts of `known` that are not flattened again also stay exactly where they are in its `uv`. The
   * others are packed around them, at their texel density if there is room. Charts that stay may
   * overlap or leave the square; the result is then not valid, and the report says which ones.
   */
  keepsPlaces?: boolean;
  /**
   * Charts with the triangles and the outline of one of these, and the same `t`, `balance` and
   * `straightSeams`, are not flattened again.
   */
  known?: KnownLayout;
  onProgress?: (progress: UnwrapProgress) => void;
}

/**
 * `uv` is in [0, 1], or with `udim` in the square of a tile. Without `obj`, its numbers are rounded
 * to single precision if the charts stay valid, so that a copy in a Float32Array is exactly what
 * was checked. An input vertex appears once for every uv that it has. Triangles are in the order of
 * the input's faces, and a triangle mesh keeps all of them.
 */
export interface UnwrapResult extends Layout<UnwrapReport> {
  /**
   * For each triangle, its index into report.charts; 2^32 - 1 for one without area that nothing
   * touches.
   */
  chartOfTriangle: Uint32Array;
  /** Edges that were cut, given as two input vertices each. */
  seams: Uint32Array;
  /**
   * `uv` before packing, in double precision. Each chart is in the unit of the input and has its 3D
   * area; NaN if it is fixed.
   */
  unpacked: Float64Array;
}
