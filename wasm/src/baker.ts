// What bakes, loaded when it is first needed: its module runs in a worker of its own.

import { BAKE_DEFAULTS, BAKE_OPTIONS } from './base/generated-bake.js';
import { type LateClient, type LateSettings, lateClient } from './late-client.js';
import { takeBakeLayout, takeBakeMesh } from './messages/bake-input.js';
import { takeSources } from './messages/bake-sources.js';
import type { BakeRequest } from './messages/protocol.js';
import { checkFunction, checkSignal, knownOptions, optionNumbers } from './messages/validate.js';
import type { Platform } from './platform.js';
import type { BakedImage, BakeOptions } from './types/index.js';

const KEYS = [...Object.keys(BAKE_OPTIONS), 'onProgress', 'signal'];

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
    const options = knownOptions(given, KEYS);
    const { signal, onProgress } = options;
    checkFunction('onProgress', onProgress);
    checkSignal(signal);
    const values = optionNumbers(options, BAKE_OPTIONS, BAKE_DEFAULTS);
    const ownMesh = takeBakeMesh(mesh);
    const request: BakeRequest = {
      kind: 'bake',
      mesh: ownMesh,
      layout: takeBakeLayout(layout, ownMesh),
      ...takeSources(sources, (options.kind ?? BAKE_DEFAULTS.kind) === 'colour'),
      values,
      wantsProgress: onProgress !== undefined,
    };
    const client = await this.#client.get();
    client.checkUsable(signal);
    const arrays = [
      ...Object.values(request.mesh),
      ...Object.values(request.layout),
      ...request.images,
    ];
    const transfer = arrays.map((array) => array.buffer as ArrayBuffer);
    return client.call<BakedImage>(request, { transfer, signal, onProgress });
  }

  terminate(): void {
    this.#client.whenStarted((client) => client.terminate());
  }
}
