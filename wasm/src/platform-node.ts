import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Worker, type WorkerOptions } from 'node:worker_threads';
import { AbflatError, messageOf } from './base/errors.js';
import { ownFields } from './messages/fields.js';
import type { FromWorker } from './messages/protocol.js';
import { type Address, type Platform, textOf, type WorkerHandle } from './platform.js';
import { browser } from './platform-browser.js';
import { wasmFile } from './wasm-file.js';

/** Advice if no address was given. */
const KEEP =
  "A bundler may have left it out. Keep abflat out of the bundle (external: ['abflat'], in Next serverExternalPackages: ['abflat']), " +
  'or pass the location of its folder dist (createAbflat({ baseUrl })).';

export const node: Platform = {
  fileIn: (folder, name) =>
    isRemote(folder) ? browser.fileIn(folder, name) : join(pathOf(folder), name),

  async loadModule(name, address) {
    if (address && isRemote(address)) return browser.loadModule(name, address);
    const path = pathOf(address ?? wasmFile(name));
    let bytes: Uint8Array<ArrayBuffer>;
    try {
      bytes = await readFile(path);
    } catch (error) {
      throw new Error(`Cannot load ${path}: ${messageOf(error)}.${address ? '' : ` ${KEEP}`}`);
    }
    try {
      return await WebAssembly.compile(bytes);
    } catch (error) {
      throw new Error(`${path} is not a WebAssembly module: ${messageOf(error)}`);
    }
  },

  workerFile: () => 'worker-node.js',

  startWorker(events, _name, address) {
    // The worker must not inherit the flags of the process; some, such as --input-type, would stop
    // it. Bundlers only find a worker whose options are written beside it.
    const worker =
      address === undefined
        ? new Worker(new URL('./worker-node.js', import.meta.url), {
            __proto__: null,
            execArgv: [],
          } as WorkerOptions)
        : new Worker(pathToFileURL(pathOf(address)), ownFields({ execArgv: [] }));
    worker.unref();
    worker.on('message', (message: FromWorker) => events.onMessage(message));
    worker.on('messageerror', (error) => events.onCrash(crash(error)));
    worker.on('error', (error) => events.onCrash(crash(error, address ? '' : ` ${KEEP}`)));
    worker.on('exit', (code) => events.onCrash(crash(`exit code ${code}`)));
    return handleOf(worker);
  },
};

function crash(reason: unknown, advice = ''): AbflatError {
  const isMissing = /MODULE_NOT_FOUND$/.test((reason as NodeJS.ErrnoException).code ?? '');
  return isMissing
    ? new AbflatError(
        'UnreadableFile',
        `Cannot load the worker of abflat: ${messageOf(reason)}.${advice}`,
        'worker',
      )
    : new AbflatError('Internal', `The worker of abflat stopped: ${messageOf(reason)}`, 'stopped');
}

const isRemote = (address: Address) => /^https?:/.test(textOf(address));

function pathOf(address: Address): string {
  return textOf(address).startsWith('file:') ? fileURLToPath(textOf(address)) : textOf(address);
}

function handleOf(worker: Worker): WorkerHandle {
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    terminate: () => void worker.terminate(),
    setBusy: (isBusy) => (isBusy ? worker.ref() : worker.unref()),
  };
}
