import { Engine } from './engine.js';
import type { Glues } from './glue.js';
import type { Start } from './serve.js';

/** Runs the main module. `glues`: the builds that the worker can run. */
export const starts =
  (glues: Glues): Start =>
  (module, maxMemory) =>
    Engine.create(module, maxMemory, glues);
