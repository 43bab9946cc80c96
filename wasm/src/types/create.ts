// How the package's files are found, and what runs them.

import type { Build, LateName } from '../base/builds.js';

/** A URL, no matter which library declares the type. */
export interface UrlLike {
  readonly href: string;
}

/** A WebAssembly.Module, no matter which library declares the type. */
export type CompiledModule = object;

/** Where a file of WebAssembly is, or what it holds: compiled, or as bytes. */
export type ModuleSource = string | UrlLike | ArrayBuffer | Uint8Array | CompiledModule;

/** What `createAbflat` and `createAbflatSync` have in common. */
export interface ModuleOptions {
  /** Which build of the module to use. Default: the fastest that runs here. */
  build?: Build;
  /** The most memory that a mesh may take, in bytes: 16 MB to 4 GB. Default: 4 GB. */
  maxMemory?: number;
  /**
   * Location of the package's `dist` folder, if a bundler does not copy the files it needs; in Node
   * a path works too.
   */
  baseUrl?: string | UrlLike;
  /**
   * Location of abflat-simd.wasm or abflat-threads.wasm, if it is not beside the scripts, in Node
   * also a path; or the module itself.
   */
  wasmUrl?: ModuleSource;
  /** The same for abflat-pack.wasm, which `pack` and `verify` need. */
  packUrl?: ModuleSource;
  /** The same for abflat-bake.wasm, which `bake` needs. */
  bakeUrl?: ModuleSource;
}

export interface CreateOptions extends ModuleOptions {
  /** Location of `worker.js`, if it is not beside the module. It can run every module. */
  workerUrl?: string | UrlLike;
  /**
   * How many meshes to work on at a time, each in a worker of its own: 1 to 64. `maxMemory` is for
   * each. With several, `build` is one without threads by default. Default: 1.
   */
  workers?: number;
  /**
   * How many calls may wait with copies of their arrays. Later ones wait before they read their
   * arguments, so leave these alone until the promise settles. Default: all copy at once.
   */
  queue?: number;
}

export interface CreateSyncOptions extends ModuleOptions {
  /** Modules to load besides the main one, for the methods of these names. */
  also?: readonly LateName[];
}
