// How the textures of a glTF follow its new layout.

import type { Outcome, Packed, Unwrapped } from './model';

/** Of the new images, in texels. */
export type ImageSide = number | 'auto';

/** A result of a mesh with textures that has another layout than theirs. */
export type Bakeable = Unwrapped | Packed;

export const isBakeable = (outcome: Outcome | null): outcome is Bakeable =>
  Boolean(outcome?.gltf?.hasMaps) &&
  outcome?.mode !== 'flatten' &&
  !(outcome?.mode === 'pack' && outcome.settings.keepPlaces);
