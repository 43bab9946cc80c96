// What `bake` asks of its module.

import { BAKE_DEFAULTS, BAKE_OPTIONS } from './base/generated-bake.js';
import type { Call } from './call.js';
import { takeBakeLayout, takeBakeMesh } from './messages/bake-input.js';
import { takeSources } from './messages/bake-sources.js';
import type { BakeRequest } from './messages/protocol.js';
import { checkFunction, checkSignal, knownOptions, optionNumbers } from './messages/validate.js';
import type { BakeOptions } from './types/index.js';

const KEYS = [...Object.keys(BAKE_OPTIONS), 'onProgress', 'signal'];

/** Copies the arrays. */
export function bakeCall(
  mesh: unknown,
  layout: unknown,
  sources: unknown,
  given: BakeOptions,
): Call {
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
  const arrays = [
    ...Object.values(request.mesh),
    ...Object.values(request.layout),
    ...request.images,
  ];
  const transfer = arrays.map((array) => array.buffer as ArrayBuffer);
  return { request, settings: { transfer, signal, onProgress } };
}
