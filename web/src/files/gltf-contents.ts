import type { Document } from '@gltf-transform/core';
import type { GltfContent } from '../model/model';

export function contentsOf(document: Document): GltfContent[] {
  const root = document.getRoot();
  const isMorphed = root
    .listMeshes()
    .some((mesh) => mesh.listPrimitives().some((primitive) => primitive.listTargets().length > 0));
  const has: Record<GltfContent, boolean> = {
    materials: root.listMaterials().length > 0,
    names: root.listNodes().some((node) => node.getName() !== ''),
    skins: root.listSkins().length > 0,
    morphTargets: isMorphed,
    animations: root.listAnimations().length > 0,
  };
  return (Object.keys(has) as GltfContent[]).filter((content) => has[content]);
}
