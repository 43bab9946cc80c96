import type { Build } from './base/builds.js';
import type { NativeModule } from './native-module.js';

/** What a module is given when it is made. */
export interface NativeSettings {
  wasmMemory: WebAssembly.Memory;
  /** Only for a module with threads. */
  mainScriptUrlOrBlob?: string;
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ): object;
  print(text: string): void;
  printErr(text: string): void;
  /** Returns whether to go on. */
  onProgress(stage: number, newtonStep: number, residual: number, fraction: number): boolean;
  onOutOfMemory(): never;
}

/** What the script that Emscripten wrote for a module exports. */
export type CreateModule<N> = (settings: NativeSettings) => Promise<N>;

/** The script that Emscripten wrote for a build. Minified names may differ between builds, so each module needs its own. */
export interface Glue {
  create: CreateModule<NativeModule>;
  /** The script that each thread loads, for a build with threads. */
  threadScript?: () => string;
}

/** The builds that a worker brings along: loading one does not load the scripts of the others. */
export type Glues = Partial<Record<Build, Glue>>;
