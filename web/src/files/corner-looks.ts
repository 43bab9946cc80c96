import { CORNERS_PER_ROW, type CornerLooks } from '../model/appearance';

/** Red, green, blue (sRGB) and opacity as bytes, in one word. */
export type Tint = number;

export const WHITE: Tint = 0xffffffff;

export const tintOf = (red: number, green: number, blue: number, alpha: number): Tint =>
  (red | (green << 8) | (blue << 16) | (alpha << 24)) >>> 0;

export interface CornerLook {
  /** In the image, measured from its upper left corner. */
  u: number;
  v: number;
  material: number;
  /** Multiplies the image. */
  tint: Tint;
}

/** Fills in how corners look: u and v as floats, the material and the tint. */
export class CornerWriter {
  readonly words: CornerLooks;
  private readonly floats: Float32Array;

  constructor(private readonly count: number) {
    this.words = new Uint32Array(4 * CORNERS_PER_ROW * Math.ceil(count / CORNERS_PER_ROW));
    this.floats = new Float32Array(this.words.buffer);
  }

  set(corner: number, { u, v, material, tint }: CornerLook): void {
    this.floats[4 * corner] = Number.isFinite(u) ? u : 0;
    this.floats[4 * corner + 1] = Number.isFinite(v) ? v : 0;
    this.words[4 * corner + 2] = material;
    this.words[4 * corner + 3] = tint;
  }

  /** The tint of all corners; null if they differ. */
  get onlyTint(): Tint | null {
    const { words, count } = this;
    for (let c = 1; c < count; ++c) if (words[4 * c + 3] !== words[3]) return null;
    return count > 0 ? words[3] : WHITE;
  }
}
