import {
  DataArrayTexture,
  DataTexture,
  FloatType,
  LinearFilter,
  LinearMipmapLinearFilter,
  RepeatWrapping,
  type ShaderMaterial,
  SRGBColorSpace,
  Texture,
  Vector3,
  type WebGLRenderer,
} from 'three';
import { type Appearance, CORNERS_PER_ROW, type MaterialLook } from '../model/appearance';
import { define } from './define';
import { cornerTexture, MATERIAL_TEXELS } from './look-shader';

/** Puts how a surface looks on the graphics card of one view. */
export class LookTextures {
  private shown: Appearance | null = null;
  private textures: Texture[] = [];
  private readonly noCorners: Texture;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly material: ShaderMaterial,
  ) {
    this.noCorners = material.uniforms.cornerLooks.value;
    // Unlike other textures, its images are not sent again by the renderer.
    renderer.domElement.addEventListener('webglcontextrestored', () => this.show(this.shown));
  }

  get isEmpty(): boolean {
    return this.shown === null;
  }

  /** In place of the last one, which is freed. A mesh with too many corners for a texture has none. */
  show(wanted: Appearance | null): void {
    for (const texture of this.textures) texture.dispose();
    const rows = (wanted?.corners.length ?? 0) / (4 * CORNERS_PER_ROW);
    const appearance = rows <= this.renderer.capabilities.maxTextureSize ? wanted : null;
    this.shown = appearance;
    define(this.material, 'LOOK', appearance !== null);
    const { cornerLooks, materialLooks, images } = this.material.uniforms;
    const corners = appearance && cornerTexture(appearance.corners);
    const table = appearance && tableOf(appearance.materials);
    const array = appearance && arrayOf(this.renderer, appearance.images);
    this.textures = [corners, table, array].filter((each) => each !== null);
    cornerLooks.value = corners ?? this.noCorners;
    materialLooks.value = table;
    images.value = array;
  }
}

/** `MATERIAL_TEXELS` per material. */
function tableOf(materials: MaterialLook[]): DataTexture {
  const rows = materials.flatMap(({ image, wrap, isPixelated, cutoff, isUnlit }) => [
    ...[image ?? -1, ...wrap, Number(isPixelated)],
    ...[cutoff, Number(isUnlit), 0, 0],
  ]);
  const texture = new DataTexture(Float32Array.from(rows), MATERIAL_TEXELS, materials.length);
  texture.type = FloatType;
  texture.needsUpdate = true;
  return texture;
}

/** The images as layers, so that one draw shows all materials; null if there are none. */
function arrayOf(renderer: WebGLRenderer, images: ImageBitmap[]): DataArrayTexture | null {
  if (images.length === 0) return null;
  const [{ width, height }] = images;
  const array = new DataArrayTexture(null, width, height, images.length);
  array.wrapS = RepeatWrapping;
  array.wrapT = RepeatWrapping;
  array.magFilter = LinearFilter;
  array.minFilter = LinearMipmapLinearFilter;
  array.generateMipmaps = true;
  array.anisotropy = 8;
  array.colorSpace = SRGBColorSpace;
  array.source.dataReady = false; // there are only layers
  array.needsUpdate = true;
  for (const [i, image] of images.entries()) {
    array.mipmapsAutoUpdate = i === images.length - 1;
    renderer.copyTextureToTexture(new Texture(image), array, null, new Vector3(0, 0, i));
  }
  return array;
}
