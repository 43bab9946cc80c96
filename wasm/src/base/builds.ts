// The module is built more than once from the same source. All builds give the same results to the last bit.

/**
 * `plain` runs wherever WebAssembly does; `simd` needs 128-bit vectors and is faster; `threads` is
 * `simd` on several processors and needs a cross-origin isolated page.
 */
export type Build = 'plain' | 'simd' | 'threads';

/** What few pages need is in modules of their own: one packs layouts that are there, one bakes. */
export type LateName = 'pack' | 'bake';

/** A module of the package: a build of the main one, or one of the others. */
export type ModuleName = Build | LateName;

/** Those that run in any thread. */
export type LocalName = Exclude<ModuleName, 'threads'>;

export const BUILDS: readonly Build[] = ['plain', 'simd', 'threads'];

/** A module with one vector instruction, i8x16.popcnt, which drafts of the vector proposal did not have yet. */
const WITH_VECTORS = new Uint8Array([
  ...[0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0], // magic, version
  ...[1, 5, 1, 0x60, 0, 1, 0x7b], // type: () -> v128
  ...[3, 2, 1, 0], // function 0 has it
  ...[10, 10, 1, 8, 0, 0x41, 0, 0xfd, 15, 0xfd, 98, 0x0b], // i32.const 0, i8x16.splat, i8x16.popcnt, end
]);

export const hasVectors = () => WebAssembly.validate(WITH_VECTORS);

/**
 * The fastest build that runs here. A browser may still refuse the memory or the extra workers that
 * `threads` needs, which only shows on trying; createAbflat then takes the next build.
 */
export function bestBuild(): Build {
  if (!hasVectors()) return 'plain';
  return whyNoThreads() === undefined && navigator.hardwareConcurrency > 1 ? 'threads' : 'simd';
}

/** Why the `threads` build cannot run here; undefined if it can. */
export function whyNoThreads(): string | undefined {
  if (typeof Worker === 'undefined') return 'there are no Web Workers here';
  if (globalThis.crossOriginIsolated !== true || typeof SharedArrayBuffer === 'undefined')
    return (
      'the page is not cross-origin isolated. Serve it with the headers ' +
      '"Cross-Origin-Opener-Policy: same-origin" and "Cross-Origin-Embedder-Policy: require-corp"'
    );
  return undefined;
}
