import type { Build } from './builds.js';

/** Bundlers find the files by exactly these expressions; not in builds.ts, which the worker loads as well. */
export function wasmFile(build: Build): URL {
  switch (build) {
    case 'plain':
      return new URL('./abflat.wasm', import.meta.url);
    case 'simd':
      return new URL('./abflat-simd.wasm', import.meta.url);
    case 'threads':
      return new URL('./abflat-threads.wasm', import.meta.url);
  }
}
