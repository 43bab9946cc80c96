// The module is built more than once from the same source. All builds give the same results to the last bit.

/**
 * Both need 128-bit vectors. `simd` runs on one processor; `threads` runs on several and needs a
 * cross-origin isolated page.
 */
export type Build = 'simd' | 'threads';

/** What few pages need is in modules of their own: one packs and verifies layouts that are there, one bakes. */
export type LateName = 'pack' | 'bake';

/** A module of the package: a build of the main one, or one of the others. */
export type ModuleName = Build | LateName;

/** Those that run in any thread. */
export type LocalName = Exclude<ModuleName, 'threads'>;

export const BUILDS: readonly Build[] = ['simd', 'threads'];

/**
 * The fastest build that runs here. A browser may still refuse the memory or the extra workers that
 * `threads` needs, which only shows on trying; createAbflat then takes the next build.
 */
export function bestBuild(): Build {
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
