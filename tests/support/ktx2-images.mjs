// KTX2 images of 16 by 16 texels, as an encoder of Basis Universal has made them: in quarters red, green, blue, and white of which
// half is seen.

import { KHRTextureBasisu } from '@gltf-transform/extensions';
import { io } from './gltf.mjs';
import { oneColor, RED } from './painted.mjs';
import { oneTexture, texturedCube, texturedGlb } from './textured.mjs';

export const KTX2_IMAGES = {
  UASTC: Buffer.from(
    'q0tUWCAyMLsNChoKAAAAAAEAAAAQAAAAEAAAAAAAAAAAAAAAAQAAAAEAAAAAAAAAaAAAACwAAACUAAAALAAAAAAAAAAAAAAAAAAAAAAAAADAAAAAAAAAAAABAAAAAAAAAAEAAAAAAAAsAAAAAAAAAAIAKACmAQIAAwMAABAAAAAAAAAAAAB/AwAAAAAAAAAA/////x8AAABLVFh3cml0ZXIAQmFzaXMgVW5pdmVyc2FsIDIuNTAAAAQAAAB/fwAAl9vD4z/ahAAAAAAAAAAAAJfbw+M/2oQAAAAAAAAAAADXAxnlfzD6AAAAAAAAAAAA1wMZ5X8w+gAAAAAAAAAAAJfbw+M/2oQAAAAAAAAAAACX28PjP9qEAAAAAAAAAAAA1wMZ5X8w+gAAAAAAAAAAANcDGeV/MPoAAAAAAAAAAAAXhUf6Xw1iAQAAAAAAAAAAF4VH+l8NYgEAAAAAAAAAAFdfXx9Qeu8BAAAAAAAAAABXX18fUHrvAQAAAAAAAAAAF4VH+l8NYgEAAAAAAAAAABeFR/pfDWIBAAAAAAAAAABXX18fUHrvAQAAAAAAAAAAV19fH1B67wEAAAAAAAAAAA==',
    'base64',
  ),
  ETC1S: Buffer.from(
    'q0tUWCAyMLsNChoKAAAAAAEAAAAQAAAAEAAAAAAAAAAAAAAAAQAAAAEAAAABAAAAaAAAADwAAACkAAAAJAAAAMgAAAAAAAAAlwAAAAAAAABfAQAAAAAAAAoAAAAAAAAAAAAAAAAAAAA8AAAAAAAAAAIAOACjAQIAAwMAAAgIAAAAAAAAAAA/AAAAAAAAAAAA/////0AAPw8AAAAAAAAAAP////8fAAAAS1RYd3JpdGVyAEJhc2lzIFVuaXZlcnNhbCAyLjUwAAAGAAIANAAAAAkAAAAyAAAAAAAAAAAAAAAAAAAABQAAAAUAAAAFAAAAG0DEgAAAAGCQfthIFcCUAAAAAAAAMkAVAUQBEAAAAAS5go6IAEwBAAAAAIBAWmQ/4+QGVKyqqqpSVVVVBRTAhAABAAAAENSFsACYACAAAAAAgVyGgLgBAwAAgrBYjQMjJ3AKB8AMAAAAAAAAUgABKpgAFgCeZP1tDw==',
    'base64',
  ),
};

/** From the upper left, by rows. */
export const QUARTERS = [
  [220, 30, 30, 255],
  [30, 200, 40, 255],
  [40, 60, 210, 255],
  [250, 250, 250, 128],
];

/** A cube with such an image, as a GLB. */
export async function ktx2Cube(image, alphaMode = 'BLEND') {
  const glb = texturedGlb([texturedCube()], oneTexture(oneColor(RED), { alphaMode }));
  const document = await io.readBinary(glb);
  document.createExtension(KHRTextureBasisu).setRequired(true);
  document.getRoot().listTextures()[0].setImage(image).setMimeType('image/ktx2');
  return io.writeBinary(document);
}
