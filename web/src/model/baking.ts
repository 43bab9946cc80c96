// What textures can follow a new layout, and colours become a texture.

import { meshFileOf } from '../base/mesh-files';
import type { ExportFormat } from '../words/generated-formats';
import type { Outcome, Packed, Source, Unwrapped } from './model';
import { isAsInFile } from './settings';

/** Of the new images, in texels. */
export type ImageSide = number | 'auto';

/** A result of a mesh with textures, or colours of vertices, in another layout than theirs. */
export type Bakeable = Unwrapped | Packed;

/** `isColored`: vertices of a PLY or an OBJ have colours. */
export const isBakeable = (outcome: Outcome | null, isColored: boolean): outcome is Bakeable =>
  Boolean(outcome && (outcome.gltf?.isPainted || isColored || hasObjImages(outcome.source))) &&
  outcome?.mode !== 'flatten' &&
  !(outcome?.mode === 'pack' && isAsInFile(outcome.settings));

/** Whether an OBJ came with a material file and images. */
function hasObjImages(source: Source): boolean {
  if (source.kind !== 'file' || meshFileOf(source.name)?.format !== 'obj') return false;
  const has = (ending: RegExp) => source.others.some(({ name }) => ending.test(name));
  return has(/\.mtl$/i) && has(/\.(png|jpe?g|webp)$/i);
}

/** What can hold the new images: a GLB, or an archive with an OBJ and its materials. */
export function bakedFormats({ gltf, source }: Bakeable): ExportFormat[] {
  if (gltf) return ['glb', 'obj'];
  return hasObjImages(source) ? ['obj', 'glb'] : ['glb'];
}
