// Images of which each channel comes from another one, and what channels are.

import { BAKED_OBJ } from '../words/baked-obj';

const PLAIN: ImageBitmapOptions = { premultiplyAlpha: 'none', colorSpaceConversion: 'none' };
const SAMPLES = 64;

interface Pixels {
  data: Uint8ClampedArray;
  width: number;
  height: number;
}

async function pixelsOf(image: Blob, width = 0, height = 0): Promise<Pixels> {
  const bitmap = await createImageBitmap(image, PLAIN);
  const size = [width || bitmap.width, height || bitmap.height] as const;
  const context = new OffscreenCanvas(...size).getContext('2d');
  context?.drawImage(bitmap, 0, 0, ...size);
  bitmap.close();
  if (!context) throw new Error(BAKED_OBJ.noPixels);
  return context.getImageData(0, 0, ...size);
}

/**
 * A PNG with the channels of others. Colours come from the first; `channel` of it is the alpha of
 * `from`, if it has any, or else its red.
 */
export async function withChannel(
  image: Blob | null,
  from: Blob,
  channel: 1 | 2 | 3,
): Promise<Blob> {
  const source = await pixelsOf(from);
  const base = image ? await pixelsOf(image) : null;
  const [width, height] = base ? [base.width, base.height] : [source.width, source.height];
  const scaled = base ? await pixelsOf(from, width, height) : source;
  const data = base?.data ?? new Uint8ClampedArray(4 * width * height).fill(255);
  const at = channel === 3 && hasAlpha(scaled.data) ? 3 : 0;
  for (let i = 0; i < data.length; i += 4) data[i + channel] = scaled.data[i + at] as number;
  const canvas = new OffscreenCanvas(width, height);
  const pixels = new ImageData(new Uint8ClampedArray(data), width, height);
  canvas.getContext('2d')?.putImageData(pixels, 0, 0);
  return canvas.convertToBlob({ type: 'image/png' });
}

/** A PNG in grey, as a channel of another image. */
export async function greyOf(image: Blob, channel: 1 | 2): Promise<Blob> {
  const { data, width, height } = await pixelsOf(image);
  const out = new ImageData(width, height);
  for (let i = 0; i < data.length; i += 4)
    out.data.fill(data[i + channel] as number, i, i + 3).fill(255, i + 3, i + 4);
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext('2d')?.putImageData(out, 0, 0);
  return canvas.convertToBlob({ type: 'image/png' });
}

const hasAlpha = (data: Uint8ClampedArray) => data.some((value, i) => i % 4 === 3 && value < 255);

/** Whether the alpha of an image says anything. */
export async function isTransparent(image: Blob): Promise<boolean> {
  return hasAlpha((await pixelsOf(image)).data);
}

/** Colours of a normal map are vectors of about length 1 that mostly point outwards. */
export async function looksLikeNormals(image: Blob): Promise<boolean> {
  const { data } = await pixelsOf(image, SAMPLES, SAMPLES);
  let [vectors, outwards] = [0, 0];
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = [0, 1, 2].map((d) => (data[i + d] as number) / 255);
    const length = Math.hypot(2 * r - 1, 2 * g - 1, 2 * b - 1);
    if (length > 0.75 && length < 1.25) ++vectors;
    outwards += b;
  }
  const count = SAMPLES * SAMPLES;
  return vectors >= 0.9 * count && outwards >= 0.75 * count;
}
