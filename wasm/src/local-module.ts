// A module in the calling thread, which answers a call before it returns.

import { AbflatError } from './base/errors.js';
import { KEPT_MEMORY } from './base/memory.js';
import type { Call, Caller } from './call.js';
import type { CreateModule } from './glue.js';
import { type Instance, instantiate, instantiateNow } from './instantiate.js';
import { borrow } from './messages/borrow.js';
import type { Answer, AnyProgress, Request } from './messages/protocol.js';
import { terminated } from './terminated.js';
import { throttle } from './throttle.js';
import type { AbortSignalLike } from './types/index.js';

export interface Runner {
  readonly heapBytes: number;
  readonly isBroken: boolean;
  run(request: Request, onProgress: (progress: AnyProgress) => boolean): Answer;
}

/** Two ways to start a module: at once, where that is possible, or a moment later. */
export interface Starter {
  now(): Runner | undefined;
  later(): Promise<Runner>;
}

export function starterOf<N extends object>(
  module: WebAssembly.Module,
  maxMemory: number,
  create: CreateModule<N>,
  make: (instance: Instance<N>, maxMemory: number) => Runner,
): Starter {
  return {
    now: () => {
      const instance = instantiateNow(module, create, { maxMemory });
      return instance && make(instance, maxMemory);
    },
    later: async () => make(await instantiate(module, create, { maxMemory }), maxMemory),
  };
}

export class LocalModule implements Caller {
  readonly take = borrow;
  readonly #starter: Starter;
  #runner: Runner | undefined;
  #isBusy = false;
  #isTerminated = false;

  private constructor(starter: Starter, runner: Runner) {
    this.#starter = starter;
    this.#runner = runner;
  }

  /** Where a module can start at once. */
  static startNow(starter: Starter): LocalModule {
    const runner = starter.now();
    if (runner) return new LocalModule(starter, runner);
    throw new AbflatError(
      'UnsupportedHost',
      'WebAssembly starts only a moment later in this thread.',
    );
  }

  static async start(starter: Starter): Promise<LocalModule> {
    return new LocalModule(starter, await starter.later());
  }

  checkUsable(signal?: AbortSignalLike): void {
    if (this.#isTerminated) throw terminated();
    if (signal?.aborted) throw signal.reason;
    if (this.#isBusy)
      throw new AbflatError(
        'InvalidOption',
        'A listener cannot make another call: this thread is busy with the one it is told about.',
      );
  }

  /** The caller knows the type of the answer to its request. */
  answer<T extends Answer>({ request, settings }: Call): T {
    const { signal, onProgress } = settings;
    this.checkUsable(signal);
    const runner = this.#usableRunner();
    let stopped: { reason: unknown } | undefined;
    const tell = onProgress && throttle((progress) => void onProgress(progress));
    const goOn = (progress: AnyProgress): boolean => {
      if (stopped) return false;
      try {
        tell?.(progress);
        if (signal?.aborted) stopped = { reason: signal.reason };
      } catch (error) {
        stopped = { reason: error };
      }
      return stopped === undefined;
    };
    this.#isBusy = true;
    try {
      return runner.run(request, goOn) as T;
    } catch (error) {
      throw stopped ? stopped.reason : error;
    } finally {
      this.#isBusy = false;
      if (runner.isBroken || runner.heapBytes > KEPT_MEMORY) this.#restart();
    }
  }

  terminate(): void {
    this.#isTerminated = true;
    this.#runner = undefined;
  }

  #usableRunner(): Runner {
    if (this.#runner) return this.#runner;
    throw new AbflatError(
      'Internal',
      'The module of abflat is being started again after the last call. Await something before the next one.',
      'stopped',
    );
  }

  /** A module that trapped must not be used again, and one that has grown gives no memory back. */
  #restart(): void {
    this.#runner = this.#starter.now();
    if (this.#runner) return;
    this.#starter.later().then(
      (runner) => {
        this.#runner = runner;
      },
      () => undefined, // the next call says that there is none
    );
  }
}
