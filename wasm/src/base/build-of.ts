// Not in builds.ts: types that callers see know nothing of WebAssembly, which only some libraries declare.

import { BUILDS, type Build } from './builds.js';
import { AbflatError } from './errors.js';

/** As the module says in a section of its own, written by wasm/build.mjs. */
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
