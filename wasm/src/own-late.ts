import type { LateName } from './base/builds.js';
import type { OwnFile } from './platform-browser.js';

/**
 * As in own-simd.ts. There is a worker per module because not all worker formats that bundlers write
 * allow parts to be loaded later.
 */
export const late: Record<LateName, OwnFile> = {
  pack: {
    wasm: () => new URL('./abflat-pack.wasm', import.meta.url),
    worker: () => new Worker(new URL('./worker-pack.js', import.meta.url), { type: 'module' }),
  },
  bake: {
    wasm: () => new URL('./abflat-bake.wasm', import.meta.url),
    worker: () => new Worker(new URL('./worker-bake.js', import.meta.url), { type: 'module' }),
  },
};
