import { WRITTEN_FORMATS } from './base/generated.js';
import type { Call } from './call.js';
import { type Taking, takeMesh } from './messages/input.js';
import type { LayoutRequest, Request } from './messages/protocol.js';
import { checkBoolean, checkFunction, checkSignal } from './messages/validate.js';
import type { FlattenOptions, MeshInput, PackOptions, UnwrapOptions } from './types/index.js';

/**
 * Takes what the caller gave, at once, unless it is refused or aborted. `complete` adds the rest of
 * the request, whose buffers are `buffers`.
 */
export function layoutCall(
  taking: Taking,
  mesh: MeshInput,
  options: FlattenOptions | UnwrapOptions | PackOptions,
  complete: (common: LayoutRequest) => Request,
  buffers: ArrayBuffer[] = [],
): Call {
  const { roundsForGltf, transfer, signal, onProgress } = options;
  for (const name of WRITTEN_FORMATS) checkBoolean(name, options[name]);
  checkBoolean('roundsForGltf', roundsForGltf);
  checkFunction('onProgress', onProgress);
  checkSignal(signal);
  if (signal?.aborted) throw signal.reason;
  const owned = takeMesh(mesh, transfer, taking);
  const common: LayoutRequest = {
    mesh: owned.mesh,
    files: WRITTEN_FORMATS.filter((name) => options[name]),
    wantsProgress: onProgress !== undefined,
    roundsForGltf: roundsForGltf === true,
  };
  const settings = { transfer: [...owned.buffers, ...buffers], signal, onProgress };
  return { request: complete(common), settings };
}
