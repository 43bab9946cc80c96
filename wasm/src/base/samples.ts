/** Names that `sample` knows. */
export const SAMPLE_NAMES = [
  'hemisphere',
  'wavy-strip',
  'head',
  'alpha-band',
  'three-balls',
] as const;

export type SampleName = (typeof SAMPLE_NAMES)[number];
