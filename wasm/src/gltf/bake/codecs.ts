// Image files to pixels and back.

import { AbflatError } from '../../base/errors.js';
import type { BakedImage, BakeImage } from '../../types/index.js';
import { decodeInBrowser } from './decode-in-browser.js';
import { encodePng } from './encode-png.js';
import type { ImageFile } from './image-file.js';
import type { MapName } from './material-look.js';

/** Null for an image that is to be read as by default. */
export type DecodeImage = (file: ImageFile) => BakeImage | null | PromiseLike<BakeImage | null>;
export type EncodeImage = (image: BakedImage, map: MapName) => ImageFile | PromiseLike<ImageFile>;

const canDecode = () =>
  typeof createImageBitmap === 'function' && typeof OffscreenCanvas === 'function';

export const usualDecode = (file: ImageFile): Promise<BakeImage> => {
  if (canDecode()) return decodeInBrowser(file);
  throw new AbflatError(
    'InvalidOption',
    'There is no reader of images here, as in Node: pass bake: { decode }, a function that turns { bytes, mimeType } into ' +
      '{ data, width, height }.',
  );
};

export const usualEncode: EncodeImage = async (image) => ({
  bytes: await encodePng(image),
  mimeType: 'image/png',
});
