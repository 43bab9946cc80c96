import { BUILDS, type Build, type LateName, type ModuleName, whyNoThreads } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { addressOf, browserFiles, COPY } from './files-browser.js';
import type { FromWorker } from './messages/protocol.js';
import type { Address, Platform, WorkerHandle } from './platform.js';

/** How a module and its worker are named so that bundlers find them. */
export interface OwnFile {
  wasm(): URL;
  worker(): Worker;
}

/** Of the builds that an entry has, and of what all have. */
export type OwnFiles = Record<LateName, OwnFile> & Partial<Record<Build, OwnFile>>;

export function browserPlatform(own: OwnFiles): Platform {
  const fileOf = (name: ModuleName) => {
    const file = own[name];
    if (file && here) return file;
    throw new AbflatError(
      'UnreadableFile',
      'A bundle that is not an ES module cannot find its files. Pass baseUrl to createAbflat.',
    );
  };
  return {
    ...browserFiles((name) => fileOf(name).wasm()),

    builds: BUILDS.filter((build) => own[build]),

    whyNoThreads,

    workerFile: (name) => `worker-${name}.js`,

    startWorker(events, name, address) {
      const worker = openWorker(name, address, () => fileOf(name).worker());
      worker.onmessage = (event: MessageEvent<FromWorker>) => events.onMessage(event.data);
      worker.onmessageerror = () => events.onCrash(crash('a message from it cannot be read'));
      worker.onerror = (event) => {
        event.preventDefault();
        events.onCrash(event.message ? crash(event.message) : notLoaded(address));
      };
      return handleOf(worker);
    },
  };
}

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

function openWorker(name: ModuleName, address: Address | undefined, openOwn: () => Worker): Worker {
  const url = address === undefined ? new URL(`./worker-${name}.js`, here) : addressOf(address);
  try {
    if (isForeign(url)) return openForeignWorker(url);
    return address === undefined ? openOwn() : new Worker(url, { type: 'module' });
  } catch (error) {
    throw new AbflatError(
      'UnreadableFile',
      `The browser cannot start the worker of abflat: ${messageOf(error)}.`,
      'worker',
    );
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
