// Gives primitives materials with the new images.

import type {
  Document,
  ExtensionProperty,
  Material,
  Primitive,
  Property,
  Texture,
} from '@gltf-transform/core';
import type { NewLook } from './bake-atlas.js';
import { type MapName, slotsOf } from './material-look.js';

export interface BakedTexture {
  texture: Texture;
  /** Maps of the materials that it holds. */
  maps: MapName[];
  /** In texels. */
  width: number;
  height: number;
  /** The longer one of these. */
  side: number;
}

/**
 * Those that do not differ in more than their name become one. What nothing uses any more is left
 * out.
 */
export function putLook(
  document: Document,
  primitives: Primitive[],
  look: NewLook,
  texcoord: number,
): BakedTexture[] {
  const baked = look.images.map(({ maps, size: [width, height], file: { bytes, mimeType } }) => ({
    texture: document.createTexture(maps[0]).setImage(new Uint8Array(bytes)).setMimeType(mimeType),
    maps,
    width,
    height,
    side: Math.max(width, height),
  }));
  const made: Material[] = [];
  const replaced = new Map<Material | null, Material>();
  for (const old of look.materials) {
    const material = (old?.clone() ?? document.createMaterial()) as Material;
    setTextures(material, baked, texcoord);
    if (holds(baked, 'emissive')) setEmission(material, look);
    const known = made.find((other) => isAlike(other, material));
    if (known) material.dispose();
    else made.push(material);
    replaced.set(old, known ?? material);
  }
  const dropped = new Set<Property>(look.materials.filter((material) => material !== null));
  for (const primitive of primitives) {
    primitive.setMaterial(replaced.get(primitive.getMaterial()) as Material);
    if (holds(baked, 'baseColor')) dropAttribute(primitive, 'COLOR_0');
    if (holds(baked, 'normal')) dropAttribute(primitive, 'TANGENT');
  }
  const before = imageTypes(document);
  dropUnused(dropped);
  dropImageFormats(document, before);
  return baked;
}

const IMAGE_FORMATS: Record<string, string> = {
  KHR_texture_basisu: 'image/ktx2',
  EXT_texture_webp: 'image/webp',
  EXT_texture_avif: 'image/avif',
};

const imageTypes = (document: Document) =>
  new Set(
    document
      .getRoot()
      .listTextures()
      .map((texture) => texture.getMimeType()),
  );

/** Of the last image: programs refuse a file that requires a format which they do not know. */
function dropImageFormats(document: Document, before: Set<string>): void {
  const now = imageTypes(document);
  for (const extension of document.getRoot().listExtensionsUsed()) {
    const type = IMAGE_FORMATS[extension.extensionName];
    if (type && before.has(type) && !now.has(type)) extension.dispose();
  }
}

const holds = (baked: BakedTexture[], map: MapName) => baked.some(({ maps }) => maps.includes(map));

const SETTERS = {
  baseColor: 'setBaseColorTexture',
  metallicRoughness: 'setMetallicRoughnessTexture',
  occlusion: 'setOcclusionTexture',
  normal: 'setNormalTexture',
  emissive: 'setEmissiveTexture',
} as const satisfies Record<MapName, keyof Material>;

/** glTF's number for a texture that repeats, which is its default. */
const REPEAT = 10497;

function setTextures(material: Material, baked: BakedTexture[], texcoord: number): void {
  for (const { texture, maps } of baked)
    for (const map of maps) {
      material[SETTERS[map]](texture);
      slotsOf(material)
        [map][1]?.setTexCoord(texcoord)
        .setWrapS(REPEAT)
        .setWrapT(REPEAT)
        .setMinFilter(null)
        .setMagFilter(null)
        .setExtension('KHR_texture_transform', null);
    }
  // What is part of the images.
  if (holds(baked, 'baseColor')) material.setBaseColorFactor([1, 1, 1, 1]);
  if (holds(baked, 'metallicRoughness')) material.setMetallicFactor(1).setRoughnessFactor(1);
  if (holds(baked, 'normal')) material.setNormalScale(1);
  if (holds(baked, 'occlusion')) material.setOcclusionStrength(1);
}

const STRENGTH = 'KHR_materials_emissive_strength';
type Strength = ExtensionProperty & { setEmissiveStrength(strength: number): unknown };

/** A strength above 1 is that of an extension which one of the old materials has. */
function setEmission(material: Material, { materials, emissiveStrength }: NewLook): void {
  material.setEmissiveFactor([1, 1, 1]).setExtension(STRENGTH, null);
  if (emissiveStrength === 1) return;
  const known = materials
    .map((old) => old?.getExtension<Strength>(STRENGTH))
    .find((strength) => strength);
  const own = known?.clone();
  own?.setEmissiveStrength(emissiveStrength);
  material.setExtension(STRENGTH, own ?? null);
}

function isAlike(a: Material, b: Material): boolean {
  const hasCutoff = a.getAlphaMode() === 'MASK';
  return a.equals(b, new Set(['name', ...(hasCutoff ? [] : ['alphaCutoff'])]));
}

/** What the images now hold, or were made for. */
function dropAttribute(primitive: Primitive, name: string): void {
  for (const owner of [primitive, ...primitive.listTargets()]) {
    const attribute = owner.getAttribute(name);
    if (!attribute) continue;
    owner.setAttribute(name, null);
    if (!isUsed(attribute)) attribute.dispose();
  }
}

/** Materials that nothing uses any more, and then what only they used. */
function dropUnused(properties: Iterable<Property>): void {
  for (const property of properties) {
    if (isUsed(property)) continue;
    const children = property.getGraph().listChildren(property);
    property.dispose();
    dropUnused(children);
  }
}

const isUsed = (property: Property) =>
  property.listParents().some(({ propertyType }) => propertyType !== 'Root');
