// What bakes, loaded when it is first needed: its module runs in a worker of its own.

import { bakeCall } from './bake-call.js';
import { type LateClient, type LateSettings, lateClient } from './late-client.js';
import type { Platform } from './platform.js';
import type { BakedImage, BakeOptions } from './types/index.js';

export class Baker {
  readonly #client: LateClient;

  constructor(platform: Platform, settings: LateSettings) {
    this.#client = lateClient(platform, 'bake', settings);
  }

  async bake(
    mesh: unknown,
    layout: unknown,
    sources: unknown,
    given: BakeOptions,
  ): Promise<BakedImage> {
    const { request, settings } = bakeCall(mesh, layout, sources, given);
    const client = await this.#client.get();
    client.checkUsable(settings.signal);
    return client.call<BakedImage>(request, settings);
  }

  terminate(): void {
    this.#client.whenStarted((client) => client.terminate());
  }
}
