// Settings for a purpose, in place of defaults.

import { AbflatError } from './base/errors.js';
import { ownFields } from './messages/fields.js';
import { checkNumber, shown } from './messages/validate.js';
import type { UnwrapOptions } from './types/index.js';

export type Preset = 'lightmap';

export interface PresetOptions {
  /**
   * `lightmap`: for images that are computed texel by texel and read through mip levels. Charts are
   * turned by quarter turns only, have the sides of their boxes on borders of texels, and are so far
   * apart that two free texels are between them in each of `mipLevels`.
   */
  preset?: Preset;
  /**
   * Mip levels below the image in which charts stay apart, from 0 to 6: `padding` becomes
   * 3 * 2^mipLevels - 1. Only with `preset`. Default: 1.
   */
  mipLevels?: number;
}

const MOST_LEVELS = 6;

const invalid = (message: string) => new AbflatError('InvalidOption', message);

/** The options with what their preset sets, where they do not say otherwise. */
export function withPreset<
  T extends PresetOptions & Pick<UnwrapOptions, 'padding' | 'rotate' | 'snapToTexels'>,
>(options: T): Omit<T, keyof PresetOptions> {
  const own = ownFields(options);
  const { preset, mipLevels, ...others } = own;
  if (preset !== undefined && preset !== 'lightmap')
    throw invalid(`preset must be 'lightmap', not ${shown(preset)}.`);
  if (preset === undefined) {
    if (mipLevels === undefined) return others;
    throw invalid("mipLevels belongs to preset: 'lightmap'. Without a preset, set padding.");
  }
  const { padding = paddingFor(mipLevels ?? 1), rotate = 'quarter', snapToTexels = true } = own;
  if (mipLevels !== undefined && own.padding !== undefined)
    throw invalid(
      'padding and mipLevels both say how far charts are apart. Leave one of them out.',
    );
  return { ...others, padding, rotate, snapToTexels };
}

/** A texel of a level may begin anywhere in the gap, so two whole ones need room for nearly three. */
function paddingFor(mipLevels: number): number {
  const range = `that is whole, from 0 to ${MOST_LEVELS}`;
  checkNumber('mipLevels', mipLevels, { range, atLeast: 0, atMost: MOST_LEVELS });
  if (!Number.isInteger(mipLevels))
    throw invalid(`mipLevels must be a number ${range}, not ${mipLevels}.`);
  return 3 * 2 ** mipLevels - 1;
}
