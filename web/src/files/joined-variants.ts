import type { Document } from '@gltf-transform/core';
import { KHRMaterialsVariants, type Variant } from '@gltf-transform/extensions';

/** Variants of the same name become one, so that choosing it changes all meshes that have it. */
export function joinVariants(document: Document): void {
  const extension = document
    .getRoot()
    .listExtensionsUsed()
    .find((each) => each instanceof KHRMaterialsVariants);
  const known = new Map<string, Variant>();
  for (const variant of extension?.listVariants() ?? []) {
    const first = known.get(variant.getName());
    if (!first) known.set(variant.getName(), variant);
    else {
      for (const parent of variant.listParents()) parent.swap(variant, first);
      variant.dispose();
    }
  }
}
