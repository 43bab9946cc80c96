// Not in builds.ts: types that callers see must not mention WebAssembly, which only some libraries
// declare.

import { BUILDS, type Build, type ModuleName } from './builds.js';
import { AbflatError } from './errors.js';

/** The name in a custom section of the module, which wasm/build.mjs adds. */
function labelOf(module: WebAssembly.Module): string | undefined {
  const [section] = WebAssembly.Module.customSections(module, 'abflat.build');
  return section && new TextDecoder().decode(section);
}

export const isModule = (module: WebAssembly.Module, name: ModuleName) => labelOf(module) === name;

/** The build of the main module. */
export function buildOf(module: WebAssembly.Module): Build {
  const name = labelOf(module);
  const build = BUILDS.find((each) => each === name);
  if (build) return build;
  throw new AbflatError(
    'UnreadableFile',
    'The file at wasmUrl is not a WebAssembly module of this version of abflat.',
  );
}
