// The look of an atlas in new images. The document stays as it is until all of them are there.

import type { Material } from '@gltf-transform/core';
import { AbflatError, messageOf } from '../../base/errors.js';
import type { AnyAbflat, BakedImage, BakeOptions, BakeSource } from '../../types/index.js';
import type { EncodeImage } from './codecs.js';
import { type AtlasCorners, haveColours, meshFor } from './corners.js';
import type { ImageFile } from './image-file.js';
import { type MapPlan, planMaps } from './map-plans.js';
import { lookOf, type MapName, type MaterialLook } from './material-look.js';
import type { OldImages } from './old-images.js';

export interface AtlasSettings
  extends Pick<BakeOptions, 'bakeResolution' | 'padding' | 'layoutResolution' | 'signal'> {
  oldImages: OldImages;
  encode: EncodeImage;
  /** Called with the share that is done. */
  onProgress?: (fraction: number) => void;
}

export interface NewImage {
  /** The first is its name: occlusion may be the red of another. */
  maps: MapName[];
  /** In texels. */
  size: Size;
  file: ImageFile;
}

export interface NewLook {
  /** Those of the atlas before; null for primitives without one. */
  materials: (Material | null)[];
  images: NewImage[];
  /** What the emissive map is to be multiplied by. */
  emissiveStrength: number;
}

type Size = readonly [width: number, height: number];

export async function bakeAtlas(
  abflat: AnyAbflat<'bake'>,
  corners: AtlasCorners,
  settings: AtlasSettings,
): Promise<NewLook> {
  const materials = [...new Set(corners.parts.map(({ primitive }) => primitive.getMaterial()))];
  const looks = materials.map(lookOf);
  const { plans, emissiveStrength } = planMaps(looks, haveColours(corners));
  const { oldImages, encode, onProgress, bakeResolution, ...common } = settings;
  const bakeMap = async (plan: MapPlan, size?: Size): Promise<BakedImage> => {
    const mesh = meshFor(corners, plan.name, materials);
    const before = plans.indexOf(plan);
    return abflat.bake(mesh, corners.layout, await sourcesOf(plan, looks, oldImages), {
      ...common,
      bakeResolution: size ?? bakeResolution,
      kind: plan.kind,
      // What is done again for its size is not counted.
      ...(onProgress &&
        size === undefined && {
          onProgress: ({ fraction }) => onProgress((before + fraction) / plans.length),
        }),
    });
  };
  const baked = new Map<MapPlan, BakedImage>();
  for (const plan of plans) baked.set(plan, await bakeMap(plan));
  const images = await joinOcclusion(baked, bakeMap);
  return { materials, images: await encodeAll(images, encode), emissiveStrength };
}

/** One for each material. */
function sourcesOf(
  { name, factors }: MapPlan,
  looks: MaterialLook[],
  oldImages: OldImages,
): Promise<BakeSource[]> {
  return Promise.all(
    looks.map(async (look, i): Promise<BakeSource> => {
      const opaque = name !== 'baseColor' || look.isOpaque;
      const source = { factor: factors[i] as [number, number, number, number], opaque };
      const use = look.textures[name];
      if (!use) return source;
      const { texture, set: _, ...placed } = use;
      const image = await (name === 'occlusion'
        ? oldImages.occlusion(texture, look.occlusionStrength)
        : oldImages.whole(texture));
      return { ...source, ...placed, image };
    }),
  );
}

type Image = Pick<NewImage, 'maps'> & { pixels: BakedImage };

/** Metals, roughness and occlusion are one image, so they have one size. */
async function joinOcclusion(
  baked: Map<MapPlan, BakedImage>,
  bakeMap: (plan: MapPlan, size: Size) => Promise<BakedImage>,
): Promise<Image[]> {
  const plans = [...baked.keys()];
  const whole = plans.find(({ name }) => name === 'metallicRoughness');
  const red = plans.find(({ name }) => name === 'occlusion');
  const sized = async (plan: MapPlan, size: Size) => {
    const image = baked.get(plan) as BakedImage;
    return image.width === size[0] ? image : bakeMap(plan, size);
  };
  const images: Image[] = [];
  for (const plan of plans) {
    const pixels = baked.get(plan) as BakedImage;
    if (!whole || !red || (plan !== whole && plan !== red)) {
      images.push({ maps: [plan.name], pixels });
    } else if (plan === whole) {
      const other = baked.get(red) as BakedImage;
      const { width, height } = other.width > pixels.width ? other : pixels;
      const size: Size = [width, height];
      const joined = withRed(await sized(whole, size), await sized(red, size));
      images.push({ maps: [whole.name, red.name], pixels: joined });
    }
  }
  return images;
}

function withRed(image: BakedImage, red: BakedImage): BakedImage {
  const data = image.data.slice();
  for (let i = 0; i < data.length; i += 4) data[i] = red.data[i] as number;
  return { ...image, data };
}

async function encodeAll(images: Image[], encode: EncodeImage): Promise<NewImage[]> {
  const out: NewImage[] = [];
  for (const { maps, pixels } of images) {
    const name = maps[0] as MapName;
    out.push({
      maps,
      size: [pixels.width, pixels.height],
      file: await encodeOne(pixels, name, encode),
    });
  }
  return out;
}

const TYPES = ['image/png', 'image/jpeg', 'image/webp'];

async function encodeOne(
  pixels: BakedImage,
  name: MapName,
  encode: EncodeImage,
): Promise<ImageFile> {
  let file: ImageFile;
  try {
    file = await encode(pixels, name);
  } catch (error) {
    const reason = messageOf(error).replace(/\.$/, '');
    throw new AbflatError('CannotWrite', `The new image ${name} cannot be encoded: ${reason}.`);
  }
  if (file?.bytes instanceof Uint8Array && TYPES.includes(file.mimeType)) return file;
  throw new AbflatError(
    'InvalidOption',
    `bake.encode must return { bytes, mimeType }: a Uint8Array, and one of ${TYPES.join(', ')}.`,
  );
}
