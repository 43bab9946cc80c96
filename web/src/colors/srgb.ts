/** Of a linear value from 0 to 1, as a byte; values outside are clamped. */
export function srgbByte(linear: number): number {
  const x = Math.min(1, Math.max(0, linear));
  return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
}

/** Of a value from 0 to 1 that is stored as it is; anything else is clamped, or 1 if it is no number. */
export function byteOf(value: number): number {
  return Number.isNaN(value) ? 255 : Math.round(255 * Math.min(1, Math.max(0, value)));
}
