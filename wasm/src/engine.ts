// The calls that the WebAssembly module answers. Runs in the worker, where it may block.

import type { NativeModule } from './abflat.js';
import { buildOf } from './base/build-of.js';
import type { Build } from './base/builds.js';
import { AbflatError } from './base/errors.js';
import { RESULT_ARRAYS } from './base/generated-arrays.js';
import type { Glues } from './glue.js';
import { instantiate } from './instantiate.js';
import { MeshHeap } from './mesh-heap.js';
import type {
  Answer,
  Description,
  FlattenRequest,
  LayoutRequest,
  OwnedMesh,
  PackRequest,
  PinNumbers,
  Request,
  UnwrapRequest,
} from './messages/protocol.js';
import { Runner } from './runner.js';
import type {
  Comparison,
  FlattenResult,
  Layout,
  LayoutTimings,
  LoadedMesh,
  MeshSummary,
  PackReport,
  PackResult,
  PinWeights,
  Report,
  TriangleMesh,
  UnwrapReport,
  UnwrapResult,
} from './types/index.js';

/** What differs between the calls that return a layout. */
interface LayoutSteps<R, T> {
  set(job: number, native: NativeModule): void;
  run(job: number, files: number, roundsForGltf: boolean): number;
  complete(layout: Layout<R>, job: number): T;
}

export class Engine extends Runner<NativeModule, MeshHeap> {
  protected readonly task = 'mesh';
  protected readonly advice = 'Use a mesh with fewer faces';

  static async create(
    module: WebAssembly.Module,
    maxMemory: number,
    glues: Glues,
  ): Promise<Engine> {
    const build = buildOf(module);
    const glue = glues[build];
    if (!glue) throw new AbflatError('Internal', `This worker does not run the build ${build}.`);
    const { create, threadScript } = glue;
    const { native, memory, hooks } = await instantiate(module, create, {
      maxMemory,
      isShared: build === 'threads',
      threadScript,
    });
    return new Engine(native, new MeshHeap(native, memory, maxMemory), hooks);
  }

  protected answer(request: Request): Answer {
    switch (request.kind) {
      case 'describe':
        return this.#describe();
      case 'flatten':
        return this.#flatten(request);
      case 'unwrap':
        return this.#unwrap(request);
      case 'pack':
        return this.#pack(request);
      case 'compare':
        return this.withJob((job) => this.#compare(job, request.mesh));
      case 'inspect':
        return this.withJob((job) => this.#inspect(job, request.mesh));
      case 'pinWeights':
        return this.withJob((job) => this.#pinWeights(job, request.mesh, request.pins));
      case 'load':
        return this.withJob((job) => this.#load(job, request.mesh));
      case 'sample':
        return this.withJob((job) => this.#sample(job, request.name, request.detail));
      case 'bake':
        throw new AbflatError('Internal', 'Images are baked by another module.');
    }
  }

  #describe(): Description {
    const native = this.native;
    const list = (count: number, name: (index: number) => number) =>
      Array.from({ length: count }, (_, index) => this.heap.readString(name(index)));
    return {
      build: this.heap.readString(native._abflatBuild()) as Build,
      statuses: list(native._abflatStatusCount(), native._abflatStatusName),
      samples: list(native._abflatSampleCount(), native._abflatSampleName),
    };
  }

  #flatten(request: FlattenRequest): FlattenResult {
    const { values, pins, bounds, straight, normalizes } = request;
    return this.#withLayout<Report, FlattenResult>(request, {
      set: (job, native) => {
        this.#setOptions(job, values, native._abflatSetOption);
        this.#setPins(job, pins);
        for (let i = 0; i < bounds.length; i += 2)
          native._abflatAddBound(job, bounds[i] as number, bounds[i + 1] as number);
        for (const [from, to] of straight) native._abflatAddStraight(job, from, to);
        if (normalizes) native._abflatNormalizes(job);
      },
      run: this.native._abflatFlatten,
      complete: (layout) => layout,
    });
  }

  #unwrap(request: UnwrapRequest): UnwrapResult {
    const { values, pins, seams, arrays, keepsUv, keepsValidOnly, keepsPlaces, known } = request;
    return this.#withLayout<UnwrapReport, UnwrapResult>(request, {
      set: (job, native) => {
        this.#setOptions(job, values, native._abflatSetUnwrapOption);
        this.#setPins(job, pins);
        if (seams !== undefined)
          this.heap.writeText(seams, (bytes) => native._abflatSeams(job, bytes));
        arrays.forEach((array, which) => {
          if (array) this.heap.writeArray(job, which, array);
        });
        if (keepsUv) native._abflatKeepUv(job);
        if (keepsValidOnly) native._abflatKeepsValidOnly(job);
        if (keepsPlaces) native._abflatKeepsPlaces(job);
        if (known !== undefined) this.heap.writeKnown(job, known);
      },
      run: this.native._abflatUnwrap,
      complete: (layout, job) => ({
        ...layout,
        chartOfTriangle: this.heap.read(job, 'chartOfTriangle'),
        seams: this.heap.read(job, 'seams'),
        unpacked: this.heap.read(job, 'unpacked'),
      }),
    });
  }

  #pack(request: PackRequest): PackResult {
    return this.#withLayout<PackReport, PackResult>(request, {
      set: (job, native) => this.#setOptions(job, request.values, native._abflatSetPackOption),
      run: this.native._abflatPack,
      complete: (layout, job) => ({
        ...layout,
        islandOfTriangle: this.heap.read(job, 'chartOfTriangle'),
        faults: this.heap.read(job, 'faults'),
      }),
    });
  }

  #withLayout<R extends { timings: LayoutTimings }, T extends Layout<R>>(
    { mesh, files, roundsForGltf }: LayoutRequest,
    { set, run, complete }: LayoutSteps<R, T>,
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

  #setOptions(job: number, values: number[], set: NativeModule['_abflatSetOption']): void {
    values.forEach((value, index) => {
      this.check(job, set(job, index, value));
    });
  }

  #setPins(job: number, pins: PinNumbers[]): void {
    for (const [vertex, u, v, face] of pins) this.native._abflatAddPin(job, vertex, u, v, face);
  }

  #compare(job: number, mesh: OwnedMesh): Comparison {
    this.heap.writeMesh(job, mesh);
    const native = this.native;
    this.check(job, native._abflatCompare(job));
    const found = JSON.parse(this.heap.readText(job)) as Pick<
      Comparison,
      'version' | 'input' | 'methods'
    >;
    for (const [i, method] of found.methods.entries()) {
      const start = native._abflatMethodUvData(job, i);
      method.uv = new Float64Array(this.heap.copy(start, native._abflatMethodUvSize(job, i)));
    }
    const result: Comparison = {
      ...found,
      indices: this.heap.read(job, 'indices'),
      vertexMap: this.heap.read(job, 'vertexMap'),
    };
    if ('bytes' in mesh) result.positions = this.heap.read(job, 'positions');
    return result;
  }

  #inspect(job: number, mesh: OwnedMesh): MeshSummary {
    this.heap.writeMesh(job, mesh);
    this.check(job, this.native._abflatInspect(job));
    return JSON.parse(this.heap.readText(job)) as MeshSummary;
  }

  #pinWeights(job: number, mesh: OwnedMesh, pins: number[]): PinWeights {
    this.heap.writeMesh(job, mesh);
    for (const vertex of pins) this.native._abflatAddPin(job, vertex, 0, 0, 0);
    this.check(job, this.native._abflatPinWeights(job));
    return { weights: this.heap.read(job, 'uv') };
  }

  #load(job: number, file: OwnedMesh): LoadedMesh {
    this.heap.writeMesh(job, file);
    this.check(job, this.native._abflatLoad(job));
    return {
      ...this.#readTriangles(job),
      faces: this.heap.read(job, 'faces'),
    };
  }

  #sample(job: number, name: string, detail: number): TriangleMesh {
    this.heap.writeName(job, name);
    this.check(job, this.native._abflatSample(job, detail));
    return this.#readTriangles(job);
  }

  #readTriangles(job: number): TriangleMesh {
    return {
      positions: this.heap.read(job, 'positions'),
      indices: this.heap.read(job, 'indices'),
    };
  }

  protected readText(job: number): string {
    return this.heap.readText(job);
  }
}
