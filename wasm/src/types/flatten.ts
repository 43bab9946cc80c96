// `flatten`: one layout of a disk.

import type { FlattenOptionValues } from '../base/generated.js';
import type { Report, VertexBound } from '../base/generated-report.js';
import type { Layout, LayoutOptions, Progress } from './layout.js';

/** What follows vertex `from` on the boundary, with the surface on the left, up to vertex `to`. */
export interface StraightRun {
  from: number;
  to: number;
}

/** The plain values are described, with their defaults, by FLATTEN_OPTIONS. */
export interface FlattenOptions extends LayoutOptions, Partial<FlattenOptionValues> {
  /** Bounds of single boundary vertices, in place of the common t. */
  bounds?: VertexBound[];
  /** Parts of the boundary that are straight in the layout, whatever t and the bounds say. */
  straight?: readonly StraightRun[];
  /** Moves and scales the layout into [0, 1] x [0, 1], before it is checked. Not with `pins`. Default: false. */
  normalize?: boolean;
  onProgress?: (progress: Progress) => void;
}

/**
 * `uv` is in the unit of the input unless it is normalized: without pins the layout has the area of the 3D surface. `vertexMap` is the identity for a plain
 * disk without unused vertices.
 */
export type FlattenResult = Layout<Report>;
