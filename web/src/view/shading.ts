import { MEASURES, type Measure } from '../model/measures';

/**
 * What both views are painted with: charts or a checkerboard, the materials of the file, the
 * numbered grid, an image of the user's own, or a heat map.
 */
export type Shading = 'plain' | 'materials' | 'grid' | 'image' | Measure;

export const isMeasure = (shading: Shading): shading is Measure =>
  (MEASURES as readonly string[]).includes(shading);
