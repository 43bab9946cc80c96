import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import { AbflatError, messageOf } from './errors.js';
import type { Platform, WorkerHandle } from './platform.js';
import { browser } from './platform-browser.js';
import type { FromWorker } from './protocol.js';

export const node: Platform = {
  async loadModule(address) {
    if (/^https?:/.test(String(address))) return browser.loadModule(address);
    const path = pathOf(address);
    let bytes: Uint8Array<ArrayBuffer>;
    try {
      bytes = await readFile(path);
    } catch (error) {
      throw new Error(`Cannot load ${path}: ${messageOf(error)}`);
    }
    try {
      return await WebAssembly.compile(bytes);
    } catch (error) {
      throw new Error(`${path} is not a WebAssembly module: ${messageOf(error)}`);
    }
  },

  startWorker(events, _build, address) {
    // The flags of the process are not for the worker; some, as --input-type, would stop it.
    const options = { execArgv: [] };
    const worker =
      address === undefined
        ? new Worker(new URL('./worker-node.js', import.meta.url), options)
        : new Worker(pathOf(address), options);
    worker.unref();
    worker.on('message', (message: FromWorker) => events.onMessage(message));
    worker.on('messageerror', (error) => events.onCrash(crash(error)));
    worker.on('error', (error) => events.onCrash(crash(error)));
    worker.on('exit', (code) => events.onCrash(crash(`exit code ${code}`)));
    return handleOf(worker);
  },
};

function crash(reason: unknown): AbflatError {
  const isMissing = /MODULE_NOT_FOUND$/.test((reason as NodeJS.ErrnoException).code ?? '');
  return isMissing
    ? new AbflatError('UnreadableFile', `Cannot load the worker of abflat: ${messageOf(reason)}`)
    : new AbflatError('Internal', `The worker of abflat stopped: ${messageOf(reason)}`);
}

function pathOf(address: string | URL): string {
  return String(address).startsWith('file:') ? fileURLToPath(address) : String(address);
}

function handleOf(worker: Worker): WorkerHandle {
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    terminate: () => void worker.terminate(),
    setBusy: (isBusy) => (isBusy ? worker.ref() : worker.unref()),
  };
}
