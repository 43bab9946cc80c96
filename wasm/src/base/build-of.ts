// Not in builds.ts: types that callers see must not mention WebAssembly, which only some libraries
// declare.

import { BUILDS, type Build } from './builds.js';
import { AbflatError } from './errors.js';

/** The build named in a custom section of the module, which wasm/build.mjs adds. */
export function buildOf(module: WebAssembly.Module): Build {
  const [section] = WebAssembly.Module.customSections(module, 'abflat.build');
  const name = section && new TextDecoder().decode(section);
  const build = BUILDS.find((each) => each === name);
  if (build) return build;
  throw new AbflatError(
    'UnreadableFile',
    'The file at wasmUrl is not a WebAssembly module of this version of abflat.',
  );
}
