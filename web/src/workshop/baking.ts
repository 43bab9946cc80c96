// The worker's side of baked-glb.ts.

import type { Abflat, BakedImage, BakeOptions, BakeProgress } from 'abflat';
import { type ProxyMarked, proxy } from 'comlink';
import { type BakedGltf, bakeGltf } from '../files/baked-gltf';
import type { BakeSettings } from '../model/bake-settings';
import type { GltfFiles, LayoutArrays } from '../model/model';

type Call = Parameters<Abflat['bake']>;

/** `bake` of abflat, which the page has. */
export type RemoteBake = (
  mesh: Call[0],
  layout: Call[1],
  sources: Call[2],
  options: BakeOptions,
  onProgress: (((progress: BakeProgress) => void) & ProxyMarked) | null,
) => Promise<BakedImage>;

export function bake(
  files: GltfFiles,
  layout: Pick<LayoutArrays, 'uv' | 'indices'>,
  settings: BakeSettings,
  bakeInPage: RemoteBake,
  onProgress: (fraction: number) => void,
): Promise<BakedGltf> {
  const abflat: Pick<Abflat, 'bake'> = {
    // The signal stays in the page.
    bake: (mesh, layout, sources, { onProgress, signal: _, ...values } = {}) =>
      bakeInPage(mesh, layout, sources, values, onProgress ? proxy(onProgress) : null),
  };
  return bakeGltf(abflat, files, layout, settings, onProgress);
}
