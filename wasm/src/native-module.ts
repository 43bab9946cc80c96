// The functions of the main module; see wasm/bindings/main/api.cpp.

import type { InputModule } from './input-module.js';

/** Pointers and sizes are unsigned in C++ and signed here: add `>>> 0`. */
export interface NativeModule extends InputModule {
  _abflatNewJob(): number;
  _abflatFreeJob(job: number): void;
  _abflatSetOption(job: number, index: number, value: number): number;
  _abflatSetUnwrapOption(job: number, index: number, value: number): number;
  _abflatSeams(job: number, bytes: number): number;
  _abflatArray(job: number, array: number, count: number): number;
  _abflatKeepUv(job: number): void;
  _abflatKeepsValidOnly(job: number): void;
  _abflatKeepsPlaces(job: number): void;
  _abflatKnown(job: number, field: number, count: number): number;
  _abflatNormalizes(job: number): void;
  _abflatKnownOptions(job: number, t: number, balance: number, straightSeams: boolean): void;
  _abflatAddBound(job: number, vertex: number, t: number): void;
  _abflatAddStraight(job: number, from: number, to: number): void;
  _abflatAddPin(job: number, vertex: number, u: number, v: number, face: number): void;
  _abflatFlatten(job: number, files: number, roundsForGltf: boolean): number;
  _abflatUnwrap(job: number, files: number, roundsForGltf: boolean): number;
  _abflatCompare(job: number): number;
  _abflatPinWeights(job: number): number;
  _abflatInspect(job: number): number;
  _abflatLoad(job: number): number;
  _abflatSample(job: number, detail: number): number;
  _abflatMethodUvData(job: number, method: number): number;
  _abflatMethodUvSize(job: number, method: number): number;
  _abflatBuild(): number;
  _abflatStatusCount(): number;
  _abflatStatusName(code: number): number;
  _abflatSampleCount(): number;
  _abflatSampleName(index: number): number;
}
