// Entry for Node: the engine in the calling thread.

import { connectSync } from './connect-sync.js';
import { nodeFiles } from './files-node.js';
import { localFile } from './local-file.js';
import type { AbflatSync, CreateSyncOptions } from './types/index.js';

export * from './exports.js';

/** Loads what the calls need, which then run in the thread that makes them. */
export function createAbflatSync(options?: CreateSyncOptions): Promise<AbflatSync> {
  return connectSync(nodeFiles(localFile), options);
}
