// The images of a document, in the forms that materials need.

import type { Texture } from '@gltf-transform/core';
import { AbflatError, messageOf } from '../../base/errors.js';
import type { BakeImage } from '../../types/index.js';
import type { DecodeImage } from './codecs.js';

export class OldImages {
  readonly #decode: DecodeImage;
  readonly #whole = new Map<Texture, Promise<BakeImage>>();
  readonly #faded = new Map<Texture, Map<number, BakeImage>>();

  constructor(decode: DecodeImage) {
    this.#decode = decode;
  }

  /** How many images were used. */
  get count(): number {
    return this.#whole.size;
  }

  whole(texture: Texture): Promise<BakeImage> {
    const known = this.#whole.get(texture) ?? this.#read(texture);
    this.#whole.set(texture, known);
    return known;
  }

  /** Red alone, as 1 - strength * (1 - red): ambient occlusion of some strength. */
  async occlusion(texture: Texture, strength: number): Promise<BakeImage> {
    const faded = this.#faded.get(texture) ?? new Map<number, BakeImage>();
    this.#faded.set(texture, faded);
    const made = faded.get(strength) ?? fade(await this.whole(texture), strength);
    faded.set(strength, made);
    return made;
  }

  async #read(texture: Texture): Promise<BakeImage> {
    const label = texture.getName() || texture.getURI();
    const name = label ? `The image ${JSON.stringify(label)}` : 'An image of the document';
    const bytes = texture.getImage();
    if (!bytes) throw new AbflatError('UnreadableFile', `${name} has no data.`);
    try {
      return await this.#decode({ bytes, mimeType: texture.getMimeType() });
    } catch (error) {
      if (error instanceof AbflatError) throw error;
      const reason = messageOf(error).replace(/\.$/, '');
      throw new AbflatError('UnreadableFile', `${name} cannot be decoded: ${reason}.`);
    }
  }
}

function fade({ data, width, height }: BakeImage, strength: number): BakeImage {
  const out = new Uint8Array(data.length);
  for (let i = 0; i < data.length; i += 4) {
    const value = Math.round(255 - strength * (255 - (data[i] as number)));
    out.set([value, value, value, 255], i);
  }
  return { data: out, width, height };
}
