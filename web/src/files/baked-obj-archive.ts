// A baked OBJ as an archive, with its materials and their new images.

import type { Document } from '@gltf-transform/core';
import { strToU8, zipSync } from 'fflate';
import type { BakedGltf } from './baked-gltf';
import { isTransparent } from './image-channels';
import { COLOURS, type MtlMap, mtlText, withMtl } from './mtl-maps';
import { type Bake, bake, bytesOf, type Tell, textureOf } from './obj-baking';
import { documentOf, putTexture, type Slot } from './obj-document';
import type { ObjImages, ObjToBake, Use } from './obj-images';

/** What becomes one new image: a use for each number of a material. */
interface Group {
  name: string;
  slot: Slot;
  isTransparent: boolean;
  uses: Map<number, Use>;
}

/** Every kind of map has an image of its own, and materials stay as they are. */
export async function bakedZip(
  abflat: Bake,
  { name, settings }: ObjToBake,
  written: string,
  look: ObjImages,
  tell: Tell,
): Promise<BakedGltf> {
  const { groups, groupOf } = await groupsOf(look);
  const files: Record<string, Uint8Array> = {};
  const images: BakedGltf['images'] = [];
  const notes = new Set(look.notes);
  const fileOf = ({ name: group }: Group) => `${name}-${group}.png`;
  for (const [i, group] of groups.entries()) {
    const document = await documentOfGroup(name, look, group);
    const made = await bake(abflat, document, look.shape, settings, (fraction) =>
      tell((i + fraction) / groups.length),
    );
    if (made.bytes) files[fileOf(group)] = made.bytes;
    images.push(...made.images.map(({ side }) => ({ maps: [group.name], side })));
    for (const note of made.notes) notes.add(note);
  }
  const mtl = mtlText(look.materials, (map) => {
    const group = groupOf.get(map);
    return group && fileOf(group);
  });
  files[`${name}.mtl`] = strToU8(mtl);
  files[`${name}.obj`] = strToU8(withMtl(written, `${name}.mtl`));
  const archive = zipSync(files, { level: 6 }) as Uint8Array<ArrayBuffer>;
  return { file: new Blob([archive], { type: 'application/zip' }), images, notes: [...notes] };
}

/** Maps that mean the same share an image, and so do those that use the same ones alike. */
async function groupsOf(look: ObjImages) {
  const groups: Group[] = [];
  const groupOf = new Map<MtlMap, Group>();
  for (const material of look.names.keys())
    for (const map of look.mapsOf(material)) {
      const image = look.imageOf(map);
      if (!image) continue;
      const fresh = await groupFor(look, { map, image });
      const known = groups.find(
        (each) => each.name === fresh.name && isFree(each.uses.get(material), { map, image }),
      );
      const group = known ?? fresh;
      if (!known) groups.push(fresh);
      group.isTransparent ||= fresh.isTransparent;
      group.uses.set(material, { map, image });
      groupOf.set(map, group);
    }
  const kept: Group[] = [];
  for (const group of groups) {
    const same = kept.find((other) => holds(other, group));
    if (!same) kept.push(group);
    else for (const [map, own] of groupOf) if (own === group) groupOf.set(map, same);
  }
  return { groups: kept, groupOf };
}

async function groupFor(look: ObjImages, { map, image }: Use): Promise<Group> {
  const uses = new Map<number, Use>();
  if (await look.isNormalMap(map, image))
    return { name: 'normal', slot: 'normal', isTransparent: false, uses };
  const name = map.name as string;
  const isColour = (COLOURS as readonly string[]).includes(name);
  // Programs take the alpha of an opacity, if there is any.
  const hasAlpha = (isColour || name === 'opacity') && (await isTransparent(image));
  return {
    name,
    slot: isColour || hasAlpha ? 'baseColor' : 'occlusion',
    isTransparent: hasAlpha,
    uses,
  };
}

const isFree = (known: Use | undefined, use: Use) => !known || isSame(known, use);

const isSame = (a: Use, b: Use) =>
  a.image === b.image &&
  a.map.isClamped === b.map.isClamped &&
  `${a.map.scale} ${a.map.offset}` === `${b.map.scale} ${b.map.offset}`;

/** Whether an image has all that another would have. */
function holds(first: Group, group: Group): boolean {
  if (first.slot !== group.slot || (group.isTransparent && !first.isTransparent)) return false;
  return [...group.uses].every(([material, use]) => {
    const known = first.uses.get(material);
    return known !== undefined && isSame(known, use);
  });
}

async function documentOfGroup(name: string, look: ObjImages, group: Group): Promise<Document> {
  const bytes = await bytesOf([...group.uses.values()].map(({ image }) => image));
  return documentOf(name, look.shape, (document, number) => {
    const material = document.createMaterial();
    const use = group.uses.get(number);
    if (group.isTransparent) material.setAlphaMode('BLEND');
    if (!use) return material;
    const texture = textureOf(document, use.image, bytes);
    putTexture(document, material, group.slot, texture, use.map);
    return material;
  });
}
