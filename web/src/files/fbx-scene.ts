// An FBX as three.js reads it, without its images.

import { type Group, Loader, LoadingManager, Texture } from 'three';
import { FBXLoader } from 'three/addons/loaders/FBXLoader.js';
import { FBX } from '../words/fbx';
import { nameOf } from './missing-files';

/** Where a texture has its image: a key of `embedded`, a data URI, or the path of a file. */
export const pathOf = (texture: Texture): string => texture.userData.path ?? '';

export interface FbxScene {
  scene: Group;
  textures: Texture[];
  embedded: Map<string, Blob>;
}

/** Textures that know where their images are, and load nothing. */
class NamedTextures extends Loader<Texture> {
  readonly made: Texture[] = [];

  override load(path: string): Texture {
    const texture = new Texture();
    texture.userData.path = path;
    this.made.push(texture);
    return texture;
  }
}

export function fbxScene(
  name: string,
  bytes: Uint8Array<ArrayBuffer>,
  isBinary: boolean,
): FbxScene {
  const manager = new LoadingManager();
  const textures = new NamedTextures(manager);
  manager.addHandler(/./, textures);
  const embedded = new Map<string, Blob>();
  try {
    const read = isBinary ? bytes.buffer : withoutBlanks(bytes);
    const scene = withSurroundings(embedded, () => new FBXLoader(manager).parse(read, ''));
    return { scene, textures: textures.made, embedded };
  } catch (error) {
    // Whatever it stumbles upon, it is in the file.
    const reason = (error instanceof Error ? error.message : String(error))
      .replace(/^THREE\.FBXLoader: */, '')
      .replace(/\.$/, '');
    throw new Error(FBX.damaged(nameOf(name), reason));
  }
}

const PROPERTY = /^\s*P:.*$/gm;
const BLANKS = /, +(?=[-+.\d])/g;

/** Some programs write blanks between the numbers of a property, which three.js does not expect. */
function withoutBlanks(bytes: Uint8Array): ArrayBuffer {
  const text = new TextDecoder().decode(bytes);
  return new TextEncoder().encode(text.replace(PROPERTY, (line) => line.replace(BLANKS, ',')))
    .buffer as ArrayBuffer;
}

/**
 * Embedded images get an address from the browser, which the page must not load from, and cameras ask a
 * window for its size, which a worker does not have.
 */
function withSurroundings<T>(embedded: Map<string, Blob>, work: () => T): T {
  const { createObjectURL } = URL;
  const hadWindow = 'window' in globalThis;
  if (!hadWindow) Object.assign(globalThis, { window: {} });
  URL.createObjectURL = (image) => {
    const path = `blob:${embedded.size}`;
    embedded.set(path, image as Blob);
    return path;
  };
  try {
    return work();
  } finally {
    URL.createObjectURL = createObjectURL;
    if (!hadWindow) Reflect.deleteProperty(globalThis, 'window');
  }
}
