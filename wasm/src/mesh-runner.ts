// A module that is given a mesh and may return a layout.

import { RESULT_ARRAYS } from './base/generated-arrays.js';
import type { InputModule } from './input-module.js';
import type { MeshHeap } from './mesh-heap.js';
import type { LayoutRequest } from './messages/protocol.js';
import { type Jobs, Runner } from './runner.js';
import type { Layout, LayoutTimings } from './types/index.js';

/** What differs between the calls that return a layout. */
interface LayoutSteps<N, R, T> {
  set(job: number, native: N): void;
  run(job: number, files: number, roundsForGltf: boolean): number;
  complete(layout: Layout<R>, job: number): T;
}

export abstract class MeshRunner<N extends InputModule & Jobs> extends Runner<N, MeshHeap> {
  protected readonly task = 'mesh';
  protected readonly advice = 'Use a mesh with fewer faces';

  protected withLayout<R extends { timings: LayoutTimings }, T extends Layout<R>>(
    { mesh, files, roundsForGltf }: LayoutRequest,
    { set, run, complete }: LayoutSteps<N, R, T>,
  ): T {
    const started = performance.now();
    return this.withJob((job) => {
      this.heap.writeMesh(job, mesh);
      const written = performance.now();
      set(job, this.native);
      const wanted = files.reduce((bits, name) => bits | (1 << RESULT_ARRAYS[name].field), 0);
      this.check(job, run(job, wanted, roundsForGltf));
      const finished = performance.now();
      const layout: Layout<R> = {
        uv: this.heap.read(job, 'uv'),
        indices: this.heap.read(job, 'indices'),
        vertexMap: this.heap.read(job, 'vertexMap'),
        report: JSON.parse(this.heap.readText(job)) as R,
      };
      if ('bytes' in mesh) layout.positions = this.heap.read(job, 'positions');
      for (const name of files) layout[name] = this.heap.read(job, name);
      const result = complete(layout, job);
      const { timings } = result.report;
      const now = performance.now();
      timings.read += (written - started) / 1000;
      timings.write += (now - finished) / 1000;
      timings.total = (now - started) / 1000;
      return result;
    });
  }

  protected setOptions(
    job: number,
    values: number[],
    set: (job: number, index: number, value: number) => number,
  ): void {
    values.forEach((value, index) => {
      this.check(job, set(job, index, value));
    });
  }

  protected readText(job: number): string {
    return this.heap.readText(job);
  }
}
