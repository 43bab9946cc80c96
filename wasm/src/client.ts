// The caller's side of the protocol: a queue in front of one worker, which is started when there is
// something to do and replaced after it was stopped.

import type { ModuleName } from './base/builds.js';
import { AbflatError } from './base/errors.js';
import { ownFields } from './messages/fields.js';
import type { Answer, AnyProgress, FromWorker, Request } from './messages/protocol.js';
import type { Address, Platform, WorkerHandle } from './platform.js';
import type { AbortSignalLike } from './types/index.js';

const terminated = () => new DOMException('terminate() was called.', 'AbortError');

export interface ClientSettings {
  module: WebAssembly.Module;
  name: ModuleName;
  maxMemory: number;
  workerUrl?: Address;
}

export interface CallSettings {
  transfer?: ArrayBuffer[];
  signal?: AbortSignalLike;
  /** A method, for its looser type check: the caller knows which progress its request reports. */
  onProgress?(progress: AnyProgress): unknown;
}

interface Call {
  request: Request;
  transfer: ArrayBuffer[];
  onProgress?: (progress: AnyProgress) => unknown;
  resolve(answer: Answer): void;
  reject(error: unknown): void;
}

export class Client {
  readonly #platform: Platform;
  readonly #settings: ClientSettings;
  readonly #waiting: Call[] = [];
  #running: Call | undefined;
  #worker: WorkerHandle | undefined;
  #isTerminated = false;

  constructor(platform: Platform, settings: ClientSettings) {
    this.#platform = platform;
    this.#settings = settings;
  }

  /** Throws if a call would be in vain, before its buffers are taken. */
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
          signal?.removeEventListener('abort', cancel);
          settle(value);
        };
      const call: Call = {
        request,
        transfer,
        onProgress,
        resolve: settled(resolve),
        reject: settled(reject),
      };
      signal?.addEventListener('abort', cancel);
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
    if (this.#running) return;
    const call = this.#waiting.shift();
    if (!call) {
      this.#worker?.setBusy(false);
      return;
    }
    this.#running = call;
    try {
      this.#worker ??= this.#startWorker();
      this.#worker.setBusy(true);
      this.#worker.post({ type: 'call', request: call.request }, call.transfer);
    } catch (error) {
      // A browser may refuse to start a worker, and values that cannot be cloned are refused too.
      this.#dropWorker();
      this.#settle((ended) => ended.reject(error));
    }
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
    worker.post({ type: 'start', module, maxMemory });
    return worker;
  }

  #onMessage(message: FromWorker): void {
    if (message.type === 'progress') {
      this.#report(message.progress);
      return;
    }
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

  #cancel(call: Call, error: unknown): void {
    if (call === this.#running) {
      // A busy worker receives no messages, so ending it is the only way.
      this.#dropWorker();
      this.#settle(() => call.reject(error));
      return;
    }
    const place = this.#waiting.indexOf(call);
    if (place >= 0) this.#waiting.splice(place, 1);
    call.reject(error);
  }

  #settle(end: (call: Call) => void): void {
    const call = this.#running;
    this.#running = undefined;
    if (call) end(call);
    this.#next();
  }

  #dropWorker(): void {
    const worker = this.#worker;
    this.#worker = undefined;
    worker?.terminate();
  }
}
