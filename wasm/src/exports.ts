// What the package exports besides createAbflat.

export { type Build, bestBuild } from './base/builds.js';
export { AbflatError, type LostPart } from './base/errors.js';
export {
  type BakeStage,
  FLATTEN_DEFAULTS,
  FLATTEN_OPTIONS,
  type FlattenOptionValues,
  type FlattenStage,
  type LinearSolver,
  PACK_DEFAULTS,
  PACK_OPTIONS,
  type PackOptionValues,
  type PackStage,
  type Solver,
  STATUS_NAMES,
  STATUSES,
  type StatusName,
  UNWRAP_DEFAULTS,
  UNWRAP_OPTIONS,
  type UnwrapOptionValues,
  type UnwrapStage,
  type VerifyRule,
  type VerifyStage,
} from './base/generated.js';
export type { BakeOptionValues } from './base/generated-bake.js';
export { UV_FAULT } from './base/generated-bits.js';
export type { VerifyOptionValues } from './base/generated-verify.js';
export { SAMPLE_NAMES, type SampleName } from './base/samples.js';
export type * from './types/index.js';
