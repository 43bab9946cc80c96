import type { ModuleName } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import type { Address, Files } from './platform.js';

export function fileIn(
  files: Pick<Files, 'fileIn'>,
  folder: Address | undefined,
  name: string,
): string | undefined {
  if (!folder) return undefined;
  try {
    return files.fileIn(folder, name);
  } catch (error) {
    throw new AbflatError('InvalidOption', `baseUrl is not a valid URL: ${messageOf(error)}.`);
  }
}

/** Only the name of the file. */
export const wasmName = (name: ModuleName) => `abflat-${name}.wasm`;
