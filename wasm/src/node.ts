// Entry for Node.

import { connect } from './connect.js';
import { node } from './platform-node.js';
import type { Abflat, CreateOptions } from './types/index.js';

export * from './exports.js';

/** Starts a worker thread. Rejects when the module or the worker's script cannot be loaded. */
export function createAbflat(options?: CreateOptions): Promise<Abflat> {
  return connect(node, options);
}
