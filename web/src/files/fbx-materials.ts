// Materials of an FBX as those of a glTF.

import type { Document, Material } from '@gltf-transform/core';
import {
  ClampToEdgeWrapping,
  Loader,
  type MeshPhongMaterial,
  type Material as OldMaterial,
  type Texture,
} from 'three';
import type { FbxImages } from './fbx-images';
import { pathOf } from './fbx-scene';
import { looksLikeNormals } from './image-channels';
import type { MapPlacement } from './mtl';
import { putTexture, type Slot } from './obj-document';

export class FbxMaterials {
  private readonly made = new Map<OldMaterial, Promise<Material | null>>();
  private readonly used = new Set<Texture>();

  constructor(
    private readonly document: Document,
    private readonly images: FbxImages,
  ) {}

  /** Null for what has no material in the file. */
  of(old: OldMaterial): Promise<Material | null> {
    const made = this.made.get(old) ?? this.make(old as MeshPhongMaterial);
    this.made.set(old, made);
    return made;
  }

  /** Whether some of the textures have no place in a glTF. */
  leavesOut(textures: Texture[]): boolean {
    return textures.some((texture) => !this.used.has(texture));
  }

  private async make(old: MeshPhongMaterial): Promise<Material | null> {
    if (old.name === Loader.DEFAULT_MATERIAL_NAME) return null;
    const { map, emissiveMap, normalMap, bumpMap, aoMap, alphaMap, opacity, emissiveIntensity } =
      old;
    const material = this.document
      .createMaterial(old.name)
      .setMetallicFactor(0)
      .setRoughnessFactor(roughnessOf(old));
    // An image stands in for the colour.
    const isPainted = await this.put(material, 'baseColor', map);
    const color = isPainted ? [1, 1, 1] : (old.color?.toArray() ?? [1, 1, 1]);
    material.setBaseColorFactor([...color, opacity] as [number, number, number, number]);
    const isCut = Boolean(isPainted && map && alphaMap && pathOf(map) === pathOf(alphaMap));
    if (isCut) this.used.add(alphaMap as Texture);
    if (isCut || opacity < 1) material.setAlphaMode('BLEND');
    const glows = await this.put(material, 'emissive', emissiveMap);
    const glow = glows ? [1, 1, 1] : (old.emissive?.toArray() ?? [0, 0, 0]);
    const factor = glow.map((x) => Math.min(1, Math.max(0, x * emissiveIntensity)));
    material.setEmissiveFactor(factor as [number, number, number]);
    if (!(await this.put(material, 'normal', normalMap)))
      await this.put(material, 'normal', bumpMap, looksLikeNormals);
    await this.put(material, 'occlusion', aoMap);
    return material;
  }

  /** Returns whether there is an image, and it is a fitting one. */
  private async put(
    material: Material,
    slot: Slot,
    old: Texture | null | undefined,
    fits: (image: Blob) => Promise<boolean> = async () => true,
  ): Promise<boolean> {
    if (!old) return false;
    const texture = await this.images.of(pathOf(old), old.name);
    const bytes = texture?.getImage();
    if (bytes && !(await fits(new Blob([bytes as Uint8Array<ArrayBuffer>])))) return false;
    // What is missing is said elsewhere.
    this.used.add(old);
    if (texture) putTexture(this.document, material, slot, texture, placeOf(old));
    return texture !== null;
  }
}

const placeOf = ({ repeat, offset, wrapS }: Texture): MapPlacement => ({
  scale: [repeat.x, repeat.y],
  offset: [offset.x, offset.y],
  isClamped: wrapS === ClampToEdgeWrapping,
});

/** As Blender, the most common writer of FBX without roughness, has it. */
const roughnessOf = ({ shininess = 0 }: MeshPhongMaterial) =>
  Math.min(1, Math.max(0, 1 - Math.sqrt(shininess) / 10));
