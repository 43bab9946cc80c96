// How Node finds and reads the package's files.

import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { ModuleName } from './base/builds.js';
import { messageOf } from './base/errors.js';
import { browserFiles } from './files-browser.js';
import { type Address, type FileBeside, type Files, textOf } from './platform.js';

/** Advice if no address was given. */
export const KEEP =
  "A bundler may have left it out. Keep abflat out of the bundle (external: ['abflat'], in Next serverExternalPackages: ['abflat']), " +
  'or pass the location of its folder dist (createAbflat({ baseUrl })).';

export function nodeFiles<Name extends ModuleName>(beside: FileBeside<Name>): Files<Name> {
  const remote = browserFiles(beside);
  return {
    fileIn: (folder, name) =>
      isRemote(folder) ? remote.fileIn(folder, name) : join(pathOf(folder), name),

    async loadModule(name, address) {
      if (address && isRemote(address)) return remote.loadModule(name, address);
      const path = pathOf(address ?? beside(name));
      let bytes: Uint8Array<ArrayBuffer>;
      try {
        bytes = await readFile(path);
      } catch (error) {
        throw new Error(`Cannot load ${path}: ${messageOf(error)}.${address ? '' : ` ${KEEP}`}`);
      }
      try {
        return await WebAssembly.compile(bytes);
      } catch (error) {
        throw new Error(`${path} is not a WebAssembly module: ${messageOf(error)}`);
      }
    },
  };
}

const isRemote = (address: Address) => /^https?:/.test(textOf(address));

export function pathOf(address: Address): string {
  return textOf(address).startsWith('file:') ? fileURLToPath(textOf(address)) : textOf(address);
}
