import { UNWRAP_DEFAULTS, type UnwrapOptionValues } from 'abflat';

/** Options of an atlas that are seldom changed, in the order in which they are shown. */
export const MORE = [
  'fillHoles',
  'symmetricSeams',
  't',
  'texelDensity',
  'straightSeams',
  'rotate',
  'udim',
] as const satisfies (keyof UnwrapOptionValues)[];

export type MoreName = (typeof MORE)[number];
export interface MoreOptions extends Pick<UnwrapOptionValues, MoreName> {
  /** Faces that have uv in the file keep it. */
  fixedFaces?: 'uv';
}

export const MORE_LABELS: Record<MoreName, string> = {
  fillHoles: 'Fill holes',
  symmetricSeams: 'Symmetric seams',
  t: 'Boundary t',
  texelDensity: 'Texel density',
  straightSeams: 'Straight seams',
  rotate: 'Rotation',
  udim: 'UDIM tiles',
};

export function defaultOptions(): MoreOptions {
  const { fillHoles, symmetricSeams, t, texelDensity, straightSeams, rotate, udim } =
    UNWRAP_DEFAULTS;
  return { fillHoles, symmetricSeams, t, texelDensity, straightSeams, rotate, udim };
}

/** Several tiles are for a density that is given. */
export const canHaveTiles = ({ texelDensity }: MoreOptions) => texelDensity !== 'auto';

/** What of it abflat is asked for. */
export function usedOptions(options: MoreOptions): MoreOptions {
  return { ...options, udim: options.udim && canHaveTiles(options) };
}

/** "fill holes never", "no rotation": what is not as it usually is. */
export function changedOptions(options: MoreOptions): string[] {
  const changed = MORE.filter((name) => options[name] !== UNWRAP_DEFAULTS[name]).map((name) => {
    const value = options[name];
    const label = inSentence(MORE_LABELS[name]);
    if (typeof value === 'boolean') return value ? label : `no ${label}`;
    return `${label} ${value}`;
  });
  return options.fixedFaces ? ['UVs of the file kept', ...changed] : changed;
}

/** Without its capital, unless it begins with an acronym. */
function inSentence(label: string): string {
  return /^[A-Z]{2}/.test(label) ? label : label.charAt(0).toLowerCase() + label.slice(1);
}
