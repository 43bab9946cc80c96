// An OBJ whose textures follow its new layout: as an archive with its materials, or as a GLB.

import type { BakedGltf } from './baked-gltf';
import { bakedZip } from './baked-obj-archive';
import { bakedGlb } from './baked-obj-glb';
import type { Bake, Tell } from './obj-baking';
import { ObjImages, type ObjToBake } from './obj-images';

export async function bakeObj(abflat: Bake, wanted: ObjToBake, tell: Tell): Promise<BakedGltf> {
  const look = await ObjImages.read(wanted);
  return wanted.written === null
    ? bakedGlb(abflat, wanted, look, tell)
    : bakedZip(abflat, wanted, wanted.written, look, tell);
}
