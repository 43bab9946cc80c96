// The image files of an FBX, as a glTF can hold them.

import type { Document, Texture } from '@gltf-transform/core';
import { EXTTextureWebP } from '@gltf-transform/extensions';
import { fileNamed, nameOf } from './missing-files';

const KINDS: [type: string, start: RegExp][] = [
  ['image/png', /^\x89PNG/],
  ['image/jpeg', /^\xff\xd8\xff/],
  ['image/webp', /^RIFF[\s\S]{4}WEBP/],
];

export class FbxImages {
  readonly missing: string[] = [];
  readonly undecoded: string[] = [];
  private readonly known = new Map<string, Promise<Texture | null>>();

  constructor(
    private readonly document: Document,
    private readonly embedded: Map<string, Blob>,
    private readonly others: File[],
  ) {}

  /** Null if there is no image, or none that a browser decodes. `title`: of one that is embedded. */
  of(path: string, title: string): Promise<Texture | null> {
    const known = this.known.get(path) ?? this.read(path, title);
    this.known.set(path, known);
    return known;
  }

  private async read(path: string, title: string): Promise<Texture | null> {
    const image = this.embedded.get(path) ?? inUri(path) ?? fileNamed(path, this.others);
    const name = /^(blob|data):/.test(path) ? title : nameOf(path);
    if (!image) {
      if (path) this.missing.push(name);
      return null;
    }
    const type = await typeOf(image);
    const usable = type ? image : await asPng(image);
    if (!usable) {
      this.undecoded.push(name);
      return null;
    }
    if (type === 'image/webp') this.document.createExtension(EXTTextureWebP).setRequired(true);
    return this.document
      .createTexture(name.replace(/\.[^.]*$/, ''))
      .setMimeType(type ?? 'image/png')
      .setImage(new Uint8Array(await usable.arrayBuffer()));
  }
}

/** The image of a data URI. Fetching one is not allowed to the page. */
function inUri(path: string): Blob | undefined {
  const [, type, text] = /^data:([^;]*);base64,([\s\S]*)$/.exec(path) ?? [];
  if (text === undefined) return undefined;
  return new Blob([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], { type });
}

/** Endings are not always right. Undefined for what a glTF does not hold. */
async function typeOf(image: Blob): Promise<string | undefined> {
  const start = String.fromCharCode(...new Uint8Array(await image.slice(0, 12).arrayBuffer()));
  return KINDS.find(([, begins]) => begins.test(start))?.[0];
}

/** BMP, GIF and whatever else the browser decodes. */
async function asPng(image: Blob): Promise<Blob | null> {
  const bitmap = await createImageBitmap(image, { premultiplyAlpha: 'none' }).catch(() => null);
  if (!bitmap) return null;
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
  bitmap.close();
  return canvas.convertToBlob({ type: 'image/png' });
}
