// What the package exports besides createAbflat.

export { type Build, bestBuild } from './base/builds.js';
export { AbflatError, type LostPart } from './base/errors.js';
export {
  FLATTEN_DEFAULTS,
  FLATTEN_OPTIONS,
  type FlattenOptionValues,
  type FlattenStage,
  type LinearSolver,
  type Solver,
  STATUS_NAMES,
  STATUSES,
  type StatusName,
  UNWRAP_DEFAULTS,
  UNWRAP_OPTIONS,
  type UnwrapOptionValues,
  type UnwrapStage,
} from './base/generated.js';
export { SAMPLE_NAMES, type SampleName } from './base/samples.js';
export type * from './types/index.js';
