// Calls of a module besides the main one: it is loaded with the first call, and runs in a worker of
// its own.

import { isModule } from './base/build-of.js';
import type { LateName } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { startOnce } from './base/start-once.js';
import { Client } from './client.js';
import type { Address, Platform } from './platform.js';

export interface LateSettings {
  maxMemory: number;
  /** Where the module and the script of its worker are, if not beside the package's modules. */
  moduleUrl?: Address | undefined;
  workerUrl?: Address | undefined;
}

export type LateClient = ReturnType<typeof lateClient>;

export const lateClient = (platform: Platform, name: LateName, settings: LateSettings) =>
  startOnce(() => load(platform, name, settings));

async function load(platform: Platform, name: LateName, settings: LateSettings): Promise<Client> {
  const { maxMemory, moduleUrl, workerUrl } = settings;
  const module = await platform.loadModule(name, moduleUrl).catch((error: unknown) => {
    throw new AbflatError('UnreadableFile', messageOf(error), 'module');
  });
  if (!isModule(module, name))
    throw new AbflatError(
      'UnreadableFile',
      `The file at ${name}Url is not the module of this version of abflat that ${name}s.`,
    );
  return new Client(platform, { module, name, maxMemory, workerUrl });
}
