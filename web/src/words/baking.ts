// Textures that follow a new layout.

import { count, ended, listed, sentence } from './format';

const MAPS: Record<string, string> = {
  baseColor: 'colour',
  metallicRoughness: 'metal and roughness',
  occlusion: 'occlusion',
  normal: 'normals',
  emissive: 'emission',
  // Of an OBJ.
  diffuse: 'colour',
  ambient: 'ambient colour',
  specular: 'highlights',
  shininess: 'shininess',
  opacity: 'opacity',
  roughness: 'roughness',
  metallic: 'metal',
  bump: 'bumps',
  displacement: 'displacement',
};

const imageOf = ({ maps, side }: { maps: string[]; side: number }) =>
  `${maps.map((map) => MAPS[map]).join(' with ')} ${count(side)}\u202fpx`;

export const BAKE_CHOICE = {
  title: 'Bake textures',
  what: 'New images for the new UVs: the mesh looks as before',
  oneTile: 'Not with UDIM: images are for one tile',
  sides: 'Image size',
  side: (side: number | 'auto') => (side === 'auto' ? 'Auto' : `${count(side)}\u202fpx`),
  auto: 'As sharp as the old images',
};

export const BAKING = {
  baking: 'Baking textures',
  images: (images: { maps: string[]; side: number }[]) =>
    images.length === 0 ? '' : `New images: ${listed(images.map(imageOf))}.`,
  done: 'Textures follow the new UVs',
  /** A sentence of abflat. */
  note: (text: string) => ended(sentence(text)),
  stacked: 'Islands that share texels show one texture.',
};
