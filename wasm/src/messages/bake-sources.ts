// Checks the sources that callers pass to bake, and copies their images.

import { AbflatError } from '../base/errors.js';
import type { BakeSource, BakeWrap } from '../types/index.js';
import { fieldsOf } from './fields.js';
import type { BakeRequest, BakeTexture, SourceNumbers } from './protocol.js';
import { checkBoolean, checkMemory, checkNumber, knownOptions, shown, tagOf } from './validate.js';

const invalid = (message: string) => new AbflatError('InvalidOption', message);

type Sources = Pick<BakeRequest, 'images' | 'textures' | 'sources' | 'isOpaque'>;

/** Images that sources share are copied once. `hasColours`: alpha is opacity. */
export function takeSources(given: unknown, hasColours: boolean): Sources {
  const isList = Array.isArray(given);
  const list = isList ? Array.from(given as unknown[]) : [given];
  if (list.length === 0) throw invalid('sources must have at least one source.');
  const taker = new SourceTaker(hasColours);
  for (const [i, source] of list.entries()) taker.add(source, isList ? `sources[${i}]` : 'sources');
  return taker.taken;
}

const KEYS = ['image', 'wrapU', 'wrapV', 'offset', 'rotation', 'scale', 'factor', 'opaque'];

/** In the order of the module. */
const WRAPS: readonly BakeWrap[] = ['repeat', 'mirror', 'clamp'];

class SourceTaker {
  readonly taken: Sources = { images: [], textures: [], sources: [], isOpaque: true };
  readonly #hasColours: boolean;
  readonly #images = new Map<unknown, number>();
  /** Copies without alpha. */
  readonly #opaque = new Map<unknown, number>();
  readonly #textures = new Map<string, number>();

  constructor(hasColours: boolean) {
    this.#hasColours = hasColours;
  }

  add(source: unknown, name: string): void {
    if (tagOf(source) !== 'Object') throw invalid(`${name} must be an object such as { image }.`);
    const own = knownOptions(source as BakeSource, KEYS, name);
    const { image, wrapU, wrapV, offset, rotation = 0, scale, factor, opaque = false } = own;
    checkNumber(`${name}.rotation`, rotation, { range: 'that is finite' });
    checkBoolean(`${name}.opaque`, opaque);
    const hasOpacity = this.#hasColours && !opaque;
    const numbers: SourceNumbers = {
      offset: numbersOf(`${name}.offset`, offset, [0, 0]),
      rotation,
      scale: numbersOf(`${name}.scale`, scale, [1, 1]),
      factor: numbersOf(`${name}.factor`, factor, [1, 1, 1, 1]),
    };
    if (opaque) numbers.factor[3] = 1;
    if (hasOpacity) this.taken.isOpaque = false;
    const use = {
      wrapU: wrapNumber(`${name}.wrapU`, wrapU),
      wrapV: wrapNumber(`${name}.wrapV`, wrapV),
      hasOpacity,
    };
    if (image !== undefined)
      numbers.texture = this.#addTexture({
        ...this.#addImage(image, `${name}.image`, opaque),
        ...use,
      });
    this.taken.sources.push(numbers);
  }

  #addImage(image: unknown, name: string, isOpaque: boolean) {
    const { data, width, height } = pixelsOf(image, name);
    const known = isOpaque ? this.#opaque : this.#images;
    const number = known.get(image) ?? this.taken.images.push(copied(data, isOpaque)) - 1;
    known.set(image, number);
    return { image: number, width, height };
  }

  /** Textures that are alike become one, since each takes memory. */
  #addTexture(texture: BakeTexture): number {
    const key = Object.values(texture).join();
    const known = this.#textures.get(key) ?? this.taken.textures.push(texture) - 1;
    this.#textures.set(key, known);
    return known;
  }
}

function copied(data: Uint8Array, isOpaque: boolean): Uint8Array {
  const own = new Uint8Array(data);
  if (isOpaque) for (let i = 3; i < own.length; i += 4) own[i] = 255;
  return own;
}

function pixelsOf(image: unknown, name: string) {
  const { data, width, height } = fieldsOf(image, ['data', 'width', 'height']);
  for (const [key, side] of Object.entries({ width, height }))
    if (!Number.isInteger(side) || (side as number) < 1)
      throw invalid(`${name}.${key} must be a whole number of pixels from 1, not ${shown(side)}.`);
  const tag = tagOf(data);
  if (tag !== 'Uint8ClampedArray' && tag !== 'Uint8Array')
    throw invalid(`${name}.data must be a Uint8ClampedArray or Uint8Array, not ${tag}.`);
  const bytes = data as Uint8Array;
  checkMemory(`${name}.data`, bytes);
  const [w, h] = [width as number, height as number];
  if (bytes.length !== 4 * w * h)
    throw invalid(
      `${name}.data has ${bytes.length} bytes, not ${4 * w * h}: 4 for each of ${w} x ${h} pixels.`,
    );
  return { data: bytes, width: w, height: h };
}

function wrapNumber(name: string, value: unknown = 'repeat'): number {
  const number = WRAPS.indexOf(value as BakeWrap);
  if (number < 0) throw invalid(`${name} must be one of ${WRAPS.join(', ')}, not ${shown(value)}.`);
  return number;
}

function numbersOf<T extends number[]>(name: string, value: unknown, usual: T): T {
  if (value === undefined) return usual;
  if (!Array.isArray(value) || value.length !== usual.length)
    throw invalid(`${name} must be an array of ${usual.length} numbers.`);
  const numbers = Array.from(value as unknown[]);
  for (const [i, number] of numbers.entries())
    checkNumber(`${name}[${i}]`, number, { range: 'that is finite' });
  return numbers as T;
}
