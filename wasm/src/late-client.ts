// Calls of a module besides the main one: it is loaded with the first call, and runs in a worker of
// its own.

import type { LateName } from './base/builds.js';
import { startOnce } from './base/start-once.js';
import { Client } from './client.js';
import { lateModule } from './load-module.js';
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
  const module = await lateModule(platform, name, moduleUrl);
  return new Client(platform, { module, name, maxMemory, workerUrl });
}
