// What the calls that return a layout have in common.

import type { FileOptions, Files, FlattenStage } from '../base/generated.js';

/** The part of AbortSignal that calls need, no matter which library declares the type. */
export interface AbortSignalLike {
  readonly aborted: boolean;
  readonly reason: unknown;
  addEventListener(type: 'abort', listener: () => void): void;
  removeEventListener(type: 'abort', listener: () => void): void;
}

export interface CallOptions {
  /** An AbortSignal. Aborting rejects the call with the signal's reason; the next call works. */
  signal?: AbortSignalLike;
  /**
   * Move the entire input buffers to the worker instead of copying them; the call detaches them.
   */
  transfer?: boolean;
}

export interface Progress {
  stage: FlattenStage;
  /** 0 outside the solve stage. */
  newtonStep: number;
  constraintResidual: number;
  /** Rough share of the work done, 0..1. */
  fraction: number;
}

/** A fixed place in the layout for an input vertex. */
export interface Pin {
  vertex: number;
  uv: readonly [number, number];
  /** A face that uses the vertex. On a seam, it tells which of the vertex's texcoords is meant. */
  face?: number;
}

/** How a layout follows a pin that is dragged. */
export interface PinWeights {
  /**
   * a and b of each vertex in turn: when the pin moves by (du, dv), the vertex moves by
   * (a du - b dv, b du + a dv).
   */
  weights: Float64Array;
}

export interface PinOptions {
  /**
   * None, or at least two; in an atlas, per chart, and a pinned chart stays where its pins are. Two
   * pins are met by moving, rotating and scaling the layout; more, by the layout that is closest to
   * the angles in the least-squares sense.
   */
  pins?: readonly Pin[];
}

export interface LayoutOptions extends CallOptions, FileOptions {
  /**
   * Round `uv` to the values that a glTF holds (single precision, v measured from the top), even if
   * that makes it invalid; the report describes the rounded layout. Default: false; `unwrap` then
   * rounds to single precision unless that would make a chart invalid.
   */
  roundsForGltf?: boolean;
}

/** In seconds. The stages in between depend on the call. */
export interface LayoutTimings {
  read: number;
  write: number;
  total: number;
}

/** What every layout has; `R` is the type of its report. */
export interface Layout<R> extends Files {
  /** 2 per output vertex. */
  uv: Float64Array;
  /** 3 output vertices per triangle; polygons of a file are triangulated. */
  indices: Uint32Array;
  /** Input vertex of each output vertex. */
  vertexMap: Uint32Array;
  /** 3 per output vertex, only for file input (for arrays, look them up through `vertexMap`). */
  positions?: Float64Array;
  report: R;
}
