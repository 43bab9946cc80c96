// The calls that the WebAssembly module answers. Runs in the worker, where it may block.

import { buildOf } from './base/build-of.js';
import type { Build } from './base/builds.js';
import { AbflatError } from './base/errors.js';
import { RESULT_ARRAYS } from './base/generated-arrays.js';
import type { Glues } from './glue.js';
import { type Instance, instantiate } from './instantiate.js';
import { MeshHeap } from './mesh-heap.js';
import { MeshRunner } from './mesh-runner.js';
import type {
  Answer,
  Description,
  FlattenRequest,
  KnownArrays,
  OwnedMesh,
  PinNumbers,
  Request,
  UnwrapRequest,
} from './messages/protocol.js';
import type { NativeModule } from './native-module.js';
import type {
  Comparison,
  FlattenResult,
  LoadedMesh,
  MeshSummary,
  PinWeights,
  Report,
  TriangleMesh,
  UnwrapReport,
  UnwrapResult,
} from './types/index.js';

export class Engine extends MeshRunner<NativeModule> {
  static async create(
    module: WebAssembly.Module,
    maxMemory: number,
    glues: Glues,
  ): Promise<Engine> {
    const build = buildOf(module);
    const glue = glues[build];
    if (!glue) throw new AbflatError('Internal', `This worker does not run the build ${build}.`);
    const { create, threadScript } = glue;
    const isShared = build === 'threads';
    const settings = { maxMemory, isShared, threadScript };
    return Engine.of(await instantiate(module, create, settings), maxMemory);
  }

  static of({ native, memory, hooks }: Instance<NativeModule>, maxMemory: number): Engine {
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
      case 'pack':
      case 'verify':
      case 'bake':
        throw new AbflatError('Internal', `Another module answers ${request.kind}.`);
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
    return this.withLayout<Report, FlattenResult>(request, {
      set: (job, native) => {
        this.setOptions(job, values, native._abflatSetOption);
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
    return this.withLayout<UnwrapReport, UnwrapResult>(request, {
      set: (job, native) => {
        this.setOptions(job, values, native._abflatSetUnwrapOption);
        this.#setPins(job, pins);
        if (seams !== undefined)
          this.heap.writeText(seams, (bytes) => native._abflatSeams(job, bytes));
        arrays.forEach((array, which) => {
          if (array) this.#writeArray(job, which, array);
        });
        if (keepsUv) native._abflatKeepUv(job);
        if (keepsValidOnly) native._abflatKeepsValidOnly(job);
        if (keepsPlaces) native._abflatKeepsPlaces(job);
        if (known !== undefined) this.#writeKnown(job, known);
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

  #writeKnown(job: number, { t, balance, straightSeams, arrays }: KnownArrays): void {
    const { heap, native } = this;
    const entries = Object.entries(arrays);
    heap.checkBytes(entries.reduce((sum, [, array]) => sum + array.byteLength, 0));
    for (const [name, array] of entries) {
      const { field } = RESULT_ARRAYS[name as keyof typeof arrays];
      heap.writeArray(native._abflatKnown(job, field, array.length), array);
    }
    native._abflatKnownOptions(job, t, balance, straightSeams);
  }

  /** `which`: its place in UNWRAP_ARRAYS. */
  #writeArray(job: number, which: number, array: Uint32Array | Float64Array): void {
    this.heap.checkBytes(array.byteLength);
    this.heap.writeArray(this.native._abflatArray(job, which, array.length), array);
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
}
