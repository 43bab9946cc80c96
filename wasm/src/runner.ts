// An instance of a WebAssembly module that answers calls, one at a time.

import { AbflatError, messageOf } from './base/errors.js';
import { STATUS_NAMES } from './base/generated.js';
import { megabytes } from './base/memory.js';
import { type Heap, OutOfMemory } from './heap.js';
import type { Hooks } from './instantiate.js';
import type { Answer, AnyProgress, Request } from './messages/protocol.js';

/** What every module has. */
export interface Jobs {
  _abflatNewJob(): number;
  _abflatFreeJob(job: number): void;
}

export abstract class Runner<N extends Jobs, H extends Heap> {
  /**
   * A trap leaves the module's memory in an undefined state: this instance must not be used again.
   */
  isBroken = false;
  protected readonly native: N;
  protected readonly heap: H;
  readonly #hooks: Hooks;

  constructor(native: N, heap: H, hooks: Hooks) {
    this.native = native;
    this.heap = heap;
    this.#hooks = hooks;
  }

  get heapBytes(): number {
    return this.heap.bytes;
  }

  protected abstract answer(request: Request): Answer;
  /** The message of the job's error. */
  protected abstract readText(job: number): string;
  /** What memory was for, and what takes less of it. */
  protected abstract readonly task: string;
  protected abstract readonly advice: string;

  /**
   * Throws AbflatError, and sets `isBroken` if the module trapped or ran out of memory. `onProgress`
   * returns whether to go on.
   */
  run(request: Request, onProgress: (progress: AnyProgress) => boolean = () => true): Answer {
    this.#hooks.onProgress = onProgress;
    try {
      return this.answer(request);
    } catch (error) {
      if (error instanceof AbflatError) throw error;
      this.isBroken = true;
      throw this.#explain(error);
    }
  }

  protected withJob<T>(use: (job: number) => T): T {
    const job = this.native._abflatNewJob();
    try {
      const value = use(job);
      this.native._abflatFreeJob(job);
      return value;
    } catch (error) {
      // After any other error the module must not be called again.
      if (error instanceof AbflatError) this.native._abflatFreeJob(job);
      throw error;
    }
  }

  protected check(job: number, code: number): void {
    if (code === 0) return;
    throw new AbflatError(STATUS_NAMES[code] ?? 'Internal', this.readText(job));
  }

  #explain(error: unknown): AbflatError {
    if (error instanceof OutOfMemory) {
      return new AbflatError(
        'OutOfMemory',
        `There is not enough memory for this ${this.task}: abflat may use ${megabytes(this.heap.maxBytes)}` +
          ` and has ${megabytes(this.heapBytes)}. ${this.advice}, or a larger maxMemory.`,
      );
    }
    return new AbflatError(
      'Internal',
      `The WebAssembly module stopped (${messageOf(error)}). Please report it with the ${this.task}.`,
    );
  }
}
