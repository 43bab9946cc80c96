import { isBake } from './base/build-of.js';
import type { Glues } from './glue.js';
import type { Start } from './serve.js';
import { startBake } from './start-bake.js';
import { starts } from './starts.js';

/** Runs any module of the package, the main one with one of `glues`. */
export const startsAny = (glues: Glues): Start => {
  const start = starts(glues);
  return (module, maxMemory) => (isBake(module) ? startBake : start)(module, maxMemory);
};
