// What bakes, loaded when it is first needed: its module runs in a worker of its own.

import { isBake } from './base/build-of.js';
import { AbflatError, messageOf } from './base/errors.js';
import { BAKE_DEFAULTS, BAKE_OPTIONS } from './base/generated-bake.js';
import { startOnce } from './base/start-once.js';
import { Client } from './client.js';
import { takeBakeLayout, takeBakeMesh } from './messages/bake-input.js';
import { takeSources } from './messages/bake-sources.js';
import type { BakeRequest } from './messages/protocol.js';
import { checkFunction, checkSignal, knownOptions, optionNumbers } from './messages/validate.js';
import type { Address, Platform } from './platform.js';
import type { BakedImage, BakeOptions } from './types/index.js';

export interface BakerSettings {
  maxMemory: number;
  /** Where the module and the script of its worker are, if not beside the package's modules. */
  moduleUrl?: Address | undefined;
  workerUrl?: Address | undefined;
}

const KEYS = [...Object.keys(BAKE_OPTIONS), 'onProgress', 'signal'];

export class Baker {
  readonly #platform: Platform;
  readonly #settings: BakerSettings;
  readonly #client = startOnce(() => this.#load());

  constructor(platform: Platform, settings: BakerSettings) {
    this.#platform = platform;
    this.#settings = settings;
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

  async #load(): Promise<Client> {
    const { maxMemory, moduleUrl, workerUrl } = this.#settings;
    const module = await this.#platform.loadModule('bake', moduleUrl).catch((error: unknown) => {
      throw new AbflatError('UnreadableFile', messageOf(error), 'module');
    });
    if (!isBake(module))
      throw new AbflatError(
        'UnreadableFile',
        'The file at bakeUrl is not the module for baking of this version of abflat.',
      );
    return new Client(this.#platform, { module, name: 'bake', maxMemory, workerUrl });
  }

  terminate(): void {
    this.#client.whenStarted((client) => client.terminate());
  }
}
