// Entry for Node with the build `simd` alone.

import { connect } from './connect.js';
import { node } from './platform-node.js';
import type { Abflat, CreateOptions } from './types/index.js';

export * from './exports.js';

/** As that of the package, with this build. */
export function createAbflat(options?: CreateOptions): Promise<Abflat> {
  return connect({ ...node, builds: ['simd'] }, options);
}
