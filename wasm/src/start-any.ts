import { isModule } from './base/build-of.js';
import type { Glues } from './glue.js';
import type { Start } from './serve.js';
import { startBake } from './start-bake.js';
import { startPack } from './start-pack.js';
import { starts } from './starts.js';

/** Runs any module of the package, the main one with one of `glues`. */
export const startsAny = (glues: Glues): Start => {
  const start = starts(glues);
  return (module, maxMemory) => {
    if (isModule(module, 'pack')) return startPack(module, maxMemory);
    return (isModule(module, 'bake') ? startBake : start)(module, maxMemory);
  };
};
