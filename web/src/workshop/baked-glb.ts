import type { Abflat } from 'abflat';
import { proxy, type Remote, transfer } from 'comlink';
import { buffersOf, copied } from '../base/buffers';
import type { BakedGltf } from '../files/baked-gltf';
import { bakeSettings } from '../model/bake-settings';
import type { Bakeable, ImageSide } from '../model/baking';
import type { GltfFile } from '../model/model';
import type { RemoteBake } from './baking';
import { inOwnWorker } from './start-worker';
import type { Tasks } from './worker';

/** What is baked. */
interface Wanted {
  outcome: Bakeable;
  side: ImageSide;
}

interface Watch {
  signal: AbortSignal;
  onProgress: (fraction: number) => void;
}

/**
 * The document that the mesh came from as GLB, with its new layout and textures that follow. A
 * worker of its own reads and writes; what bakes is another one, of abflat.
 */
export async function bakedGlb(
  abflat: Abflat,
  { outcome, side }: Wanted,
  { signal, onProgress }: Watch,
): Promise<BakedGltf> {
  const { uv, indices } = outcome.result;
  const { files } = outcome.gltf as GltfFile;
  const layout = await copied({ uv, indices });
  const bake: RemoteBake = async (mesh, layout, sources, options, onProgress) => {
    const image = await abflat.bake(mesh, layout, sources, {
      ...options,
      signal,
      ...(onProgress && { onProgress: (progress) => void onProgress(progress) }),
    });
    return transfer(image, buffersOf(image));
  };
  let isOver = false;
  // What was told before the end may arrive after it.
  const tell = (fraction: number) => {
    if (!isOver) onProgress(fraction);
  };
  const work = (tasks: Remote<Tasks>) =>
    tasks.baked(
      files,
      transfer(layout, buffersOf(layout)),
      bakeSettings(outcome, side),
      proxy(bake),
      proxy(tell),
    );
  try {
    return await inOwnWorker('baker', work, signal);
  } finally {
    isOver = true;
  }
}
