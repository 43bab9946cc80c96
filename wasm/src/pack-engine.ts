// The call that the module for packing answers. Runs in the worker, where it may block.

import type { PackModule } from './abflat-pack.js';
import { AbflatError } from './base/errors.js';
import { MeshRunner } from './mesh-runner.js';
import type { Answer, PackRequest, Request } from './messages/protocol.js';
import type { PackReport, PackResult } from './types/index.js';

export class PackEngine extends MeshRunner<PackModule> {
  protected answer(request: Request): Answer {
    if (request.kind !== 'pack')
      throw new AbflatError('Internal', `The module that packs does not ${request.kind}.`);
    return this.#pack(request);
  }

  #pack(request: PackRequest): PackResult {
    return this.withLayout<PackReport, PackResult>(request, {
      set: (job, native) => this.setOptions(job, request.values, native._abflatSetPackOption),
      run: this.native._abflatPack,
      complete: (layout, job) => ({
        ...layout,
        islandOfTriangle: this.heap.read(job, 'chartOfTriangle'),
        faults: this.heap.read(job, 'faults'),
      }),
    });
  }
}
