// What the package exports beside createAbflat.

export { type Build, bestBuild } from './builds.js';
export { AbflatError, type LostPart } from './errors.js';
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
} from './generated.js';
export { SAMPLE_NAMES, type SampleName } from './samples.js';
export type * from './types.js';
