import { RepeatWrapping, SRGBColorSpace, Texture } from 'three';

/** A picture that fills the unit square of uv, and is repeated around it. */
export function uvPicture(image: ImageBitmap | HTMLCanvasElement): Texture {
  const texture = new Texture(image);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.anisotropy = 8;
  texture.colorSpace = SRGBColorSpace;
  // An ImageBitmap cannot be flipped on its way to the graphics card.
  texture.flipY = false;
  texture.needsUpdate = true;
  return texture;
}

/** The first row of the picture lies at v = 1. */
export const PICTURE_GLSL = /* glsl */ `
  uniform sampler2D picture;
  vec4 pictureColor(vec2 uv) {
    return texture2D(picture, vec2(uv.x, 1.0 - uv.y));
  }
`;
