// One instance of the WebAssembly module. Runs in the worker, where it may block.

import type { NativeModule } from './abflat.js';
import { buildOf } from './base/build-of.js';
import type { Build } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { STATUS_NAMES } from './base/generated.js';
import { RESULT_ARRAYS } from './base/generated-arrays.js';
import { MIN_MEMORY, megabytes, PAGE } from './base/memory.js';
import type { Glues } from './glue.js';
import { Heap, OutOfMemory, readString } from './heap.js';
import type {
  Answer,
  AnyProgress,
  Description,
  FlattenRequest,
  LayoutRequest,
  OwnedMesh,
  Request,
  UnwrapRequest,
} from './messages/protocol.js';
import type {
  Comparison,
  FlattenResult,
  Layout,
  LayoutTimings,
  LoadedMesh,
  MeshSummary,
  PinWeights,
  Report,
  TriangleMesh,
  UnwrapReport,
  UnwrapResult,
} from './types/index.js';

interface Hooks {
  onProgress(progress: AnyProgress): void;
}

/** What differs between the calls that return a layout. */
interface LayoutSteps<R, T> {
  set(job: number, native: NativeModule): void;
  run(job: number, files: number, roundsForGltf: boolean): number;
  complete(layout: Layout<R>, job: number): T;
}

export class Engine {
  /**
   * A trap leaves the module's memory in an undefined state: this engine must not be used again.
   */
  isBroken = false;
  readonly #native: NativeModule;
  readonly #heap: Heap;
  readonly #hooks: Hooks;

  private constructor(native: NativeModule, heap: Heap, hooks: Hooks) {
    this.#native = native;
    this.#heap = heap;
    this.#hooks = hooks;
  }

  static async create(
    module: WebAssembly.Module,
    maxMemory: number,
    glues: Glues,
  ): Promise<Engine> {
    const build = buildOf(module);
    const glue = glues[build];
    if (!glue) throw new AbflatError('Internal', `This worker does not run the build ${build}.`);
    const { create, threadScript } = glue;
    const memory = new WebAssembly.Memory({
      initial: MIN_MEMORY / PAGE,
      maximum: Math.floor(maxMemory / PAGE),
      shared: build === 'threads',
    });
    const hooks: Hooks = { onProgress: ignore };
    const native = await new Promise<NativeModule>((resolve, reject) => {
      create({
        wasmMemory: memory,
        ...(threadScript && { mainScriptUrlOrBlob: threadScript() }),
        instantiateWasm: (imports, receive) => {
          WebAssembly.instantiate(module, imports)
            .then((instance) => receive(instance, module))
            .catch(reject);
          return {};
        },
        print: ignore,
        printErr: ignore, // repeats what is thrown
        onProgress: (stage, newtonStep, constraintResidual, fraction) => {
          const name = readString(memory, stage);
          hooks.onProgress({
            stage: name,
            newtonStep,
            constraintResidual,
            fraction,
          } as AnyProgress);
        },
        onOutOfMemory: () => {
          throw new OutOfMemory();
        },
      }).then(resolve, reject);
    });
    return new Engine(native, new Heap(native, memory, maxMemory), hooks);
  }

  get heapBytes(): number {
    return this.#heap.bytes;
  }

  /** Throws AbflatError, and sets `isBroken` if the module trapped or ran out of memory. */
  run(request: Request, onProgress: (progress: AnyProgress) => void = ignore): Answer {
    this.#hooks.onProgress = onProgress;
    try {
      return this.#run(request);
    } catch (error) {
      if (error instanceof AbflatError) throw error;
      this.isBroken = true;
      throw this.#explain(error);
    }
  }

  #run(request: Request): Answer {
    switch (request.kind) {
      case 'describe':
        return this.#describe();
      case 'flatten':
        return this.#flatten(request);
      case 'unwrap':
        return this.#unwrap(request);
      case 'compare':
        return this.#withJob((job) => this.#compare(job, request.mesh));
      case 'inspect':
        return this.#withJob((job) => this.#inspect(job, request.mesh));
      case 'pinWeights':
        return this.#withJob((job) => this.#pinWeights(job, request.mesh, request.pins));
      case 'load':
        return this.#withJob((job) => this.#load(job, request.mesh));
      case 'sample':
        return this.#withJob((job) => this.#sample(job, request.name, request.detail));
    }
  }

  #describe(): Description {
    const native = this.#native;
    const list = (count: number, name: (index: number) => number) =>
      Array.from({ length: count }, (_, index) => this.#heap.readString(name(index)));
    return {
      build: this.#heap.readString(native._abflatBuild()) as Build,
      statuses: list(native._abflatStatusCount(), native._abflatStatusName),
      samples: list(native._abflatSampleCount(), native._abflatSampleName),
    };
  }

  #flatten(request: FlattenRequest): FlattenResult {
    const { values, bounds, straight, normalizes } = request;
    return this.#withLayout<Report, FlattenResult>(request, {
      set: (job, native) => {
        this.#setOptions(job, values, native._abflatSetOption);
        for (let i = 0; i < bounds.length; i += 2)
          native._abflatAddBound(job, bounds[i] as number, bounds[i + 1] as number);
        for (const [from, to] of straight) native._abflatAddStraight(job, from, to);
        if (normalizes) native._abflatNormalizes(job);
      },
      run: this.#native._abflatFlatten,
      complete: (layout) => layout,
    });
  }

  #unwrap(request: UnwrapRequest): UnwrapResult {
    const { values, seams, arrays, keepsUv, keepsValidOnly, keepsPlaces, known } = request;
    return this.#withLayout<UnwrapReport, UnwrapResult>(request, {
      set: (job, native) => {
        this.#setOptions(job, values, native._abflatSetUnwrapOption);
        if (seams !== undefined)
          this.#heap.writeText(seams, (bytes) => native._abflatSeams(job, bytes));
        arrays.forEach((array, which) => {
          if (array) this.#heap.writeArray(job, which, array);
        });
        if (keepsUv) native._abflatKeepUv(job);
        if (keepsValidOnly) native._abflatKeepsValidOnly(job);
        if (keepsPlaces) native._abflatKeepsPlaces(job);
        if (known !== undefined) this.#heap.writeKnown(job, known);
      },
      run: this.#native._abflatUnwrap,
      complete: (layout, job) => ({
        ...layout,
        chartOfTriangle: this.#heap.read(job, 'chartOfTriangle'),
        seams: this.#heap.read(job, 'seams'),
        unpacked: this.#heap.read(job, 'unpacked'),
      }),
    });
  }

  #withLayout<R extends { timings: LayoutTimings }, T extends Layout<R>>(
    { mesh, pins, files, roundsForGltf }: LayoutRequest,
    { set, run, complete }: LayoutSteps<R, T>,
  ): T {
    const started = performance.now();
    return this.#withJob((job) => {
      this.#heap.writeMesh(job, mesh);
      const written = performance.now();
      set(job, this.#native);
      for (const [vertex, u, v, face] of pins) this.#native._abflatAddPin(job, vertex, u, v, face);
      const wanted = files.reduce((bits, name) => bits | (1 << RESULT_ARRAYS[name].field), 0);
      this.#check(job, run(job, wanted, roundsForGltf));
      const finished = performance.now();
      const layout: Layout<R> = {
        uv: this.#heap.read(job, 'uv'),
        indices: this.#heap.read(job, 'indices'),
        vertexMap: this.#heap.read(job, 'vertexMap'),
        report: JSON.parse(this.#heap.readText(job)) as R,
      };
      if ('bytes' in mesh) layout.positions = this.#heap.read(job, 'positions');
      for (const name of files) layout[name] = this.#heap.read(job, name);
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
      this.#check(job, set(job, index, value));
    });
  }

  #compare(job: number, mesh: OwnedMesh): Comparison {
    this.#heap.writeMesh(job, mesh);
    const native = this.#native;
    this.#check(job, native._abflatCompare(job));
    const found = JSON.parse(this.#heap.readText(job)) as Pick<
      Comparison,
      'version' | 'input' | 'methods'
    >;
    for (const [i, method] of found.methods.entries()) {
      const start = native._abflatMethodUvData(job, i);
      method.uv = new Float64Array(this.#heap.copy(start, native._abflatMethodUvSize(job, i)));
    }
    const result: Comparison = {
      ...found,
      indices: this.#heap.read(job, 'indices'),
      vertexMap: this.#heap.read(job, 'vertexMap'),
    };
    if ('bytes' in mesh) result.positions = this.#heap.read(job, 'positions');
    return result;
  }

  #inspect(job: number, mesh: OwnedMesh): MeshSummary {
    this.#heap.writeMesh(job, mesh);
    this.#check(job, this.#native._abflatInspect(job));
    return JSON.parse(this.#heap.readText(job)) as MeshSummary;
  }

  #pinWeights(job: number, mesh: OwnedMesh, pins: number[]): PinWeights {
    this.#heap.writeMesh(job, mesh);
    for (const vertex of pins) this.#native._abflatAddPin(job, vertex, 0, 0, 0);
    this.#check(job, this.#native._abflatPinWeights(job));
    return { weights: this.#heap.read(job, 'uv') };
  }

  #load(job: number, file: OwnedMesh): LoadedMesh {
    this.#heap.writeMesh(job, file);
    this.#check(job, this.#native._abflatLoad(job));
    return {
      ...this.#readTriangles(job),
      faces: this.#heap.read(job, 'faces'),
    };
  }

  #sample(job: number, name: string, detail: number): TriangleMesh {
    this.#heap.writeName(job, name);
    this.#check(job, this.#native._abflatSample(job, detail));
    return this.#readTriangles(job);
  }

  #readTriangles(job: number): TriangleMesh {
    return {
      positions: this.#heap.read(job, 'positions'),
      indices: this.#heap.read(job, 'indices'),
    };
  }

  #withJob<T>(use: (job: number) => T): T {
    const job = this.#native._abflatNewJob();
    try {
      const value = use(job);
      this.#native._abflatFreeJob(job);
      return value;
    } catch (error) {
      // After any other error the module must not be called again.
      if (error instanceof AbflatError) this.#native._abflatFreeJob(job);
      throw error;
    }
  }

  #check(job: number, code: number): void {
    if (code === 0) return;
    throw new AbflatError(STATUS_NAMES[code] ?? 'Internal', this.#heap.readText(job));
  }

  #explain(error: unknown): AbflatError {
    if (error instanceof OutOfMemory) {
      return new AbflatError(
        'OutOfMemory',
        `There is not enough memory for this mesh: abflat may use ${megabytes(this.#heap.maxBytes)}` +
          ` and has ${megabytes(this.heapBytes)}. Use a mesh with fewer faces, or a larger maxMemory.`,
      );
    }
    return new AbflatError(
      'Internal',
      `The WebAssembly module stopped (${messageOf(error)}). Please report it with the mesh.`,
    );
  }
}

function ignore(): void {
  // Nobody listens.
}
