import type { Build, ModuleName } from './base/builds.js';
import type { AbflatError } from './base/errors.js';
import type { FromWorker, ToWorker } from './messages/protocol.js';
import type { UrlLike } from './types/index.js';

export type Address = string | UrlLike;

export const textOf = (address: Address) => (typeof address === 'string' ? address : address.href);

export interface WorkerHandle {
  post(message: ToWorker, transfer?: ArrayBuffer[]): void;
  terminate(): void;
  /**
   * Busy means that a caller waits for an answer: only then may the worker keep the process alive.
   */
  setBusy(isBusy: boolean): void;
}

export interface WorkerEvents {
  onMessage(message: FromWorker): void;
  /** The worker is gone or never started. */
  onCrash(error: AbflatError): void;
}

/** How files are read. If no address is given, they are beside the package's modules. */
export interface Files<Name extends ModuleName = ModuleName> {
  /** The address of a file in a folder. */
  fileIn(folder: Address, name: string): string;
  /** Rejects with a sentence that names the file. */
  loadModule(name: Name, address?: Address): Promise<WebAssembly.Module>;
}

/** The address of a file beside the scripts. */
export type FileBeside<Name> = (name: Name) => URL;

/** What browsers and Node do differently. */
export interface Platform extends Files {
  /** Those that it has files of. */
  readonly builds: readonly Build[];
  /** Why the build with threads cannot run here; undefined if it can. */
  whyNoThreads(): string | undefined;
  /** The script of the worker that runs a module. */
  workerFile(name: ModuleName): string;
  startWorker(events: WorkerEvents, name: ModuleName, address?: Address): WorkerHandle;
}
