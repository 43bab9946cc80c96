// The call that the module for packing answers. Runs in the worker, where it may block.

import type { PackModule } from './abflat-pack.js';
import { AbflatError } from './base/errors.js';
import type { Instance } from './instantiate.js';
import { MeshHeap } from './mesh-heap.js';
import { MeshRunner } from './mesh-runner.js';
import type { Answer, PackRequest, Request } from './messages/protocol.js';
import type { PackReport, PackResult } from './types/index.js';

export class PackEngine extends MeshRunner<PackModule> {
  static of({ native, memory, hooks }: Instance<PackModule>, maxMemory: number): PackEngine {
    return new PackEngine(native, new MeshHeap(native, memory, maxMemory), hooks);
  }

  protected answer(request: Request): Answer {
    if (request.kind !== 'pack')
      throw new AbflatError('Internal', `The module that packs does not ${request.kind}.`);
    return this.#pack(request);
  }

  #pack(request: PackRequest): PackResult {
    return this.withLayout<PackReport, PackResult>(request, {
      set: (job, native) => {
        this.setOptions(job, request.values, native._abflatSetPackOption);
        const { uv, islands, tileOfIsland } = request.arrays;
        if (uv) this.heap.writeReals(native._abflatTriangleUv(job, uv.length), uv);
        if (islands)
          this.heap.writeNumbers(native._abflatPackedIslands(job, islands.length), islands);
        if (tileOfIsland)
          this.heap.writeNumbers(native._abflatIslandTiles(job, tileOfIsland.length), tileOfIsland);
      },
      run: this.native._abflatPack,
      complete: (layout, job) => ({
        ...layout,
        islandOfTriangle: this.heap.read(job, 'chartOfTriangle'),
        faults: this.heap.read(job, 'faults'),
      }),
    });
  }
}
