import create from './abflat-bake.js';
import { BakeEngine } from './bake-engine.js';
import { instantiate } from './instantiate.js';
import type { Start } from './serve.js';

/** Runs the module that bakes. */
export const startBake: Start = async (module, maxMemory) =>
  BakeEngine.of(await instantiate(module, create, { maxMemory }), maxMemory);
