// `flatten`: one layout of a disk.

import type { FlattenOptionValues } from '../base/generated.js';
import type { Report, VertexBound } from '../base/generated-report.js';
import type { Layout, LayoutOptions, PinOptions, Progress } from './layout.js';

/**
 * The part of the boundary from vertex `from` to vertex `to`, walked with the surface on the left.
 */
export interface StraightRun {
  from: number;
  to: number;
}

/** FLATTEN_OPTIONS describes the plain values and their defaults. */
export interface FlattenOptions extends LayoutOptions, PinOptions, Partial<FlattenOptionValues> {
  /** Bounds for single boundary vertices, in place of the common `t`. */
  bounds?: VertexBound[];
  /** Parts of the boundary that are straight in the layout, whatever t and the bounds say. */
  straight?: readonly StraightRun[];
  /**
   * Move and scale the layout into [0, 1] x [0, 1] before it is checked. Not with `pins`. Default:
   * false.
   */
  normalize?: boolean;
  onProgress?: (progress: Progress) => void;
}

/**
 * `uv` is in the unit of the input unless normalized; without pins, the layout has the area of the
 * 3D surface. `vertexMap` is the identity for a plain disk without unused vertices.
 */
export type FlattenResult = Layout<Report>;
