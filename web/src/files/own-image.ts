import { OWN_IMAGE } from '../words/looks';

export interface OwnImage {
  image: ImageBitmap;
  /** What the user should know of it; '' if nothing. */
  remark: string;
}

/** Formats that every browser decodes. */
const DECODED = /\.(png|jpe?g|webp|gif|bmp)$/i;
/** As the file has it: its colours are not lost where it is transparent. */
const PLAIN: ImageBitmapOptions = { premultiplyAlpha: 'none' };

/** Decodes a file; a larger image than `most` pixels along a side is scaled down. */
export async function ownImage(file: File, most: number): Promise<OwnImage> {
  const image = await decoded(file);
  const { width, height } = image;
  const scale = Math.min(1, most / width, most / height);
  if (scale === 1) return { image, remark: '' };
  const size = (side: number) => Math.max(1, Math.floor(scale * side));
  const smaller = await createImageBitmap(image, {
    ...PLAIN,
    resizeWidth: size(width),
    resizeHeight: size(height),
    resizeQuality: 'high',
  });
  const remark = OWN_IMAGE.scaledDown(file.name, [width, height], [smaller.width, smaller.height]);
  image.close();
  return { image: smaller, remark };
}

async function decoded(file: File): Promise<ImageBitmap> {
  try {
    return await createImageBitmap(file, PLAIN);
  } catch {
    const { name } = file;
    throw new Error(DECODED.test(name) ? OWN_IMAGE.damaged(name) : OWN_IMAGE.unknown(name));
  }
}
