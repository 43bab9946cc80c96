// How a surface looks in its file: materials, textures and colours of vertices.

/** How a texture continues beyond its image. */
export const Wrap = { Repeat: 0, Mirror: 1, Clamp: 2 } as const;
export type Wrap = (typeof Wrap)[keyof typeof Wrap];

/** In place of a cutoff: all of the surface is seen, or as much as its opacity says. */
export const OPAQUE = 0;
export const BLENDED = 2;

/** What is the same for all triangles with one material. */
export interface MaterialLook {
  /** Number of an image; null if there is none. */
  image: number | null;
  wrap: [Wrap, Wrap];
  /** Whether texels are squares, not blended with their neighbours. */
  isPixelated: boolean;
  /** The least opacity that is seen, or OPAQUE or BLENDED. */
  cutoff: number;
  /** Whether light makes no difference. */
  isUnlit: boolean;
}

/** Corners per row of the texture that has what differs from corner to corner. */
export const CORNERS_PER_ROW = 2048;

/** Four words per corner of each triangle, in whole rows: see files/corner-looks.ts. */
export type CornerLooks = Uint32Array;

export interface Appearance {
  corners: CornerLooks;
  materials: MaterialLook[];
  /** All of the same size, a power of two in each direction. */
  images: ImageBitmap[];
  /** Whether it has more than a single colour. */
  isVaried: boolean;
}

/** What was found in a file. */
export interface AppearanceRead {
  /** Null if the file has only a shape, or nothing that can be shown. */
  appearance: Appearance | null;
  /** What is missing, as sentences. */
  remarks: string[];
}
