import { type ModuleName, whyNoThreads } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { addressOf, browserFiles, COPY } from './files-browser.js';
import type { FromWorker } from './messages/protocol.js';
import type { Address, Platform, WorkerHandle } from './platform.js';
import { wasmFile } from './wasm-file.js';

export const browser: Platform = {
  ...browserFiles(wasmFile),

  whyNoThreads,

  workerFile: (name) => `worker-${name}.js`,

  startWorker(events, name, address) {
    const worker = openWorker(name, address);
    worker.onmessage = (event: MessageEvent<FromWorker>) => events.onMessage(event.data);
    worker.onmessageerror = () => events.onCrash(crash('a message from it cannot be read'));
    worker.onerror = (event) => {
      event.preventDefault();
      events.onCrash(event.message ? crash(event.message) : notLoaded(address));
    };
    return handleOf(worker);
  },
};

const crash = (reason: string) =>
  new AbflatError('Internal', `The worker of abflat stopped: ${reason}`, 'stopped');

/** The error event of a script that cannot be loaded has no message. */
function notLoaded(address?: Address): AbflatError {
  const [place, advice] = address
    ? [addressOf(address), '']
    : ['a script beside its module', ` ${COPY}`];
  const header = globalThis.crossOriginIsolated
    ? 'it is served without the header Cross-Origin-Embedder-Policy that the page has, '
    : '';
  return new AbflatError(
    'UnreadableFile',
    `Cannot load the worker of abflat from ${place}: it is missing, it is not served as a script, ${header}or worker-src of ` +
      `the page's content security policy forbids it (from another origin it needs blob: and that origin).${advice}`,
    'worker',
  );
}

function openWorker(name: ModuleName, address?: Address): Worker {
  const url = address === undefined ? new URL(`./worker-${name}.js`, here) : addressOf(address);
  try {
    if (isForeign(url)) return openForeignWorker(url);
    return address === undefined ? openOwnWorker(name) : new Worker(url, { type: 'module' });
  } catch (error) {
    throw new AbflatError(
      'UnreadableFile',
      `The browser cannot start the worker of abflat: ${messageOf(error)}.`,
      'worker',
    );
  }
}

/**
 * Bundlers find the workers' files by exactly these expressions. There is one per module because not
 * all worker formats that bundlers write allow parts to be loaded later.
 */
function openOwnWorker(name: ModuleName): Worker {
  switch (name) {
    case 'simd':
      return new Worker(new URL('./worker-simd.js', import.meta.url), { type: 'module' });
    case 'threads':
      return new Worker(new URL('./worker-threads.js', import.meta.url), { type: 'module' });
    case 'pack':
      return new Worker(new URL('./worker-pack.js', import.meta.url), { type: 'module' });
    case 'bake':
      return new Worker(new URL('./worker-bake.js', import.meta.url), { type: 'module' });
  }
}

function handleOf(worker: Worker): WorkerHandle {
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    terminate: () => worker.terminate(),
    setBusy: () => undefined,
  };
}

/**
 * The address of this module, under another name so that bundlers do not take URLs made from it for
 * files of theirs.
 */
const here = import.meta.url;

/** Whether it is on another origin than the page, such as a CDN. */
function isForeign({ protocol, origin }: URL): boolean {
  return /^https?:$/.test(protocol) && origin !== globalThis.location.origin;
}

/** Browsers only start workers of the page's own origin, but those may import from elsewhere. */
function openForeignWorker(url: URL): Worker {
  const script = new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' });
  return new Worker(URL.createObjectURL(script), { type: 'module' });
}
