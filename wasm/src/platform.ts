import type { Build } from './builds.js';
import type { AbflatError } from './errors.js';
import type { FromWorker, ToWorker } from './protocol.js';

export interface WorkerHandle {
  post(message: ToWorker, transfer?: ArrayBuffer[]): void;
  terminate(): void;
  /** Whether somebody waits for an answer: only then may the worker keep the process alive. */
  setBusy(isBusy: boolean): void;
}

export interface WorkerEvents {
  onMessage(message: FromWorker): void;
  /** The worker is gone or never came to life. */
  onCrash(error: AbflatError): void;
}

/** What browsers and Node do differently. */
export interface Platform {
  /** Rejects with a sentence that names the address. */
  loadModule(address: string | URL): Promise<WebAssembly.Module>;
  /** A worker that runs `build`. Without an address it is a script beside the package's modules. */
  startWorker(events: WorkerEvents, build: Build, address?: string | URL): WorkerHandle;
}
