// The caller's side of the protocol: a queue in front of one worker, which is started when there is
// something to do and replaced after it was stopped.

import type { ModuleName } from './base/builds.js';
import { AbflatError } from './base/errors.js';
import type { Caller, CallSettings } from './call.js';
import { ownFields } from './messages/fields.js';
import { take } from './messages/input.js';
import type { Answer, AnyProgress, FromWorker, Request } from './messages/protocol.js';
import { onAbort } from './on-abort.js';
import type { Address, Platform, WorkerHandle } from './platform.js';
import { terminated } from './terminated.js';
import type { AbortSignalLike } from './types/index.js';

/** How long a worker may take to notice that its call was cancelled, in milliseconds. */
const PATIENCE = 200;

export interface ClientSettings {
  module: WebAssembly.Module;
  name: ModuleName;
  maxMemory: number;
  workerUrl?: Address;
}

interface Waiting {
  request: Request;
  transfer: ArrayBuffer[];
  onProgress?: (progress: AnyProgress) => unknown;
  resolve(answer: Answer): void;
  reject(error: unknown): void;
}

const sharedNumber = () =>
  typeof SharedArrayBuffer === 'undefined' ? undefined : new Int32Array(new SharedArrayBuffer(4));

/** What calls are given to. */
export interface Lane extends Caller {
  call<T extends Answer>(request: Request, settings?: CallSettings): Promise<T>;
  terminate(): void;
}

export class Client implements Lane {
  readonly take = take;
  readonly #platform: Platform;
  readonly #settings: ClientSettings;
  readonly #waiting: Waiting[] = [];
  #running: Waiting | undefined;
  #worker: WorkerHandle | undefined;
  /** Where the worker reads the number of the call to stop. */
  readonly #stopped = sharedNumber();
  #calls = 0;
  /** Set while the worker is to end a cancelled call. */
  #patience: ReturnType<typeof setTimeout> | undefined;
  #isTerminated = false;

  constructor(platform: Platform, settings: ClientSettings) {
    this.#platform = platform;
    this.#settings = settings;
  }

  checkUsable(signal?: AbortSignalLike): void {
    if (this.#isTerminated) throw terminated();
    if (signal?.aborted) throw signal.reason;
  }

  /** The caller knows the type of the answer to its request. */
  call<T extends Answer>(request: Request, settings: CallSettings = {}): Promise<T> {
    const { transfer = [], signal, onProgress } = ownFields(settings);
    return new Promise<Answer>((resolve, reject) => {
      const cancel = () => this.#cancel(call, signal?.reason);
      const settled =
        <V>(settle: (value: V) => void) =>
        (value: V) => {
          stopListening();
          settle(value);
        };
      const call: Waiting = {
        request,
        transfer,
        onProgress,
        resolve: settled(resolve),
        reject: settled(reject),
      };
      const stopListening = onAbort(signal, cancel);
      this.#waiting.push(call);
      this.#next();
    }) as Promise<T>;
  }

  terminate(): void {
    this.#isTerminated = true;
    this.#dropWorker();
    const calls = [this.#running, ...this.#waiting.splice(0)];
    this.#running = undefined;
    for (const call of calls) call?.reject(terminated());
  }

  #next(): void {
    if (this.#running || this.#patience !== undefined) return;
    const call = this.#waiting.shift();
    if (!call) {
      this.#worker?.setBusy(false);
      return;
    }
    this.#running = call;
    try {
      this.start();
      const worker = this.#worker as WorkerHandle;
      worker.setBusy(true);
      const number = ++this.#calls;
      worker.post({ type: 'call', request: call.request, number }, call.transfer);
    } catch (error) {
      // A browser may refuse to start a worker, and values that cannot be cloned are refused too.
      this.#dropWorker();
      this.#settle((ended) => ended.reject(error));
    }
  }

  /** Has a worker ready for the next call. */
  start(): void {
    this.#worker ??= this.#startWorker();
  }

  #startWorker(): WorkerHandle {
    const { module, name, maxMemory, workerUrl } = this.#settings;
    const isCurrent = () => this.#worker === worker;
    const worker = this.#platform.startWorker(
      {
        onMessage: (message) => isCurrent() && this.#onMessage(message),
        onCrash: (error) => isCurrent() && this.#onCrash(error),
      },
      name,
      workerUrl,
    );
    worker.post({ type: 'start', module, maxMemory, stopped: this.#stopped });
    return worker;
  }

  #onMessage(message: FromWorker): void {
    if (message.type === 'progress') {
      this.#report(message.progress);
      return;
    }
    this.#ended();
    if (message.isSpent) this.#dropWorker();
    this.#settle((call) => {
      if (message.type === 'done') call.resolve(message.answer);
      else call.reject(new AbflatError(message.code, message.message));
    });
  }

  /**
   * If the listener throws, or the promise that it returns rejects, its call rejects with that.
   */
  #report(progress: AnyProgress): void {
    const call = this.#running;
    if (!call) return;
    const cancel = (error: unknown) => this.#cancel(call, error);
    try {
      Promise.resolve(call.onProgress?.(progress)).catch(cancel);
    } catch (error) {
      cancel(error);
    }
  }

  #onCrash(error: AbflatError): void {
    this.#dropWorker();
    this.#settle((call) => call.reject(error));
  }

  #cancel(call: Waiting, error: unknown): void {
    if (call === this.#running) {
      this.#running = undefined;
      call.reject(error);
      this.#stop();
      return;
    }
    const place = this.#waiting.indexOf(call);
    if (place >= 0) this.#waiting.splice(place, 1);
    call.reject(error);
  }

  /**
   * Ends the running call. A busy worker receives no messages: it looks into shared memory now and
   * then. Where there is none, or it does not look, another worker takes its place.
   */
  #stop(): void {
    const replace = () => {
      this.#dropWorker();
      try {
        this.start();
      } catch {
        // The next call starts it, and says what is wrong.
      }
      this.#next();
    };
    if (!this.#stopped) {
      replace();
      return;
    }
    Atomics.store(this.#stopped, 0, this.#calls);
    this.#patience = setTimeout(replace, PATIENCE);
  }

  #settle(end: (call: Waiting) => void): void {
    const call = this.#running;
    this.#running = undefined;
    if (call) end(call);
    this.#next();
  }

  #ended(): void {
    clearTimeout(this.#patience);
    this.#patience = undefined;
  }

  #dropWorker(): void {
    const worker = this.#worker;
    this.#worker = undefined;
    this.#ended();
    worker?.terminate();
  }
}
