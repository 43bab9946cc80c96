// Entry for browsers and bundlers.

import { connect } from './connect.js';
import { late } from './own-late.js';
import { simd } from './own-simd.js';
import { threads } from './own-threads.js';
import { browserPlatform } from './platform-browser.js';
import type { Abflat, CreateOptions } from './types/index.js';

export * from './exports.js';

/** Starts a worker. Rejects when the module or the worker's script cannot be loaded. */
export function createAbflat(options?: CreateOptions): Promise<Abflat> {
  return connect(browserPlatform({ simd, threads, ...late }), options);
}
