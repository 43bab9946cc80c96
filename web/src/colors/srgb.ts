/** Of a linear value from 0 on. */
export const srgbOf = (linear: number) =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;

/** The inverse, from 0 to 1. */
export const linearOf = (srgb: number) =>
  srgb <= 0.04045 ? srgb / 12.92 : ((srgb + 0.055) / 1.055) ** 2.4;

/** Of a linear value from 0 to 1, as a byte; values outside are clamped. */
export const srgbByte = (linear: number) =>
  Math.round(255 * srgbOf(Math.min(1, Math.max(0, linear))));

/** Of a value from 0 to 1 that is stored as it is; anything else is clamped, or 1 if it is no number. */
export function byteOf(value: number): number {
  return Number.isNaN(value) ? 255 : Math.round(255 * Math.min(1, Math.max(0, value)));
}
