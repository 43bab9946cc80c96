// The images of a document, in the forms that materials need.

import type { Texture } from '@gltf-transform/core';
import { AbflatError, messageOf } from '../../base/errors.js';
import type { BakeImage } from '../../types/index.js';
import { type DecodeImage, usualDecode } from './codecs.js';
import type { ImageFile } from './image-file.js';

export class OldImages {
  readonly #decode: DecodeImage | undefined;
  readonly #whole = new Map<Texture, Promise<BakeImage>>();
  readonly #faded = new Map<Texture, Map<number, BakeImage>>();
  readonly #deep = new Set<Texture>();

  constructor(decode: DecodeImage | undefined) {
    this.#decode = decode;
  }

  /** How many have 16 bits per channel. */
  get deepCount(): number {
    return this.#deep.size;
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
    if (isDeepPng(bytes)) this.#deep.add(texture);
    try {
      return await this.#decoded(name, { bytes, mimeType: texture.getMimeType() });
    } catch (error) {
      if (error instanceof AbflatError) throw error;
      const reason = messageOf(error).replace(/\.$/, '');
      throw new AbflatError('UnreadableFile', `${name} cannot be decoded: ${reason}.`);
    }
  }

  async #decoded(name: string, file: ImageFile): Promise<BakeImage> {
    const own = await this.#decode?.(file);
    if (own) return own;
    if (isKtx2(file.bytes))
      throw new AbflatError(
        'UnreadableFile',
        `${name} is a KTX2 texture. Convert it to PNG, such as with 'ktx extract', or pass bake: { decode }.`,
      );
    return usualDecode(file);
  }
}

const isKtx2 = (bytes: Uint8Array) =>
  [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30].every((byte, i) => bytes[i] === byte);

/** The header of a PNG comes first, and has the bits of a channel behind its size. */
const isDeepPng = (bytes: Uint8Array) =>
  [0x89, 0x50, 0x4e, 0x47].every((byte, i) => bytes[i] === byte) && bytes[24] === 16;

function fade({ data, width, height }: BakeImage, strength: number): BakeImage {
  const out = new Uint8Array(data.length);
  for (let i = 0; i < data.length; i += 4) {
    const value = Math.round(255 - strength * (255 - (data[i] as number)));
    out.set([value, value, value, 255], i);
  }
  return { data: out, width, height };
}
