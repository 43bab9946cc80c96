// `verify`: what the layout that a mesh has does not keep to.

import type { VerifyStage } from '../base/generated.js';
import type { VerifyReport } from '../base/generated-report.js';
import type { VerifyOptionValues } from '../base/generated-verify.js';
import type { CallOptions, Progress } from './layout.js';

/** The numbers of Newton's method are 0. */
export interface VerifyProgress extends Omit<Progress, 'stage'> {
  stage: VerifyStage;
}

/** The README lists the plain values and their defaults. */
export interface VerifyOptions extends CallOptions, Partial<VerifyOptionValues> {
  /** 2 per corner of the mesh's triangles, in place of the texcoords that it has. They are copied. */
  uv?: Float32Array | Float64Array;
  onProgress?: (progress: VerifyProgress) => void;
}

/** Faces are those of the input: triangles of arrays, polygons of a file. */
export interface VerifyResult {
  report: VerifyReport;
  /** For each face, the number of its uv island; 2^32 - 1 for one without texcoords. */
  islandOfFace: Uint32Array;
  /** For each triangle, the face that it is part of. */
  faces: Uint32Array;
  /** For each triangle, what is wrong with it in uv: a sum of the bits in UV_FAULT, or 0. */
  faults: Uint8Array;
}
