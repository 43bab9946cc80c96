// Entry that is one file: the engine in the calling thread, with its module inside.

import { inflateSync } from 'fflate';
import { checkHost } from './base/check-host.js';
import { AbflatError, messageOf } from './base/errors.js';
import { MAX_MEMORY } from './base/memory.js';
import { Engine } from './engine.js';
import { simd } from './glue-simd.js';
import { LocalModule, starterOf } from './local-module.js';
import { mainCalls } from './main-calls.js';
import { checkMaxMemory, knownOptions } from './messages/validate.js';
import { DEFLATED, SIZE } from './single-module.js';
import type { AbflatSingle, ModuleOptions } from './types/index.js';

export * from './exports.js';

/** Is there at once: loads nothing, and calls run in the thread that makes them. */
export function createAbflatSync(options: Pick<ModuleOptions, 'maxMemory'> = {}): AbflatSingle {
  const { maxMemory = MAX_MEMORY } = knownOptions(options, ['maxMemory']);
  checkMaxMemory(maxMemory);
  checkHost();
  const starter = starterOf(compiled(), maxMemory, simd.create, Engine.of);
  return mainCalls(LocalModule.startNow(starter));
}

function compiled(): WebAssembly.Module {
  const packed = Uint8Array.from(atob(DEFLATED), (letter) => letter.charCodeAt(0));
  const bytes = inflateSync(packed, { out: new Uint8Array(SIZE) });
  try {
    return new WebAssembly.Module(bytes);
  } catch (error) {
    // Forbidden by a page's policy, or too much for a page's thread in an old browser.
    throw new AbflatError(
      'UnsupportedHost',
      `WebAssembly cannot be compiled in this thread: ${messageOf(error)}.`,
    );
  }
}
