// The call that the module for baking answers. Runs in the worker, where it may block.

import type { BakeModule } from './abflat-bake.js';
import { AbflatError } from './base/errors.js';
import { Heap } from './heap.js';
import type { Instance } from './instantiate.js';
import type { Answer, BakeRequest, BakeTexture, Request } from './messages/protocol.js';
import { Runner } from './runner.js';
import type { BakedImage } from './types/index.js';

/** For a source without an image: kNoTexture of the module. */
const NO_TEXTURE = 2 ** 32 - 1;

export class BakeEngine extends Runner<BakeModule, Heap> {
  static of({ native, memory, hooks }: Instance<BakeModule>, maxMemory: number): BakeEngine {
    return new BakeEngine(native, new Heap(memory, maxMemory), hooks);
  }

  protected readonly task = 'image';
  protected readonly advice = 'Use smaller images, a smaller bakeResolution';

  protected answer(request: Request): Answer {
    if (request.kind !== 'bake')
      throw new AbflatError('Internal', `The module that bakes does not ${request.kind}.`);
    return this.withJob((job) => this.#bake(job, request));
  }

  #bake(job: number, request: BakeRequest): BakedImage {
    this.#write(job, request);
    this.#writeSources(job, request);
    const { native } = this;
    this.check(job, native._abflatBake(job));
    const width = native._abflatWidth(job);
    const height = native._abflatHeight(job);
    const data = this.heap.copy(native._abflatPixels(job), 4 * width * height);
    return { data: new Uint8ClampedArray(data), width, height };
  }

  #write(job: number, { mesh, layout, images }: BakeRequest): void {
    const { heap, native } = this;
    const arrays = [...Object.values(mesh), ...Object.values(layout), ...images];
    heap.checkBytes(8 * arrays.reduce((sum, array) => sum + (array?.length ?? 0), 0));
    const { positions, texcoords, colours, normals, tangents, indices, materials, parts } = mesh;
    const { uv, vertexMap } = layout;
    heap.writeReals(native._abflatPositions(job, positions.length), positions);
    heap.writeReals(native._abflatTexcoords(job, texcoords.length), texcoords);
    if (colours) heap.writeFloats(native._abflatColours(job, colours.length), colours);
    if (normals) heap.writeFloats(native._abflatNormals(job, normals.length), normals);
    if (tangents) heap.writeFloats(native._abflatTangents(job, tangents.length), tangents);
    heap.writeNumbers(native._abflatIndices(job, indices.length), indices);
    if (materials) heap.writeNumbers(native._abflatMaterials(job, materials.length), materials);
    if (parts) heap.writeNumbers(native._abflatParts(job, parts.length), parts);
    heap.writeReals(native._abflatUv(job, uv.length), uv);
    heap.writeNumbers(native._abflatLayoutIndices(job, layout.indices.length), layout.indices);
    if (vertexMap) heap.writeNumbers(native._abflatVertexMap(job, vertexMap.length), vertexMap);
  }

  #writeSources(job: number, { values, isOpaque, images, textures, sources }: BakeRequest): void {
    const { heap, native } = this;
    const [kind = 0, resolution = 0, padding = 0, layoutResolution = 0] = values;
    native._abflatSettings(job, kind, resolution, layoutResolution, padding, isOpaque);
    for (const image of images) heap.writeBytes(native._abflatImage(job, image.length), image);
    for (const texture of textures) this.#addTexture(job, texture);
    for (const { texture = NO_TEXTURE, offset, rotation, scale, factor } of sources)
      native._abflatSource(job, texture, ...offset, rotation, ...scale, ...factor);
  }

  #addTexture(job: number, { image, width, height, wrapU, wrapV, hasOpacity }: BakeTexture): void {
    this.native._abflatTexture(job, image, width, height, wrapU, wrapV, hasOpacity);
  }

  protected readText(job: number): string {
    const { native } = this;
    const bytes = this.heap.copy(native._abflatTextData(job), native._abflatTextSize(job));
    return new TextDecoder().decode(bytes);
  }
}
