import type { ModuleName } from './base/builds.js';
import { AbflatError } from './base/errors.js';

/** For Node. Bundlers find the files by exactly these expressions. */
export function wasmFile(name: ModuleName): URL {
  if (!import.meta.url)
    throw new AbflatError(
      'UnreadableFile',
      'A bundle that is not an ES module cannot find its files. Pass baseUrl to createAbflat.',
    );
  switch (name) {
    case 'simd':
      return new URL('./abflat-simd.wasm', import.meta.url);
    case 'threads':
      return new URL('./abflat-threads.wasm', import.meta.url);
    case 'pack':
      return new URL('./abflat-pack.wasm', import.meta.url);
    case 'bake':
      return new URL('./abflat-bake.wasm', import.meta.url);
  }
}
