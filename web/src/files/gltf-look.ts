import type {
  Accessor,
  ExtensionProperty,
  Material,
  Primitive,
  Texture,
  TextureInfo,
} from '@gltf-transform/core';
import { type DocumentPart, documentMesh } from 'abflat/gltf';
import { byteOf, srgbByte } from '../colors/srgb';
import { BLENDED, type MaterialLook, OPAQUE, Wrap } from '../model/appearance';
import type { GltfFiles } from '../model/model';
import { LOOK_FILES } from '../words/looks';
import { CornerWriter, type Tint, tintOf, WHITE } from './corner-looks';
import { gltfIo, openGltf } from './gltf-source';
import { nameOf } from './missing-files';
import type { StoredImage, StoredLook } from './stored-look';

/** What gives a surface its colour. */
interface BaseColor {
  texture: Texture | null;
  info: TextureInfo | null;
  factor: number[];
}

type Transform = ExtensionProperty & {
  getOffset(): number[];
  getRotation(): number;
  getScale(): number[];
  getTexCoord(): number | null;
};
type Glossiness = ExtensionProperty & {
  getDiffuseTexture(): Texture | null;
  getDiffuseTextureInfo(): TextureInfo | null;
  getDiffuseFactor(): number[];
};

/** Of a document that has been opened before, so it is sound. */
export async function readGltfLook({ file, others }: GltfFiles): Promise<StoredLook> {
  const { source } = await openGltf(file, others);
  const document = await gltfIo().readJSON(source);
  const { indices, parts } = documentMesh(document);
  const corners = new CornerWriter(indices.length);
  const images = new Images();
  const known = new Map<Material | null, number>();
  const materials: MaterialLook[] = [];
  for (const part of parts) {
    const material = part.primitive.getMaterial();
    const base = baseColorOf(material);
    const number = known.get(material) ?? materials.length;
    known.set(material, number);
    if (number === materials.length) materials.push(lookOf(material, base, images));
    writePart(part, base, number, indices, corners);
  }
  return { corners, materials, images: images.found, missing: [] };
}

/** Materials with a specular colour have a diffuse one, which is as good for showing them. */
function baseColorOf(material: Material | null): BaseColor {
  const older = material?.getExtension<Glossiness>('KHR_materials_pbrSpecularGlossiness');
  if (older)
    return {
      texture: older.getDiffuseTexture(),
      info: older.getDiffuseTextureInfo(),
      factor: older.getDiffuseFactor(),
    };
  return {
    texture: material?.getBaseColorTexture() ?? null,
    info: material?.getBaseColorTextureInfo() ?? null,
    factor: material?.getBaseColorFactor() ?? [1, 1, 1, 1],
  };
}

const WRAPS: Record<number, Wrap> = { 33071: Wrap.Clamp, 33648: Wrap.Mirror };
const NEAREST = 9728;

function lookOf(
  material: Material | null,
  { texture, info }: BaseColor,
  images: Images,
): MaterialLook {
  const isPixelated = info?.getMagFilter() === NEAREST;
  const wrap = (mode: number | undefined) => WRAPS[mode ?? 0] ?? Wrap.Repeat;
  return {
    image: texture && images.numberOf(texture, isPixelated),
    wrap: [wrap(info?.getWrapS()), wrap(info?.getWrapT())],
    isPixelated,
    cutoff: cutoffOf(material),
    isUnlit: Boolean(material?.getExtension('KHR_materials_unlit')),
  };
}

function cutoffOf(material: Material | null): number {
  const mode = material?.getAlphaMode();
  if (mode === 'BLEND') return BLENDED;
  // A cutoff of 0 hides nothing.
  return mode === 'MASK' ? Math.min(1, material?.getAlphaCutoff() ?? 0.5) : OPAQUE;
}

/** The images of a document, each once. */
class Images {
  readonly found: StoredImage[] = [];
  private readonly numbers = new Map<Texture, number>();

  /** Null for a texture without an image. */
  numberOf(texture: Texture, isPixelated: boolean): number | null {
    const known = this.numbers.get(texture);
    if (known !== undefined) return known;
    const bytes = texture.getImage();
    if (!bytes) return null;
    this.numbers.set(texture, this.found.length);
    const type = texture.getMimeType();
    this.found.push({
      name: nameOf(texture.getURI()) || texture.getName() || LOOK_FILES.image(this.found.length),
      bytes: new Blob([bytes as Uint8Array<ArrayBuffer>], { type }),
      isPixelated,
    });
    return this.found.length - 1;
  }
}

function writePart(
  { primitive, firstVertex, firstTriangle, triangleCount }: DocumentPart,
  base: BaseColor,
  material: number,
  indices: Uint32Array,
  corners: CornerWriter,
): void {
  const uv = texcoordsOf(primitive, base);
  const tints = tintsOf(primitive, base.factor);
  for (let c = 3 * firstTriangle; c < 3 * (firstTriangle + triangleCount); ++c) {
    const row = indices[c] - firstVertex;
    const [u, v] = uv ? [uv[2 * row], uv[2 * row + 1]] : [0, 0];
    corners.set(c, { u, v, material, tint: tints(row) });
  }
}

/** Where the vertices lie in the image; null if they have no place there. */
function texcoordsOf(primitive: Primitive, { texture, info }: BaseColor): Float64Array | null {
  if (!texture || !info) return null;
  const transform = info.getExtension<Transform>('KHR_texture_transform');
  const set = transform?.getTexCoord() ?? info.getTexCoord();
  const attribute = primitive.getAttribute(`TEXCOORD_${set}`);
  if (!attribute) return null;
  const place = placeOf(transform);
  const uv = new Float64Array(2 * attribute.getCount());
  const at = [0, 0];
  for (let row = 0; row < attribute.getCount(); ++row) {
    attribute.getElement(row, at);
    uv.set(place(at[0], at[1]), 2 * row);
  }
  return uv;
}

/** Scales, then turns, then moves. */
function placeOf(transform: Transform | null): (u: number, v: number) => [number, number] {
  if (!transform) return (u, v) => [u, v];
  const [x, y] = transform.getOffset();
  const [width, height] = transform.getScale();
  const [sin, cos] = [Math.sin(transform.getRotation()), Math.cos(transform.getRotation())];
  return (u, v) => [cos * width * u + sin * height * v + x, cos * height * v - sin * width * u + y];
}

/** The tint of each vertex: its own colour times the material's; both are linear. */
function tintsOf(primitive: Primitive, factor: number[]): (row: number) => Tint {
  const colors = primitive.getAttribute('COLOR_0');
  const tintFrom = ([red, green, blue, alpha = 1]: number[]) =>
    tintOf(srgbByte(red), srgbByte(green), srgbByte(blue), byteOf(alpha));
  if (!colors) {
    const tint = factor.every((each) => each === 1) ? WHITE : tintFrom(factor);
    return () => tint;
  }
  const tints = new Uint32Array(colors.getCount());
  for (let row = 0; row < tints.length; ++row) tints[row] = tintFrom(times(colors, row, factor));
  return (row) => tints[row];
}

function times(colors: Accessor, row: number, factor: number[]): number[] {
  const color = [1, 1, 1, 1];
  colors.getElement(row, color);
  return factor.map((each, d) => each * color[d]);
}
