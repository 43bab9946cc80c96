// Calls that wait until there is room for copies of their arrays.

import { fieldOf } from './messages/fields.js';
import { checkSignal } from './messages/validate.js';
import { onAbort } from './on-abort.js';
import { terminated } from './terminated.js';
import type { Abflat, AbortSignalLike } from './types/index.js';

/**
 * The same with at most `queue` calls beyond those that `workers` run: later ones wait, in their
 * order, before they read their arguments. `pack` and `verify` share a worker, and `bake` has one.
 */
export function withRoom(
  abflat: Abflat,
  { workers, queue }: { workers: number; queue: number },
): Abflat {
  const [main, packing, baking] = [workers, 1, 1].map((running) => new Room(running + queue)) as [
    Room,
    Room,
    Room,
  ];
  return {
    build: abflat.build,
    flatten: (mesh, options) => main.admit(options, () => abflat.flatten(mesh, options)),
    unwrap: (mesh, options) => main.admit(options, () => abflat.unwrap(mesh, options)),
    compare: (mesh, options) => main.admit(options, () => abflat.compare(mesh, options)),
    inspect: (mesh, options) => main.admit(options, () => abflat.inspect(mesh, options)),
    pinWeights: (mesh, pins, options) =>
      main.admit(options, () => abflat.pinWeights(mesh, pins, options)),
    load: (file, options) => main.admit(options, () => abflat.load(file, options)),
    sample: (name, options) => main.admit(options, () => abflat.sample(name, options)),
    pack: (mesh, options) => packing.admit(options, () => abflat.pack(mesh, options)),
    verify: (mesh, options) => packing.admit(options, () => abflat.verify(mesh, options)),
    bake: (mesh, layout, sources, options) =>
      baking.admit(options, () => abflat.bake(mesh, layout, sources, options)),
    terminate: () => {
      abflat.terminate();
      for (const room of [main, packing, baking]) room.close();
    },
  };
}

interface Waiting {
  enter(): void;
  refuse(error: unknown): void;
}

class Room {
  #free: number;
  readonly #waiting: Waiting[] = [];

  constructor(places: number) {
    this.#free = places;
  }

  /** Makes a call, at once if there is room. */
  async admit<T>(options: unknown, make: () => Promise<T>): Promise<T> {
    if (this.#free > 0) --this.#free;
    else await this.#turn(options);
    try {
      return await make();
    } finally {
      const next = this.#waiting.shift();
      if (next) next.enter();
      else ++this.#free;
    }
  }

  close(): void {
    for (const each of this.#waiting.splice(0)) each.refuse(terminated());
  }

  async #turn(options: unknown): Promise<void> {
    const signal = fieldOf(options, 'signal') as AbortSignalLike | undefined;
    checkSignal(signal);
    if (signal?.aborted) throw signal.reason;
    return new Promise<void>((resolve, reject) => {
      const own: Waiting = {
        enter: () => {
          stopListening();
          resolve();
        },
        refuse: (error) => {
          stopListening();
          reject(error);
        },
      };
      const stopListening = onAbort(signal, () => {
        this.#waiting.splice(this.#waiting.indexOf(own), 1);
        own.refuse(signal?.reason);
      });
      this.#waiting.push(own);
    });
  }
}
