import { AbflatError, messageOf } from './errors.js';
import type { Platform, WorkerHandle } from './platform.js';
import type { FromWorker } from './protocol.js';

export const browser: Platform = {
  async loadModule(address = new URL('./abflat.wasm', import.meta.url)) {
    const response = await fetchFile(address);
    try {
      return await WebAssembly.compile(await response.arrayBuffer());
    } catch (error) {
      const type = response.headers.get('content-type') ?? 'no type';
      throw new Error(
        `${address} is not a WebAssembly module (served as ${type}): ${messageOf(error)}`,
      );
    }
  },

  startWorker(events, address) {
    const worker = openWorker(address);
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
    throw new Error(`Cannot load ${address}: ${response.status} ${response.statusText}`.trim());
  }
  return response;
}

const crash = (reason: string) =>
  new AbflatError('Internal', `The worker of abflat stopped: ${reason}`);

/** The error event of a script that cannot be loaded has no message. */
function notLoaded(address: string | URL = 'worker.js beside its module'): AbflatError {
  return new AbflatError('UnreadableFile', `Cannot load the worker of abflat from ${address}.`);
}

function openWorker(address?: string | URL): Worker {
  if (address !== undefined) return new Worker(address, { type: 'module' });
  if (isForeign()) return openForeignWorker();
  // Bundlers find the worker's file by exactly this expression.
  return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
}

function handleOf(worker: Worker): WorkerHandle {
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    terminate: () => worker.terminate(),
    setBusy: () => undefined,
  };
}

/** Where this module comes from; behind a name, so that bundlers do not take what follows for files of theirs. */
const here = import.meta.url;

/** Whether the module comes from another origin than the page, as from a CDN. */
function isForeign(): boolean {
  const { protocol, origin } = new URL(here);
  return /^https?:$/.test(protocol) && origin !== globalThis.location.origin;
}

/** Browsers start workers of the page's own origin only; such a one may import from elsewhere. */
function openForeignWorker(): Worker {
  const address = new URL('./worker.js', here).href;
  const script = new Blob([`import ${JSON.stringify(address)};`], { type: 'text/javascript' });
  return new Worker(URL.createObjectURL(script), { type: 'module' });
}
