import create from './abflat-bake.js';
import { BakeEngine } from './bake-engine.js';
import { Heap } from './heap.js';
import { instantiate } from './instantiate.js';
import type { Start } from './serve.js';

/** Runs the module that bakes. */
export const startBake: Start = async (module, maxMemory) => {
  const { native, memory, hooks } = await instantiate(module, create, { maxMemory });
  return new BakeEngine(native, new Heap(memory, maxMemory), hooks);
};
