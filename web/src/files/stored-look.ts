import type { DisplayMesh } from '../mesh/mesh';
import type { MaterialLook } from '../model/appearance';
import type { CornerWriter } from './corner-looks';

/** A mesh as it was opened. */
export type LookMesh = Pick<DisplayMesh, 'indices' | 'faces'>;

/** An image as it is stored. */
export interface StoredImage {
  name: string;
  bytes: Blob;
  /** Whether its texels stay squares when it is enlarged. */
  isPixelated: boolean;
}

/** How a file looks, with images as they are stored. */
export interface StoredLook {
  corners: CornerWriter;
  /** Their images are numbers in `images`. */
  materials: MaterialLook[];
  images: StoredImage[];
  /** Names of files that are not there. */
  missing: string[];
}
