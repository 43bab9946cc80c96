import create from './abflat-pack.js';
import { instantiate } from './instantiate.js';
import { PackEngine } from './pack-engine.js';
import type { Start } from './serve.js';

/** Runs the module for layouts that a mesh has. */
export const startPack: Start = async (module, maxMemory) =>
  PackEngine.of(await instantiate(module, create, { maxMemory }), maxMemory);
