import type { UnwrapOptionValues } from 'abflat';

/** Less common options of an atlas, in the order in which they are shown. */
export const MORE = [
  'fillHoles',
  'symmetricSeams',
  't',
  'texelDensity',
  'up',
  'rotate',
  'rectify',
  'packingCuts',
  'stack',
  'straightSeams',
  'udim',
] as const satisfies (keyof UnwrapOptionValues)[];
