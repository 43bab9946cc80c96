// Makes an instance of a WebAssembly module of the package.

import { MIN_MEMORY, PAGE } from './base/memory.js';
import type { CreateModule } from './glue.js';
import { OutOfMemory, readString } from './heap.js';
import type { AnyProgress } from './messages/protocol.js';

/** What an instance tells while it works; to be set for each call. */
export interface Hooks {
  onProgress(progress: AnyProgress): void;
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
  { maxMemory, isShared = false, threadScript }: Settings,
): Promise<Instance<N>> {
  const memory = new WebAssembly.Memory({
    initial: MIN_MEMORY / PAGE,
    maximum: Math.floor(maxMemory / PAGE),
    shared: isShared,
  });
  const hooks: Hooks = { onProgress: ignore };
  const native = await new Promise<N>((resolve, reject) => {
    create({
      wasmMemory: memory,
      ...(threadScript && { mainScriptUrlOrBlob: threadScript() }),
      instantiateWasm: (imports, receive) => {
        WebAssembly.instantiate(module, imports)
          .then((instance) => receive(instance, module))
          .catch(reject);
        return {};
      },
      print: ignore,
      printErr: ignore, // repeats what is thrown
      onProgress: (stage, newtonStep, constraintResidual, fraction) => {
        const name = readString(memory, stage);
        hooks.onProgress({ stage: name, newtonStep, constraintResidual, fraction } as AnyProgress);
      },
      onOutOfMemory: () => {
        throw new OutOfMemory();
      },
    }).then(resolve, reject);
  });
  return { native, memory, hooks };
}

function ignore(): void {
  // Nobody listens.
}
