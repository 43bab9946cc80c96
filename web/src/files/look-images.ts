import { NOT_LOADED } from '../base/lost';
import { KTX2, ktx2Pixels } from './ktx2';
import type { StoredImage } from './stored-look';

export interface DecodedImages {
  /** All of one size. */
  images: ImageBitmap[];
  /** For each stored image its number in `images`; null if it cannot be decoded. */
  numbers: (number | null)[];
}

const LARGEST = 2048;
/** Every browser allows as many layers. */
const MOST_IMAGES = 256;
/** The values of the file, as they are. */
const PLAIN: ImageBitmapOptions = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };

/** The most pixels along a side, so that as many images fit in `bytes`. */
export function sideFor(count: number, bytes: number): number {
  let side = LARGEST;
  while (side > 64 && 4 * side * side * count > bytes) side /= 2;
  return side;
}

/** Decodes one image after the other, so that at most one of them is there in its full size. */
export async function decodeImages(stored: StoredImage[], bytes: number): Promise<DecodedImages> {
  const side = sideFor(stored.length, bytes);
  const images: ImageBitmap[] = [];
  const pixelated: boolean[] = [];
  const numbers: (number | null)[] = [];
  for (const { bytes, isPixelated } of stored) {
    const image = images.length < MOST_IMAGES ? await decoded(bytes) : null;
    numbers.push(image && images.length);
    if (!image) continue;
    const [width, height] = [image.width, image.height].map((size) => Math.min(side, size));
    images.push(await resized(image, width, height, isPixelated));
    pixelated.push(isPixelated);
  }
  const width = powerOfTwo(images.map((image) => image.width));
  const height = powerOfTwo(images.map((image) => image.height));
  for (const [i, image] of images.entries())
    images[i] = await resized(image, width, height, pixelated[i]);
  return { images, numbers };
}

/** The least that is not below any of the numbers. */
const powerOfTwo = (sizes: number[]) => 2 ** Math.ceil(Math.log2(Math.max(1, ...sizes)));

async function decoded(bytes: Blob): Promise<ImageBitmap | null> {
  try {
    return await createImageBitmap(bytes.type === KTX2 ? await imageOf(bytes) : bytes, PLAIN);
  } catch (error) {
    // What decodes is needed by other images, too.
    if (error instanceof Error && error.name === NOT_LOADED) throw error;
    return null;
  }
}

async function imageOf(ktx2: Blob): Promise<ImageData> {
  const { data, width, height } = await ktx2Pixels(new Uint8Array(await ktx2.arrayBuffer()));
  return new ImageData(new Uint8ClampedArray(data.buffer), width, height);
}

/** In place of the image, which is freed. */
async function resized(
  image: ImageBitmap,
  width: number,
  height: number,
  isPixelated: boolean,
): Promise<ImageBitmap> {
  if (image.width === width && image.height === height) return image;
  const other = await createImageBitmap(image, {
    ...PLAIN,
    resizeWidth: width,
    resizeHeight: height,
    resizeQuality: isPixelated ? 'pixelated' : 'high',
  });
  image.close();
  return other;
}
