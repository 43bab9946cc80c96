// A baked OBJ as a GLB, whose materials have one image for each of glTF's maps.

import type { Material, vec3, vec4 } from '@gltf-transform/core';
import { linearOf } from '../colors/srgb';
import { BAKED_OBJ } from '../words/baked-obj';
import type { BakedGltf } from './baked-gltf';
import { glbOf } from './gltf-source';
import { withChannel } from './image-channels';
import { readMtl } from './mtl';
import type { MtlLine, MtlMap } from './mtl-maps';
import { type Bake, bake, bytesOf, type Tell, textureOf } from './obj-baking';
import { documentOf, putTexture, type Slot } from './obj-document';
import type { ObjImages, ObjToBake, Use } from './obj-images';

const GLTF_MAPS = ['diffuse', 'opacity', 'roughness', 'metallic', 'emissive', 'normal'];

interface GltfMaterial {
  slots: { slot: Slot; image: Blob; map: MtlMap }[];
  hasOpacity: boolean;
}

export async function bakedGlb(
  abflat: Bake,
  { name, settings }: ObjToBake,
  look: ObjImages,
  tell: Tell,
): Promise<BakedGltf> {
  const materials = await Promise.all(look.names.map((_, number) => gltfMaterial(look, number)));
  const bytes = await bytesOf(materials.flatMap(({ slots }) => slots.map(({ image }) => image)));
  const document = documentOf(name, look.shape, (document, number) => {
    const lines = look.materials.get(look.names[number] ?? '') ?? [];
    const { slots, hasOpacity } = materials[number] as GltfMaterial;
    const material = document.createMaterial(look.names[number]);
    setNumbers(material, lines, slots);
    if (hasOpacity || material.getAlpha() < 1) material.setAlphaMode('BLEND');
    for (const { slot, image, map } of slots)
      putTexture(document, material, slot, textureOf(document, image, bytes), map);
    return material;
  });
  const { images, notes } = await bake(abflat, document, look.shape, settings, tell);
  const file = new Blob([await glbOf(document)], { type: 'model/gltf-binary' });
  const rest = look.names.flatMap((_, number) => look.mapsOf(number)).map((map) => map.name);
  const lost = [...new Set(rest)].filter((each) => each && !GLTF_MAPS.includes(each));
  const heights = lost.filter((each) => each !== 'bump' || materials.every(hasNoNormals));
  const remarks = heights.length > 0 ? [BAKED_OBJ.noPlace(heights as string[])] : [];
  return { file, images, notes: [...look.notes, ...remarks, ...notes] };
}

const hasNoNormals = ({ slots }: GltfMaterial) => slots.every(({ slot }) => slot !== 'normal');

/** An image for each of glTF's maps: those of an OBJ may be several. */
async function gltfMaterial(look: ObjImages, number: number): Promise<GltfMaterial> {
  const [diffuse, opacity, roughness, metallic, emissive, normal] = await Promise.all(
    GLTF_MAPS.map((name) => look.useOf(number, name)),
  );
  const slots: GltfMaterial['slots'] = [];
  const add = (slot: Slot, use: Use | undefined, image?: Blob) => {
    if (use) slots.push({ slot, image: image ?? use.image, map: use.map });
  };
  const isOwn = opacity && opacity.image !== diffuse?.image;
  add(
    'baseColor',
    diffuse ?? opacity,
    isOwn ? await withChannel(diffuse?.image ?? null, opacity.image, 3) : undefined,
  );
  const green = roughness && (await withChannel(null, roughness.image, 1));
  const blue = metallic && (await withChannel(green ?? null, metallic.image, 2));
  add('metallicRoughness', roughness ?? metallic, blue ?? green);
  add('emissive', emissive);
  add('normal', normal);
  return { slots, hasOpacity: opacity !== undefined };
}

/** The numbers of a material, which images replace. */
function setNumbers(material: Material, lines: MtlLine[], slots: GltfMaterial['slots']): void {
  const text = lines.map((line) => line.text).join('\n');
  const [{ diffuse, opacity } = PLAIN] = readMtl(text).values();
  const numbersOf = (keyword: string): number[] => {
    const line = new RegExp(`^\\s*${keyword}\\s+(.*)$`, 'im').exec(text);
    return line?.[1].trim().split(/\s+/).map(Number) ?? [];
  };
  const has = (slot: Slot) => slots.find((each) => each.slot === slot);
  const [roughness = 1] = numbersOf('Pr');
  const [metallic = 0] = numbersOf('Pm');
  const [red = 0, green = red, blue = red] = numbersOf('Ke');
  const colour = has('baseColor') ? [1, 1, 1] : diffuse.map(linearOf);
  material.setBaseColorFactor([...colour, opacity] as vec4);
  material.setRoughnessFactor(has('metallicRoughness') ? 1 : roughness);
  material.setMetallicFactor(has('metallicRoughness') ? 1 : metallic);
  material.setEmissiveFactor(
    has('emissive') ? [1, 1, 1] : ([red, green, blue].map(linearOf) as vec3),
  );
  material.setNormalScale(has('normal')?.map.strength ?? 1);
}

const PLAIN = { diffuse: [1, 1, 1], opacity: 1 };
