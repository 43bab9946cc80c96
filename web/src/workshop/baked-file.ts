import type { Abflat } from 'abflat';
import { proxy, type Remote, transfer } from 'comlink';
import { buffersOf, copied } from '../base/buffers';
import type { BakedGltf } from '../files/baked-gltf';
import type { ObjToBake } from '../files/obj-images';
import { bakeSettings } from '../model/bake-settings';
import type { Bakeable, ImageSide } from '../model/baking';
import type { FileSource, GltfFile } from '../model/model';
import type { RemoteBake } from './baking';
import { inOwnWorker } from './start-worker';
import type { Tasks } from './worker';

/** What is baked. */
interface Wanted {
  outcome: Bakeable;
  side: ImageSide;
  /** For an OBJ: the name of the new file, and the OBJ with the layout, or null for a GLB. */
  obj: Pick<ObjToBake, 'name' | 'written'> | null;
  /** For a glTF that is to become an OBJ: its name. */
  objName: string | null;
}

interface Watch {
  signal: AbortSignal;
  onProgress: (fraction: number) => void;
}

/**
 * The document that the mesh came from as GLB or OBJ, or its OBJ, with its new layout and textures that follow. A
 * worker of its own reads and writes; what bakes is another one, of abflat.
 */
export async function bakedFile(
  abflat: Abflat,
  { outcome, side, obj, objName }: Wanted,
  { signal, onProgress }: Watch,
): Promise<BakedGltf> {
  const { uv, indices, vertexMap } = outcome.result;
  const layout = await copied({ uv, indices, vertexMap });
  const mesh = await copied(obj ? outcome.mesh : null);
  const settings = bakeSettings(outcome, side);
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
  const work = (tasks: Remote<Tasks>) => {
    const rest = [proxy(bake), proxy(tell)] as const;
    if (!obj || !mesh) {
      const { files } = outcome.gltf as GltfFile;
      return tasks.baked(files, transfer(layout, buffersOf(layout)), settings, objName, ...rest);
    }
    const { file, others } = outcome.source as FileSource;
    const wanted: ObjToBake = { file, others, mesh, layout, settings, ...obj };
    return tasks.bakedObj(transfer(wanted, buffersOf([mesh, layout])), ...rest);
  };
  try {
    return await inOwnWorker('baker', work, signal);
  } finally {
    isOver = true;
  }
}
