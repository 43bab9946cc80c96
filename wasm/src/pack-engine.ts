// The calls that the module for layouts that a mesh has answers. Runs in the worker, where it may block.

import type { PackModule } from './abflat-pack.js';
import { AbflatError } from './base/errors.js';
import type { Instance } from './instantiate.js';
import { MeshHeap } from './mesh-heap.js';
import { MeshRunner } from './mesh-runner.js';
import type { Answer, PackRequest, Request, VerifyRequest } from './messages/protocol.js';
import type { PackReport, PackResult, VerifyReport, VerifyResult } from './types/index.js';

export class PackEngine extends MeshRunner<PackModule> {
  static of({ native, memory, hooks }: Instance<PackModule>, maxMemory: number): PackEngine {
    return new PackEngine(native, new MeshHeap(native, memory, maxMemory), hooks);
  }

  protected answer(request: Request): Answer {
    if (request.kind === 'pack') return this.#pack(request);
    if (request.kind === 'verify') return this.#verify(request);
    throw new AbflatError('Internal', `The module that packs does not ${request.kind}.`);
  }

  #pack(request: PackRequest): PackResult {
    return this.withLayout<PackReport, PackResult>(request, {
      set: (job, native) => {
        this.setOptions(job, request.values, native._abflatSetPackOption);
        const { uv, islands, tileOfIsland } = request.arrays;
        this.#writeUv(job, uv);
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

  #verify({ mesh, uv, values }: VerifyRequest): VerifyResult {
    const started = performance.now();
    return this.withJob((job) => {
      this.heap.writeMesh(job, mesh);
      const written = performance.now();
      this.setOptions(job, values, this.native._abflatSetVerifyOption);
      this.#writeUv(job, uv);
      this.check(job, this.native._abflatVerify(job));
      const report = JSON.parse(this.heap.readText(job)) as VerifyReport;
      const result = {
        report,
        islandOfFace: this.heap.read(job, 'islandOfFace'),
        faces: this.heap.read(job, 'faces'),
        faults: this.heap.read(job, 'faults'),
      };
      report.timings.read += (written - started) / 1000;
      report.timings.total = (performance.now() - started) / 1000;
      return result;
    });
  }

  #writeUv(job: number, uv: Float64Array | undefined): void {
    if (uv) this.heap.writeReals(this.native._abflatTriangleUv(job, uv.length), uv);
  }
}
