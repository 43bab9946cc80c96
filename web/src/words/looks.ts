// Files that say how a mesh looks.

import { count, listed } from './format';

/** Files that a mesh names. */
export const LOOK_FILES = {
  missing: (mesh: string, files: string[]) => {
    const what = files.some((file) => /\.mtl$/i.test(file)) ? 'Materials' : 'Textures';
    const them = files.length > 1 ? 'them' : 'it';
    return `${what} not shown: ${listed(files)} not found. UVs are unaffected. Drop ${them} together with ${mesh} to see ${them}.`;
  },
  undecoded: (files: string[]) =>
    `This browser cannot decode ${listed(files)}: save ${files.length > 1 ? 'them' : 'it'} as PNG or JPEG.`,
  /** One without a name. */
  image: (number: number) => `image ${number}`,
};

/** An image of the user's own. Sizes are width and height in pixels. */
export const OWN_IMAGE = {
  pressEnter: 'Press Enter to choose an image',
  shown: (name: string) => `Showing ${name}`,
  oneOfMany: (name: string, images: number) => `You chose ${images} images. ${name} is shown.`,
  scaledDown: (name: string, [width, height]: number[], [most, high]: number[]) =>
    `${name} is ${count(width)} × ${count(height)} pixels, more than your graphics card supports. It is shown at ${count(most)} × ${count(high)}.`,
  damaged: (name: string) =>
    `${name} is damaged or too large to show. Save it again as PNG, JPEG or WebP.`,
  unknown: (name: string) => `This browser cannot decode ${name}. Save it as PNG, JPEG or WebP.`,
};
