// Generated from core/schema by scripts/generate.mjs, do not edit.

export type Kind = 'colour' | 'data' | 'normal';

/** The options of baking that are plain values, with their defaults. */
export interface BakeOptionValues {
  kind: Kind;
  bakeResolution: number | readonly [width: number, height: number] | 'auto';
  padding: number;
  layoutResolution: number | readonly [width: number, height: number] | 'none';
}

export const BAKE_DEFAULTS: Readonly<BakeOptionValues> = {
  kind: 'colour',
  bakeResolution: 'auto',
  padding: 2,
  layoutResolution: 'none',
};

/** Type, default, bounds and help text of every option, in the order of the C++ side; `range` says the bounds in words. */
export const BAKE_OPTIONS = {
  kind: { type: 'choice', default: 'colour', choices: ['colour', 'data', 'normal'], text: 'what the image holds: colour = colours, sRGB in the image, mixed as light; alpha is opacity; data = numbers, mixed as they are, such as roughness; normal = a tangent space normal map, which is turned with the charts', range: 'colour, data, normal' },
  bakeResolution: { type: 'size', default: 'auto', atLeast: 16, atMost: 8192, words: { auto: 0 }, text: 'size of the new images in texels; of a number, the longer side of an image in the shape of the layout (auto = for each map the power of two that is nearest to the texels of the old images, or that of the layout if there are none)', range: 'at least 16 and at most 8192, whole, or two of these, as in [2048, 1024], or auto' },
  padding: { type: 'integer', default: 2, atLeast: 0, atMost: 256, text: 'texels around charts that take the colour of the nearest texel within', range: 'at least 0 and at most 256, whole' },
  layoutResolution: { type: 'size', default: 'none', atLeast: 1, atMost: 32768, words: { none: 0 }, text: 'resolution that the layout was packed for: new images have its shape; padding is in its texels and grows with the image (none = a square, with padding in texels of the new image)', range: 'at least 1 and at most 32768, whole, or two of these, as in [2048, 1024], or none' },
} as const;
