import type { Build } from './builds.js';
import { AbflatError, messageOf } from './errors.js';
import type { Platform, WorkerHandle } from './platform.js';
import type { FromWorker } from './protocol.js';

const ADVICE = 'Pass wasmUrl to createAbflat if the file is elsewhere.';

export const browser: Platform = {
  async loadModule(address) {
    const response = await fetchFile(address);
    try {
      return await WebAssembly.compile(await response.arrayBuffer());
    } catch (error) {
      const type = response.headers.get('content-type') ?? 'no type';
      throw new Error(
        `${address} is not a WebAssembly module (served as ${type}): ${messageOf(error)}. ${ADVICE}`,
      );
    }
  },

  startWorker(events, build, address) {
    const worker = openWorker(build, address);
    worker.onmessage = (event: MessageEvent<FromWorker>) => events.onMessage(event.data);
    worker.onmessageerror = () => events.onCrash(crash('a message from it cannot be read'));
    worker.onerror = (event) => {
      event.preventDefault();
      events.onCrash(event.message ? crash(event.message) : notLoaded(address));
    };
    return handleOf(worker);
  },
};

async function fetchFile(address: string | URL): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(address);
  } catch (error) {
    throw new Error(`Cannot load ${address}: ${messageOf(error)}`);
  }
  if (!response.ok) {
    const status = `${response.status} ${response.statusText}`.trim();
    throw new Error(`Cannot load ${address}: ${status}. ${ADVICE}`);
  }
  return response;
}

const crash = (reason: string) =>
  new AbflatError('Internal', `The worker of abflat stopped: ${reason}`);

/** The error event of a script that cannot be loaded has no message. */
function notLoaded(address: string | URL = 'a script beside its module'): AbflatError {
  return new AbflatError(
    'UnreadableFile',
    `Cannot load the worker of abflat from ${address}; pass workerUrl to createAbflat if it is elsewhere.`,
  );
}

function openWorker(build: Build, address?: string | URL): Worker {
  const url =
    address === undefined ? new URL(`./worker-${build}.js`, here) : new URL(address, page());
  if (isForeign(url)) return openForeignWorker(url);
  return address === undefined ? openOwnWorker(build) : new Worker(url, { type: 'module' });
}

/**
 * Bundlers find the workers' files by exactly these expressions. There is one for each build because not all formats
 * of workers that bundlers write allow parts that are loaded later.
 */
function openOwnWorker(build: Build): Worker {
  switch (build) {
    case 'plain':
      return new Worker(new URL('./worker-plain.js', import.meta.url), { type: 'module' });
    case 'simd':
      return new Worker(new URL('./worker-simd.js', import.meta.url), { type: 'module' });
    case 'threads':
      return new Worker(new URL('./worker-threads.js', import.meta.url), { type: 'module' });
  }
}

function handleOf(worker: Worker): WorkerHandle {
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    terminate: () => worker.terminate(),
    setBusy: () => undefined,
  };
}

/** The address of this module; behind a name, so that bundlers do not take what uses it for files of theirs. */
const here = import.meta.url;

/** What relative addresses refer to. */
const page = () => globalThis.document?.baseURI ?? globalThis.location.href;

/** On another origin than the page, as on a CDN. */
function isForeign({ protocol, origin }: URL): boolean {
  return /^https?:$/.test(protocol) && origin !== globalThis.location.origin;
}

/** Browsers start workers of the page's own origin only; such a one may import from elsewhere. */
function openForeignWorker(url: URL): Worker {
  const script = new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' });
  return new Worker(URL.createObjectURL(script), { type: 'module' });
}
