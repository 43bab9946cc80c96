// A glTF whose textures follow its new layout.

import type { Abflat } from 'abflat';
import { bakeLayout, documentMesh } from 'abflat/gltf';
import type { BakeSettings } from '../model/bake-settings';
import type { GltfFiles, LayoutArrays } from '../model/model';
import { glbOf, gltfIo, openGltf } from './gltf-source';
import { decodeKtx2 } from './ktx2';

export interface BakedGltf {
  /** A GLB. */
  file: Blob;
  images: { maps: string[]; side: number }[];
  /** What to know about the new look, one sentence of abflat each. */
  notes: string[];
}

export async function bakeGltf(
  abflat: Pick<Abflat, 'bake'>,
  { file, others }: GltfFiles,
  layout: Pick<LayoutArrays, 'uv' | 'indices'>,
  { side, ...atlas }: BakeSettings,
  onProgress: (fraction: number) => void,
): Promise<BakedGltf> {
  const { source } = await openGltf(file, others);
  const document = await gltfIo().readJSON(source);
  const options = { ...atlas, bakeResolution: side, onProgress, decode: decodeKtx2 };
  const { baked, notes } = await bakeLayout(abflat, documentMesh(document), layout, options);
  return {
    file: new Blob([await glbOf(document)], { type: 'model/gltf-binary' }),
    images: baked.map(({ maps, side }) => ({ maps, side })),
    notes,
  };
}
