// Image files to pixels and back.

import { AbflatError } from '../../base/errors.js';
import type { BakedImage, BakeImage } from '../../types/index.js';
import { decodeInBrowser } from './decode-in-browser.js';
import { encodePng } from './encode-png.js';
import type { ImageFile } from './image-file.js';
import type { MapName } from './material-look.js';

export type DecodeImage = (file: ImageFile) => BakeImage | PromiseLike<BakeImage>;
export type EncodeImage = (image: BakedImage, map: MapName) => ImageFile | PromiseLike<ImageFile>;

const canDecode = () =>
  typeof createImageBitmap === 'function' && typeof OffscreenCanvas === 'function';

export const usualDecode: DecodeImage = (file) => {
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
