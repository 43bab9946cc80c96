// Texel densities that are painted on faces.

import { counted } from './format';

/** What a stroke has touched. */
export interface Touched {
  count: number;
  kind: 'island' | 'face';
}

const what = ({ count, kind }: Touched) => counted(count, kind);

export const DENSITIES = {
  /** What the brush can paint: texels along an edge, relative to the rest. */
  factors: [
    ['4×', 4],
    ['3×', 3],
    ['2×', 2],
    ['1.5×', 1.5],
    ['¾×', 0.75],
    ['½×', 0.5],
    ['¼×', 0.25],
  ] as const,
  invitation: { island: 'Drag over islands', face: 'Drag over faces' },
  oneIsland: 'Only one island: cut seams first',
  painting: (touched: Touched, density: number) => `${what(touched)}: paint ${density}×`,
  erasing: (touched: Touched) => `${what(touched)}: erase`,
  painted: (touched: Touched, density: number) => `Painted density ${density} on ${what(touched)}`,
  erased: (touched: Touched) => `Erased the density of ${what(touched)}`,
  cleared: 'Cleared all densities',
  unchanged: 'No densities changed',
  noFace: 'No face here',
  notPainted: 'Densities cannot be painted on this mesh',
};
