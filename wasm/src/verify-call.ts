// What `verify` asks of the module that packs.

import { VERIFY_DEFAULTS, VERIFY_OPTIONS } from './base/generated-verify.js';
import type { Call } from './call.js';
import { type Taking, takeMesh } from './messages/input.js';
import type { VerifyRequest } from './messages/protocol.js';
import {
  checkFunction,
  checkSignal,
  knownOptions,
  optionNumbers,
  triangleUv,
} from './messages/validate.js';
import type { MeshInput, VerifyOptions } from './types/index.js';

const KEYS = [...Object.keys(VERIFY_OPTIONS), 'uv', 'onProgress', 'signal', 'transfer'];

/** `taking`: the module may not be there yet. */
export function verifyCall(taking: Taking, mesh: MeshInput, given: VerifyOptions): Call {
  const options = knownOptions(given, KEYS);
  const { signal, transfer, onProgress } = options;
  checkFunction('onProgress', onProgress);
  checkSignal(signal);
  if (signal?.aborted) throw signal.reason;
  const values = optionNumbers(options, VERIFY_OPTIONS, VERIFY_DEFAULTS);
  const uv = triangleUv(options.uv);
  const owned = takeMesh(mesh, transfer, taking);
  const request: VerifyRequest = {
    kind: 'verify',
    mesh: owned.mesh,
    uv,
    values,
    wantsProgress: onProgress !== undefined,
  };
  const buffers = [...owned.buffers, ...(uv ? [uv.buffer as ArrayBuffer] : [])];
  return { request, settings: { transfer: buffers, signal, onProgress } };
}
