import type { Build } from './builds.js';

/** Bundlers find the files by exactly these expressions; not in builds.ts, which the worker loads as well. */
export function wasmFile(build: Build): URL {
  return build === 'simd'
    ? new URL('./abflat-simd.wasm', import.meta.url)
    : new URL('./abflat.wasm', import.meta.url);
}
