// `unwrap`: an atlas of any mesh.

import type { UnwrapOptionValues, UnwrapStage } from '../base/generated.js';
import type { UnwrapReport } from '../base/generated-report.js';
import type { Layout, LayoutOptions, Progress } from './layout.js';

/** `stage` and `fraction` tell where the run is; numbers of Newton's method are 0. */
export interface UnwrapProgress extends Omit<Progress, 'stage'> {
  stage: UnwrapStage;
}

/** What an earlier call gave for the same mesh: its result, or this much of it. */
export interface KnownLayout {
  unpacked: Float64Array;
  /** Only `fixedCharts` need it. */
  uv?: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  chartOfTriangle: Uint32Array;
  report: {
    options: Pick<UnwrapOptionValues, 't' | 'straightSeams'> &
      Partial<Pick<UnwrapOptionValues, 'balance'>>;
  };
}

/** The plain values are described, with their defaults, by UNWRAP_OPTIONS. */
export interface UnwrapOptions extends LayoutOptions, Partial<UnwrapOptionValues> {
  /** Where to cut: `auto` (the default), `uv`, `material`, `none`, `sharp=DEGREES`, or `auto,sharp=60`. */
  seams?: string;
  /** Edges to cut beside those, two vertices of the input each. */
  seamEdges?: Uint32Array;
  /** Faces of the input whose uv islands stay exactly as they are, `'uv'`: all that have coordinates; all others are packed around them. */
  fixedFaces?: Uint32Array | 'uv';
  /** Charts of `known` that stay exactly where they are; all others are packed around them. */
  fixedCharts?: Uint32Array;
  /** Charts that have the triangles and the outline of one of these, and the same `t`, `balance` and `straightSeams`, are not flattened again. */
  known?: KnownLayout;
  onProgress?: (progress: UnwrapProgress) => void;
}

/**
 * `uv` is in [0, 1], with `udim` in the square of a tile. Without `obj` its numbers are single precision ones, where the charts stay valid: copied to a
 * Float32Array they are what was checked. A vertex of the input is there once for every uv that it has. Triangles are in the
 * order of the input's faces, and a triangle mesh keeps all of them.
 */
export interface UnwrapResult extends Layout<UnwrapReport> {
  /** Index into report.charts of each triangle; 2^32 - 1 for one without area that nothing touches. */
  chartOfTriangle: Uint32Array;
  /** Edges that were cut, two vertices of the input each. */
  seams: Uint32Array;
  /** `uv` before packing, in double precision: every chart in the unit of the input, with the area that it has in 3D; NaN where it is fixed. */
  unpacked: Float64Array;
}
