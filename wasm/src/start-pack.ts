import create from './abflat-pack.js';
import { instantiate } from './instantiate.js';
import { MeshHeap } from './mesh-heap.js';
import { PackEngine } from './pack-engine.js';
import type { Start } from './serve.js';

/** Runs the module that packs layouts. */
export const startPack: Start = async (module, maxMemory) => {
  const { native, memory, hooks } = await instantiate(module, create, { maxMemory });
  return new PackEngine(native, new MeshHeap(native, memory, maxMemory), hooks);
};
