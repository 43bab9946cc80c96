// What calls that give a layout have in common.

import type { FlattenStage } from '../base/generated.js';

/** What calls need of an AbortSignal, whichever library declares it. */
export interface AbortSignalLike {
  readonly aborted: boolean;
  readonly reason: unknown;
  addEventListener(type: 'abort', listener: () => void): void;
  removeEventListener(type: 'abort', listener: () => void): void;
}

export interface CallOptions {
  /** An AbortSignal. Aborting rejects with its reason; the next call works. */
  signal?: AbortSignalLike;
  /** Move the whole input buffers to the worker instead of copying them (they are detached by the call). */
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

/** A place in the layout for a vertex of the input. */
export interface Pin {
  vertex: number;
  uv: readonly [number, number];
  /** A face that uses the vertex: tells which of its texcoords is meant where it lies on a seam. */
  face?: number;
}

export interface LayoutOptions extends CallOptions {
  /**
   * None, or two and more; in an atlas that of each chart, which then stays where its pins are. Two are met by moving,
   * turning and scaling the layout, more by the nearest one to the angles in the sense of least squares.
   */
  pins?: readonly Pin[];
  /** Also return the input as OBJ text with the new texcoords. */
  obj?: boolean;
  /** Also return the input as PLY with the new texcoords; the layout is rounded to single precision where it stays valid. */
  ply?: boolean;
  /**
   * `uv` becomes what a glTF holds of it, single precision with v from the top, whatever becomes of its validity: the report is about
   * that. Default: false; `unwrap` rounds to single precision then unless that would make a chart invalid.
   */
  roundsForGltf?: boolean;
}

/** Seconds; the stages between depend on the call. */
export interface LayoutTimings {
  read: number;
  write: number;
  total: number;
}

/** What every layout has; `R` is its report. */
export interface Layout<R> {
  /** 2 per output vertex. */
  uv: Float64Array;
  /** 3 output vertices per triangle; polygons of a file are triangulated. */
  indices: Uint32Array;
  /** Input vertex of each output vertex. */
  vertexMap: Uint32Array;
  /** 3 per output vertex, only for file input (arrays know their own positions through vertexMap). */
  positions?: Float64Array;
  /** OBJ text (UTF-8) when asked for with `obj: true`. */
  obj?: Uint8Array;
  /** PLY when asked for with `ply: true`: in the encoding of the input, binary where that is no PLY. */
  ply?: Uint8Array;
  report: R;
}
