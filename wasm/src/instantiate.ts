// Makes an instance of a WebAssembly module of the package.

import { MIN_MEMORY, PAGE } from './base/memory.js';
import type { CreateModule, NativeSettings } from './glue.js';
import { OutOfMemory, readString } from './heap.js';
import type { AnyProgress } from './messages/protocol.js';

/** What an instance tells while it works; to be set for each call. */
export interface Hooks {
  /** Returns whether to go on; otherwise the run ends with the status Aborted. */
  onProgress(progress: AnyProgress): boolean;
}

export interface Instance<N> {
  native: N;
  memory: WebAssembly.Memory;
  hooks: Hooks;
}

interface Settings {
  maxMemory: number;
  /** For a module with threads, with the script that each of them loads. */
  isShared?: boolean;
  threadScript?: () => string;
}

export async function instantiate<N>(
  module: WebAssembly.Module,
  create: CreateModule<N>,
  settings: Settings,
): Promise<Instance<N>> {
  const { memory, hooks, common } = prepared(settings);
  const native = await new Promise<N>((resolve, reject) => {
    create({
      ...common,
      instantiateWasm: (imports, receive) => {
        WebAssembly.instantiate(module, imports)
          .then((instance) => receive(instance, module))
          .catch(reject);
        return {};
      },
    }).then(resolve, reject);
  });
  return { native, memory, hooks };
}

/**
 * The same at once, or undefined where that is impossible: some hosts only compile and instantiate
 * asynchronously, and so do the scripts of some releases of Emscripten.
 */
export function instantiateNow<N extends object>(
  module: WebAssembly.Module,
  create: CreateModule<N>,
  settings: Settings,
): Instance<N> | undefined {
  const { memory, hooks, common } = prepared(settings);
  let isLate = false;
  const native = {
    ...common,
    instantiateWasm: (imports: WebAssembly.Imports, receive: Receive) => {
      // A script that is asked after it has returned has a promise of its own to reject.
      if (isLate) throw new Error('too late');
      receive(new WebAssembly.Instance(module, imports), module);
      return {};
    },
  };
  try {
    create(native).catch(ignore);
  } catch {
    return undefined;
  }
  isLate = true;
  const isReady = (native as { calledRun?: unknown }).calledRun === true;
  return isReady ? { native: native as unknown as N, memory, hooks } : undefined;
}

type Receive = Parameters<NativeSettings['instantiateWasm']>[1];

function prepared({ maxMemory, isShared = false, threadScript }: Settings) {
  const memory = new WebAssembly.Memory({
    initial: MIN_MEMORY / PAGE,
    maximum: Math.floor(maxMemory / PAGE),
    shared: isShared,
  });
  const hooks: Hooks = { onProgress: () => true };
  const common: Omit<NativeSettings, 'instantiateWasm'> = {
    wasmMemory: memory,
    ...(threadScript && { mainScriptUrlOrBlob: threadScript() }),
    print: ignore,
    printErr: ignore, // repeats what is thrown
    onProgress: (stage, newtonStep, constraintResidual, fraction) => {
      const name = readString(memory, stage);
      return hooks.onProgress({
        stage: name,
        newtonStep,
        constraintResidual,
        fraction,
      } as AnyProgress);
    },
    onOutOfMemory: () => {
      throw new OutOfMemory();
    },
  };
  return { memory, hooks, common };
}

function ignore(): void {
  // Nobody listens.
}
