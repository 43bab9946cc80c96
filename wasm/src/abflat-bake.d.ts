// The module for baking that Emscripten writes; see wasm/bindings/bake/api.cpp for the functions.

import type { NativeSettings } from './glue.js';

/** Pointers and sizes are unsigned in C++ and signed here: add `>>> 0`. */
export interface BakeModule {
  _abflatNewJob(): number;
  _abflatFreeJob(job: number): void;
  _abflatPositions(job: number, count: number): number;
  _abflatTexcoords(job: number, count: number): number;
  _abflatColours(job: number, count: number): number;
  _abflatNormals(job: number, count: number): number;
  _abflatTangents(job: number, count: number): number;
  _abflatIndices(job: number, count: number): number;
  _abflatMaterials(job: number, count: number): number;
  _abflatParts(job: number, count: number): number;
  _abflatUv(job: number, count: number): number;
  _abflatLayoutIndices(job: number, count: number): number;
  _abflatVertexMap(job: number, count: number): number;
  _abflatSettings(
    job: number,
    kind: number,
    resolution: number,
    layoutResolution: number,
    padding: number,
    isOpaque: boolean,
  ): void;
  _abflatImage(job: number, bytes: number): number;
  _abflatTexture(
    job: number,
    image: number,
    width: number,
    height: number,
    wrapU: number,
    wrapV: number,
    alphaIsOpacity: boolean,
  ): void;
  _abflatSource(
    job: number,
    texture: number,
    offsetU: number,
    offsetV: number,
    rotation: number,
    scaleU: number,
    scaleV: number,
    red: number,
    green: number,
    blue: number,
    alpha: number,
  ): void;
  _abflatBake(job: number): number;
  _abflatWidth(job: number): number;
  _abflatHeight(job: number): number;
  _abflatPixels(job: number): number;
  _abflatTextData(job: number): number;
  _abflatTextSize(job: number): number;
}

export default function createBakeModule(settings: NativeSettings): Promise<BakeModule>;
