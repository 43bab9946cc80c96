// What Emscripten's scripts for threads expect around them, as in a Web Worker, in a worker thread
// of Node.

import { availableParallelism } from 'node:os';
import { type TransferListItem, Worker } from 'node:worker_threads';

interface Globals {
  self?: unknown;
  Worker?: unknown;
  navigator?: { hardwareConcurrency: number };
  location?: { href: string };
  importScripts?: () => void;
}

/** Lets the scripts take this thread for a Web Worker that can start others. */
export function actAsWebWorker(): void {
  const here = globalThis as Globals;
  here.self ??= globalThis;
  here.importScripts ??= () => undefined;
  here.location ??= { href: import.meta.url };
  here.navigator ??= { hardwareConcurrency: availableParallelism() };
  here.Worker ??= ThreadWorker;
}

/** A Web Worker that runs one of Emscripten's scripts. */
class ThreadWorker {
  onmessage: ((event: { data: unknown }) => void) | undefined;
  onerror: ((error: Error) => void) | undefined;
  readonly #worker: Worker;

  constructor(script: URL | string) {
    this.#worker = new Worker(new URL('./thread-node.js', import.meta.url), {
      workerData: String(script),
      execArgv: [],
    });
    this.#worker.on('message', (data) => this.onmessage?.({ data }));
    this.#worker.on('error', (error) => {
      if (!this.onerror) throw error;
      this.onerror(error);
    });
    this.#worker.unref();
  }

  postMessage(message: unknown, transfer?: TransferListItem[]): void {
    this.#worker.postMessage(message, transfer);
  }

  terminate(): void {
    void this.#worker.terminate();
  }
}
