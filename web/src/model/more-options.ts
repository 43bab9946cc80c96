import { UNWRAP_DEFAULTS, type UnwrapOptionValues } from 'abflat';
import { OPTION_LABELS, OPTIONS } from '../words/controls';
import { SETTINGS } from '../words/run';
import { PACKING } from '../words/selection';
import { MORE } from './more-names';

export type MoreName = (typeof MORE)[number];
/** What can have UDIM tiles of its own. */
export const PART_TILES = ['object', 'material'] as const;
export type PartTiles = (typeof PART_TILES)[number];

export interface MoreOptions extends Pick<UnwrapOptionValues, MoreName> {
  /** Each of these has a tile of its own; undefined: all share one, or those of `udim`. */
  tiles?: PartTiles;
  /** Faces that have uv in the file keep it. */
  fixedFaces?: 'uv';
}

export const MORE_LABELS: Record<MoreName, string> = OPTION_LABELS;

export function defaultOptions(): MoreOptions {
  const { fillHoles, symmetricSeams, t, texelDensity, up } = UNWRAP_DEFAULTS;
  const { rotate, rectify, packingCuts, stack, straightSeams, udim } = UNWRAP_DEFAULTS;
  const first = { fillHoles, symmetricSeams, t, texelDensity, up };
  return { ...first, rotate, rectify, packingCuts, stack, straightSeams, udim };
}

/** Several tiles need a given texel density, and are not those of objects. */
export const canHaveTiles = ({ texelDensity, tiles }: MoreOptions) =>
  texelDensity !== 'auto' && tiles === undefined;

/** The options that are passed to abflat. */
export function usedOptions(options: MoreOptions): MoreOptions {
  return { ...options, udim: options.udim && canHaveTiles(options) };
}

/** The options that differ from their defaults, such as "fill holes never" or "rotation none". */
export function changedOptions(options: MoreOptions): string[] {
  const changed = MORE.filter((name) => options[name] !== UNWRAP_DEFAULTS[name]).map((name) => {
    const value = options[name];
    const label = inSentence(MORE_LABELS[name]);
    if (typeof value === 'boolean') return value ? label : OPTIONS.off(label);
    return OPTIONS.setTo(label, value);
  });
  const kept = options.fixedFaces ? [OPTIONS.keepingUvs] : [];
  const tiles = options.tiles ? [SETTINGS.tiles(PACKING.tiles[options.tiles])] : [];
  return [...kept, ...changed, ...tiles];
}

/** Without its capital letter, unless it begins with an acronym. */
function inSentence(label: string): string {
  return /^[A-Z]{2}/.test(label) ? label : label.charAt(0).toLowerCase() + label.slice(1);
}
