// `compare`: the same mesh by several methods.

import type { CompareStage, MethodKey } from '../generated.js';
import type { CallOptions, Progress } from './layout.js';
import type { MeshSummary } from './mesh.js';

export type { MethodKey };

/** `stage` is the method at work; numbers of Newton's method are 0 for the references. */
export interface CompareProgress extends Omit<Progress, 'stage'> {
  stage: CompareStage | MethodKey;
}

export interface CompareOptions extends CallOptions {
  onProgress?: (progress: CompareProgress) => void;
}

/** One method on the mesh. Measures are null where there is no layout, or where they are infinite. */
export interface MethodResult {
  method: MethodKey;
  /** For people: "LSCM, free boundary". */
  title: string;
  /** To lay out, check and measure, without reading and connectivity. */
  seconds: number;
  /** Mean over corners of ((x - alpha)/alpha)^2, x in uv and alpha in 3D. */
  angularDistortion: number | null;
  /** Mean over edges of (s L/l - 1)^2, L in uv, l in 3D, s = sum l / sum L. */
  lengthDistortion: number | null;
  /** Mean by 3D area of |log(uv area / 3D area)| at equal total area: 0 keeps all areas, log 2 = 0.69 is off by a factor of two. */
  areaDistortion: number | null;
  /** Extremes of uv area / 3D area at equal total area; negative where a triangle is flipped. */
  areaRatio: { min: number | null; max: number | null };
  /** Ratio of the singular values, mean by 3D area and maximum; 1 is conformal. */
  quasiConformal: { mean: number | null; max: number | null };
  /** Mean by 3D area, divided by 4; 1 is an isometry. */
  symmetricDirichlet: number | null;
  flippedTriangles: number;
  boundaryCrossings: number;
  /** No flipped triangle, no crossing, and the method converged. */
  valid: boolean;
  /** Why it is not valid or what went wrong, one sentence; empty when it is valid. */
  problem: string;
  /** 2 per output vertex as in FlattenResult, scaled to the area of the 3D surface; empty where there is no layout. */
  uv: Float64Array;
}

/** The same mesh flattened by every method, in a fixed order: the abflat layouts first. */
export interface Comparison {
  version: string;
  input: MeshSummary;
  methods: MethodResult[];
  /** 3 output vertices per triangle, the same for all methods. */
  indices: Uint32Array;
  /** Input vertex of each output vertex. */
  vertexMap: Uint32Array;
  /** 3 per output vertex, only for file input. */
  positions?: Float64Array;
}
