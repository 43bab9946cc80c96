// The worker's side of baked-file.ts.

import type { Abflat, BakedImage, BakeOptions, BakeProgress } from 'abflat';
import { type ProxyMarked, proxy } from 'comlink';
import { loadInWorker } from '../base/load-part';
import { type BakedGltf, bakeGltf } from '../files/baked-gltf';
import type { ObjToBake } from '../files/obj-images';
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

/** `objName`: of the OBJ that a glTF is to become; null: it stays one. */
export async function bake(
  files: GltfFiles,
  layout: Pick<LayoutArrays, 'uv' | 'indices'>,
  settings: BakeSettings,
  objName: string | null,
  bakeInPage: RemoteBake,
  onProgress: (fraction: number) => void,
): Promise<BakedGltf> {
  if (objName === null) return bakeGltf(remote(bakeInPage), files, layout, settings, onProgress);
  const { bakeGltfAsObj } = await loadInWorker(import('../files/baked-gltf-obj'));
  return bakeGltfAsObj(remote(bakeInPage), files, layout, settings, objName, onProgress);
}

/** What bakes an OBJ is loaded with the first of them. */
export async function bakeObj(
  wanted: ObjToBake,
  bakeInPage: RemoteBake,
  onProgress: (fraction: number) => void,
): Promise<BakedGltf> {
  const { bakeObj } = await loadInWorker(import('../files/baked-obj'));
  return bakeObj(remote(bakeInPage), wanted, onProgress);
}

const remote = (bakeInPage: RemoteBake): Pick<Abflat, 'bake'> => ({
  // The signal stays in the page.
  bake: (mesh, layout, sources, { onProgress, signal: _, ...values } = {}) =>
    bakeInPage(mesh, layout, sources, values, onProgress ? proxy(onProgress) : null),
});
