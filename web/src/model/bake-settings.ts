import type { Bakeable, ImageSide } from './baking';

/** What new images are made for. */
export interface BakeSettings {
  /** Between charts, in texels of an image of this resolution. */
  padding: number;
  resolution: number;
  side: ImageSide;
}

const atlasOf = (outcome: Bakeable) =>
  outcome.mode === 'pack' ? outcome.result.report : outcome.result.report.atlas;

/** Images are for one tile. */
export const isOneTile = (outcome: Bakeable) => atlasOf(outcome).tiles === 1;

export function bakeSettings(outcome: Bakeable, side: ImageSide): BakeSettings {
  const { padding, resolution } = atlasOf(outcome);
  return { padding, resolution, side };
}
