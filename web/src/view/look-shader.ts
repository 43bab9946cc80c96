import { DataTexture, RGBAIntegerFormat, UnsignedIntType } from 'three';
import { CORNERS_PER_ROW, type CornerLooks } from '../model/appearance';

/** Texels per material. */
export const MATERIAL_TEXELS = 2;

export function cornerTexture(corners: CornerLooks): DataTexture {
  const height = corners.length / (4 * CORNERS_PER_ROW);
  const width = height < 1 ? corners.length / 4 : CORNERS_PER_ROW;
  const texture = new DataTexture(corners, width, Math.max(1, height));
  texture.format = RGBAIntegerFormat;
  texture.type = UnsignedIntType;
  texture.internalFormat = 'RGBA32UI';
  texture.needsUpdate = true;
  return texture;
}

/** What LOOK_VERTEX_GLSL and LOOK_GLSL read. */
export const lookUniforms = () => ({
  // A sampler of whole numbers cannot do without a texture of them.
  cornerLooks: { value: cornerTexture(new Uint32Array(4)) },
  materialLooks: { value: null },
  images: { value: null },
});

/**
 * With LOOK, `readLook` reads how the corner looks in the file: its place in the image, tint and
 * material. Not needed unless `isShown`. `source` is 0 where the triangles are those of the mesh that
 * was opened.
 */
export const LOOK_VERTEX_GLSL = /* glsl */ `
#ifdef LOOK
  uniform highp usampler2D cornerLooks;
  attribute float source;
  varying vec2 vTexel;
  varying vec4 vTint;
  flat varying int vMaterial;
  vec3 linearOf(vec3 c) {
    return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, lessThanEqual(c, vec3(0.04045)));
  }
  void readLook(bool isShown) {
    vTexel = vec2(0.0);
    vTint = vec4(1.0);
    vMaterial = 0;
    if (!isShown) return;
    int corner = source > 0.5 ? int(source + 0.5) - 1 : gl_VertexID;
    ivec2 at = ivec2(corner % ${CORNERS_PER_ROW}, corner / ${CORNERS_PER_ROW});
    uvec4 look = uvec4(0);
    if (all(lessThan(at, textureSize(cornerLooks, 0)))) look = texelFetch(cornerLooks, at, 0);
    vTexel = uintBitsToFloat(look.xy);
    vMaterial = int(look.z);
    uvec4 tint = (uvec4(look.w) >> uvec4(0, 8, 16, 24)) & 255u;
    vTint = vec4(linearOf(vec3(tint.rgb) / 255.0), float(tint.a) / 255.0);
  }
#endif
`;

/**
 * With LOOK, `lookColor` is the colour in the file, linear, and what is seen of it: all, nothing, or
 * with BLENDED a part. `isUnlit` tells whether light makes no difference.
 */
export const LOOK_GLSL = /* glsl */ `
#ifdef LOOK
  uniform sampler2D materialLooks;
  uniform highp sampler2DArray images;
  varying vec2 vTexel;
  varying vec4 vTint;
  flat varying int vMaterial;
  float wrapped(float x, float wrap, float texels) {
    if (wrap < 0.5) return x;
    float inside = wrap < 1.5 ? 1.0 - abs(mod(x, 2.0) - 1.0) : x;
    return clamp(inside, 0.5 / texels, 1.0 - 0.5 / texels);
  }
  vec4 imageColor(vec4 image, vec2 dx, vec2 dy) {
    vec2 size = vec2(textureSize(images, 0).xy);
    vec2 at = vec2(wrapped(vTexel.x, image.y, size.x), wrapped(vTexel.y, image.z, size.y));
    if (image.w > 0.5) at = (floor(at * size) + 0.5) / size;
    return textureGrad(images, vec3(at, image.x), dx, dy);
  }
  vec4 lookColor(vec2 dx, vec2 dy, out bool isUnlit) {
    vec4 image = texelFetch(materialLooks, ivec2(0, vMaterial), 0);
    vec4 rest = texelFetch(materialLooks, ivec2(1, vMaterial), 0);
    isUnlit = rest.y > 0.5;
    vec4 color = vTint;
    if (image.x >= 0.0) color *= imageColor(image, dx, dy);
    if (rest.x < 0.001) color.a = 1.0;
    else if (rest.x <= 1.0) color.a = step(rest.x, color.a);
    return color;
  }
  // Without sorting triangles: of a translucent surface, so many pixels are drawn.
  bool isLeftOut(float alpha) {
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return alpha <= noise * 0.998;
  }
#endif
`;
