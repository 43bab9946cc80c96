import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';
import { BUILDS } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { KEEP, nodeFiles, pathOf } from './files-node.js';
import { ownFields } from './messages/fields.js';
import type { FromWorker } from './messages/protocol.js';
import type { Platform, WorkerHandle } from './platform.js';
import { wasmFile } from './wasm-file.js';

export const node: Platform = {
  ...nodeFiles(wasmFile),

  builds: BUILDS,

  whyNoThreads: () => undefined,

  workerFile: () => 'worker-node.js',

  startWorker(events, _name, address) {
    // The worker must not inherit the flags of the process; some, such as --input-type, would stop
    // it. Bundlers only find a worker whose options are written beside it, and webpack none that
    // have no prototype, so what a script may have added to Object.prototype is set here.
    const worker =
      address === undefined
        ? new Worker(new URL('./worker-node.js', import.meta.url), {
            execArgv: [],
            argv: undefined,
            env: undefined,
            eval: false,
            resourceLimits: undefined,
            stderr: false,
            stdin: false,
            stdout: false,
            transferList: undefined,
            workerData: undefined,
          })
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

function handleOf(worker: Worker): WorkerHandle {
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    terminate: () => void worker.terminate(),
    setBusy: (isBusy) => (isBusy ? worker.ref() : worker.unref()),
  };
}
