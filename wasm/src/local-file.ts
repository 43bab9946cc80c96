import type { LocalName } from './base/builds.js';
import { AbflatError } from './base/errors.js';

/**
 * As wasmFile, for what runs in any thread: so that bundles without workers have no copy of the
 * build with threads.
 */
export function localFile(name: LocalName): URL {
  if (!import.meta.url)
    throw new AbflatError(
      'UnreadableFile',
      'A bundle that is not an ES module cannot find its files.',
    );
  switch (name) {
    case 'simd':
      return new URL('./abflat-simd.wasm', import.meta.url);
    case 'pack':
      return new URL('./abflat-pack.wasm', import.meta.url);
    case 'bake':
      return new URL('./abflat-bake.wasm', import.meta.url);
  }
}
