// Several workers that run the main module, and modules that callers hand over.

import { AbflatError } from './base/errors.js';
import type { CallSettings } from './call.js';
import { Client, type ClientSettings, type Lane } from './client.js';
import { type Placed, withModules, withoutModules } from './given-modules.js';
import { take } from './messages/input.js';
import type { Answer, Request } from './messages/protocol.js';
import { shown } from './messages/validate.js';
import { onAbort } from './on-abort.js';
import type { Platform } from './platform.js';
import { terminated } from './terminated.js';
import type { Abflat, AbortSignalLike, CreateOptions } from './types/index.js';
import { withRoom } from './with-room.js';

type Make = (platform: Platform, settings: ClientSettings) => Pool;
type Open = (platform: Platform, options: Placed<CreateOptions>, make: Make) => Promise<Abflat>;

const MOST_WORKERS = 64;

/** `open` makes an Abflat whose main calls go to what it is given. */
export async function openPool(
  platform: Platform,
  options: CreateOptions,
  open: Open,
): Promise<Abflat> {
  const { workers = 1, queue } = options;
  check('workers', workers, { from: 1, to: MOST_WORKERS });
  if (queue !== undefined) check('queue', queue, { from: 0 });
  // Several meshes at a time use several processors already.
  const build = options.build ?? 'simd';
  const usesBuild = workers > 1 && options.wasmUrl === undefined;
  const settings = usesBuild ? { ...options, build } : options;
  const placed = withoutModules(settings);
  const abflat = await open(withModules(platform), placed, (...of) => new Pool(workers, ...of));
  return queue === undefined ? abflat : withRoom(abflat, { workers, queue });
}

function check(name: string, value: unknown, { from, to = Number.POSITIVE_INFINITY }: Range): void {
  if (Number.isInteger(value) && (value as number) >= from && (value as number) <= to) return;
  const range = Number.isFinite(to) ? `from ${from} to ${to}` : `from ${from}`;
  throw new AbflatError(
    'InvalidOption',
    `${name} must be a whole number ${range}, not ${shown(value)}.`,
  );
}

interface Range {
  from: number;
  to?: number;
}

interface Waiting {
  /** Gives the call to a worker. */
  begin(client: Client): void;
  reject(error: unknown): void;
}

/** Begins calls in their order, each in the first worker that is free. */
class Pool implements Lane {
  readonly take = take;
  readonly #clients: Client[];
  readonly #free: Client[];
  readonly #waiting: Waiting[] = [];
  #isTerminated = false;

  constructor(workers: number, platform: Platform, settings: ClientSettings) {
    this.#clients = Array.from({ length: workers }, () => new Client(platform, settings));
    this.#free = [...this.#clients];
    for (const client of this.#clients) client.start();
  }

  checkUsable(signal?: AbortSignalLike): void {
    if (this.#isTerminated) throw terminated();
    if (signal?.aborted) throw signal.reason;
  }

  call<T extends Answer>(request: Request, settings: CallSettings = {}): Promise<T> {
    return new Promise<T>((resolve, reject) => {
      const call: Waiting = {
        begin: (client) => {
          stopListening();
          const running = client.call<T>(request, settings).finally(() => {
            this.#free.push(client);
            this.#next();
          });
          running.then(resolve, reject);
        },
        reject: (error) => {
          stopListening();
          reject(error);
        },
      };
      const stopListening = onAbort(settings.signal, () => {
        this.#waiting.splice(this.#waiting.indexOf(call), 1);
        call.reject(settings.signal?.reason);
      });
      this.#waiting.push(call);
      this.#next();
    });
  }

  terminate(): void {
    this.#isTerminated = true;
    for (const call of this.#waiting.splice(0)) call.reject(terminated());
    for (const client of this.#clients) client.terminate();
  }

  #next(): void {
    while (this.#waiting.length > 0 && this.#free.length > 0)
      this.#waiting.shift()?.begin(this.#free.shift() as Client);
  }
}
