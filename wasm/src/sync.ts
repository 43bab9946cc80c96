// Entry for browsers, workers of all kinds and bundlers: the engine in the calling thread.

import { connectSync } from './connect-sync.js';
import { browserFiles } from './files-browser.js';
import { localFile } from './local-file.js';
import type { AbflatSync, CreateSyncOptions } from './types/index.js';

export * from './exports.js';

/** Loads what the calls need, which then run in the thread that makes them. */
export function createAbflatSync(options?: CreateSyncOptions): Promise<AbflatSync> {
  return connectSync(browserFiles(localFile), options);
}
