// Runs abflat with the options of xatlas for packing.

import { AbflatError } from '../base/errors.js';
import type { PackOptionValues } from '../base/generated.js';
import type { Layout } from '../types/index.js';
import type { PackOptions } from './types.js';

/** The common options of `unwrap` and `pack`. */
export type PlaceOptions = Partial<
  Pick<PackOptionValues, 'resolution' | 'padding' | 'margin' | 'texelDensity' | 'udim' | 'rotate'>
>;

/** What a layout says of its atlas. */
export interface AtlasNumbers {
  resolution: number;
  tiles: number;
  texelDensity: number;
}

export type Run<L extends Layout<unknown>> = (options: PlaceOptions) => {
  layout: L;
  numbers: AtlasNumbers;
};

type Placed<L extends Layout<unknown>> = ReturnType<Run<L>>;

const SIDE = [16, 32768] as const;
const LARGEST_PADDING = 256;
const USUAL_SIDE = 1024;
const GROWTH = 1.1;

export class Placer<L extends Layout<unknown>> {
  readonly #run: Run<L>;
  readonly #options: Required<PackOptions>;
  readonly #usual: PlaceOptions;
  /** What differs from what was asked for, one sentence each. */
  readonly notes: string[] = [];

  constructor(run: Run<L>, options: Required<PackOptions>) {
    this.#run = run;
    this.#options = options;
    // Bilinear filtering reads the texel beside a chart, on both sides of a gap.
    const texels = Math.round(options.padding) + (options.bilinear ? 2 : 0);
    this.#usual = {
      padding: this.#clamped('padding', texels, [0, LARGEST_PADDING]),
      margin: Math.min(Math.ceil(options.padding / 2), LARGEST_PADDING),
      ...(!options.rotateCharts && { rotate: 'none' as const }),
    };
  }

  place(): Placed<L> {
    const { resolution, texelsPerUnit } = this.#options;
    // Padding needs room beside charts.
    const least = Math.max(SIDE[0], 4 * (this.#usual.padding ?? 0));
    const side =
      resolution && this.#clamped('resolution', Math.round(resolution), [least, SIDE[1]]);
    if (texelsPerUnit <= 0) return this.#largest(side || USUAL_SIDE);
    if (side === 0) return this.#atDensity(texelsPerUnit, least);
    try {
      const options = { resolution: side, texelDensity: texelsPerUnit, udim: true };
      return this.#run({ ...this.#usual, ...options });
    } catch (error) {
      if (!isTooSmall(error)) throw error;
      this.notes.push(`texelsPerUnit is lower, so that charts fit: ${error.message}`);
      return this.#largest(side);
    }
  }

  /** As many texels per unit as fit; a larger atlas if charts and padding do not fit at all. */
  #largest(resolution: number): Placed<L> {
    try {
      return this.#run({ ...this.#usual, resolution });
    } catch (error) {
      if (!isTooSmall(error) || resolution >= SIDE[1]) throw error;
      this.notes.push(
        `The atlas is larger than ${resolution} texels, so that charts fit: ${error.message}`,
      );
      return this.#largest(Math.min(2 * resolution, SIDE[1]));
    }
  }

  /** One atlas as large as the density needs. */
  #atDensity(texelDensity: number, least: number): Placed<L> {
    const { numbers } = this.#largest(USUAL_SIDE);
    const share = texelDensity / numbers.texelDensity;
    let side = Math.max(least, Math.ceil(numbers.resolution * share));
    while (side <= SIDE[1]) {
      try {
        return this.#run({ ...this.#usual, resolution: side, texelDensity });
      } catch (error) {
        if (!isTooSmall(error)) throw error;
        side = Math.ceil(side * GROWTH);
      }
    }
    this.notes.push(`texelsPerUnit is lower: an atlas has at most ${SIDE[1]} texels a side.`);
    return this.#largest(SIDE[1]);
  }

  #clamped(name: string, value: number, [least, most]: readonly [number, number]): number {
    const inside = Math.min(Math.max(value, least), most);
    if (inside !== value)
      this.notes.push(`${name} is ${inside}, not ${value}: it can be ${least} to ${most}.`);
    return inside;
  }
}

const isTooSmall = (error: unknown): error is AbflatError =>
  error instanceof AbflatError && error.code === 'AtlasTooSmall';
