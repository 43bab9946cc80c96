import type { OwnFile } from './platform-browser.js';

/** Bundlers find the files by exactly these expressions, and copy those of each build that is imported. */
export const simd: OwnFile = {
  wasm: () => new URL('./abflat-simd.wasm', import.meta.url),
  worker: () => new Worker(new URL('./worker-simd.js', import.meta.url), { type: 'module' }),
};
