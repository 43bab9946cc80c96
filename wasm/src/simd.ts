// Entry for browsers and bundlers with the build `simd` alone.

import { connect } from './connect.js';
import { late } from './own-late.js';
import { simd } from './own-simd.js';
import { browserPlatform } from './platform-browser.js';
import type { Abflat, CreateOptions } from './types/index.js';

export * from './exports.js';

/** As that of the package, but bundlers emit no other build. */
export function createAbflat(options?: CreateOptions): Promise<Abflat> {
  return connect(browserPlatform({ simd, ...late }), options);
}
