import { isModule } from './base/build-of.js';
import type { Build, LateName, ModuleName } from './base/builds.js';
import { checkHost } from './base/check-host.js';
import { AbflatError, messageOf } from './base/errors.js';
import { MODULE_STATUS_COUNT, STATUS_NAMES } from './base/generated.js';
import type { Description } from './messages/protocol.js';
import type { Address, Files } from './platform.js';

/** That at an address; the one beside the scripts if none is given. */
export async function moduleFrom<Name extends ModuleName>(
  files: Files<Name>,
  name: Name,
  address: Address | undefined,
): Promise<WebAssembly.Module> {
  checkHost();
  return files.loadModule(name, address).catch((error: unknown) => {
    throw new AbflatError('UnreadableFile', messageOf(error), 'module');
  });
}

/** The same for a module besides the main one. */
export async function lateModule(
  files: Files<LateName>,
  name: LateName,
  address: Address | undefined,
): Promise<WebAssembly.Module> {
  const module = await moduleFrom(files, name, address);
  if (isModule(module, name)) return module;
  throw new AbflatError(
    'UnreadableFile',
    `The file at ${name}Url is not the module of this version of abflat that ${name}s.`,
  );
}

/** A module at an address of the caller's may be of another build. */
export function checkFound(
  found: Build,
  wanted: Build | undefined,
  address: Address | undefined,
): void {
  if (wanted === undefined || wanted === found) return;
  throw new AbflatError(
    'InvalidOption',
    `build is ${wanted}, but ${address ?? 'the module'} is ${found}.`,
  );
}

/** The module and these files have to number statuses alike. */
export function checkVersion({ statuses }: Description): void {
  if (statuses.join() === STATUS_NAMES.slice(0, MODULE_STATUS_COUNT).join()) return;
  throw new AbflatError(
    'Internal',
    'The versions of the module and of abflat differ. Use files of one version.',
  );
}
