// What a material looks like, as far as images can hold it.

import type { ExtensionProperty, Material, Texture, TextureInfo } from '@gltf-transform/core';
import type { BakeWrap } from '../../types/index.js';

/** The maps of materials, named as their images are. */
export const MAPS = ['baseColor', 'metallicRoughness', 'occlusion', 'normal', 'emissive'] as const;
export type MapName = (typeof MAPS)[number];

/** How a material uses a texture. */
export interface TextureUse {
  texture: Texture;
  set: number;
  wrapU: BakeWrap;
  wrapV: BakeWrap;
  offset: [number, number];
  rotation: number;
  scale: [number, number];
}

export interface MaterialLook {
  baseColor: number[];
  /** Above 1 with KHR_materials_emissive_strength. */
  emission: number[];
  metallic: number;
  roughness: number;
  normalScale: number;
  occlusionStrength: number;
  isOpaque: boolean;
  textures: Partial<Record<MapName, TextureUse>>;
}

type Slot = [texture: Texture | null, info: TextureInfo | null];

export const slotsOf = (material: Material): Record<MapName, Slot> => ({
  baseColor: [material.getBaseColorTexture(), material.getBaseColorTextureInfo()],
  metallicRoughness: [
    material.getMetallicRoughnessTexture(),
    material.getMetallicRoughnessTextureInfo(),
  ],
  occlusion: [material.getOcclusionTexture(), material.getOcclusionTextureInfo()],
  normal: [material.getNormalTexture(), material.getNormalTextureInfo()],
  emissive: [material.getEmissiveTexture(), material.getEmissiveTextureInfo()],
});

type EmissiveStrength = ExtensionProperty & { getEmissiveStrength(): number };

/** `null`: a primitive without a material. */
export function lookOf(material: Material | null): MaterialLook {
  if (!material) return PLAIN;
  const textures: MaterialLook['textures'] = {};
  for (const [name, [texture, info]] of Object.entries(slotsOf(material)))
    if (texture && info) textures[name as MapName] = useOf(texture, info);
  const strength = material
    .getExtension<EmissiveStrength>('KHR_materials_emissive_strength')
    ?.getEmissiveStrength();
  return {
    baseColor: material.getBaseColorFactor(),
    emission: material.getEmissiveFactor().map((x) => x * (strength ?? 1)),
    metallic: material.getMetallicFactor(),
    roughness: material.getRoughnessFactor(),
    normalScale: material.getNormalScale(),
    occlusionStrength: material.getOcclusionStrength(),
    isOpaque: material.getAlphaMode() === 'OPAQUE',
    textures,
  };
}

const PLAIN: MaterialLook = {
  baseColor: [1, 1, 1, 1],
  emission: [0, 0, 0],
  metallic: 1,
  roughness: 1,
  normalScale: 1,
  occlusionStrength: 1,
  isOpaque: true,
  textures: {},
};

type Transform = ExtensionProperty & {
  getOffset(): [number, number];
  getRotation(): number;
  getScale(): [number, number];
  getTexCoord(): number | null;
};

function useOf(texture: Texture, info: TextureInfo): TextureUse {
  const transform = info.getExtension<Transform>('KHR_texture_transform');
  return {
    texture,
    set: transform?.getTexCoord() ?? info.getTexCoord(),
    wrapU: wrapOf(info.getWrapS()),
    wrapV: wrapOf(info.getWrapT()),
    offset: transform?.getOffset() ?? [0, 0],
    rotation: transform?.getRotation() ?? 0,
    scale: transform?.getScale() ?? [1, 1],
  };
}

/** By glTF's numbers. */
const [CLAMP, MIRROR] = [33071, 33648];

function wrapOf(mode: number): BakeWrap {
  if (mode === CLAMP) return 'clamp';
  return mode === MIRROR ? 'mirror' : 'repeat';
}
