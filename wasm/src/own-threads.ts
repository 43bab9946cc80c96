import type { OwnFile } from './platform-browser.js';

/** As in own-simd.ts. */
export const threads: OwnFile = {
  wasm: () => new URL('./abflat-threads.wasm', import.meta.url),
  worker: () => new Worker(new URL('./worker-threads.js', import.meta.url), { type: 'module' }),
};
