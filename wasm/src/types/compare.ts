// `compare`: the same mesh by several methods.

import type { CompareStage, MethodKey } from '../base/generated.js';
import type { ComparisonReport } from '../base/generated-report.js';
import type { CallOptions, Progress } from './layout.js';

export type { MethodKey };

/** `stage` names the method at work; the reference methods report 0 for Newton's numbers. */
export interface CompareProgress extends Omit<Progress, 'stage'> {
  stage: CompareStage | MethodKey;
}

export interface CompareOptions extends CallOptions {
  onProgress?: (progress: CompareProgress) => void;
}

/** The same mesh flattened by every method, in a fixed order: the abflat layouts first. */
export interface Comparison extends ComparisonReport {
  /** 3 output vertices per triangle, the same for all methods. */
  indices: Uint32Array;
  /** Input vertex of each output vertex. */
  vertexMap: Uint32Array;
  /** 3 per output vertex, only for file input. */
  positions?: Float64Array;
}
