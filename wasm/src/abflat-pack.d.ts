// The module for layouts that a mesh has that Emscripten writes; see wasm/bindings/pack/api.cpp for the functions.

import type { NativeSettings } from './glue.js';
import type { InputModule } from './input-module.js';

export interface PackModule extends InputModule {
  _abflatNewJob(): number;
  _abflatFreeJob(job: number): void;
  _abflatSetPackOption(job: number, index: number, value: number): number;
  _abflatSetVerifyOption(job: number, index: number, value: number): number;
  _abflatTriangleUv(job: number, size: number): number;
  _abflatPackedIslands(job: number, size: number): number;
  _abflatIslandTiles(job: number, size: number): number;
  _abflatPack(job: number, files: number, roundsForGltf: boolean): number;
  _abflatVerify(job: number): number;
}

export default function createPackModule(settings: NativeSettings): Promise<PackModule>;
