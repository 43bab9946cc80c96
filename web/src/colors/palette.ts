import { Color } from 'three';
import { CHART_COLORS } from './chart-colors';
import { FAULTS } from './fault-colors';

/** Colours of the views, as the style sheet defines them for the theme. */
export interface Palette {
  background: Color;
  clay: Color;
  checkA: Color;
  checkB: Color;
  back: Color;
  wire: Color;
  wireOpacity: number;
  boundary: Color;
  fill: Color;
  edge: Color;
  flipped: Color;
  tightened: Color;
  /** Around the unit square. */
  frame: Color;
  /** Between charts. */
  seam: Color;
  /** For edges that a click on the surface would cut. */
  cut: Color;
  /** Of charts, then of faults. */
  faces: Color[];
  /** Low to high. */
  ramp: Color[];
  /** Below, at and above the best value. */
  twoSided: [Color, Color, Color];
}

export const RAMP_SIZE = 4;

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const value = (name: string) => style.getPropertyValue(`--${name}`).trim();
  /** As in "#4080ff". */
  const color = (name: string) => new Color(Number.parseInt(value(name).slice(1), 16));
  return {
    background: color('view'),
    clay: color('clay'),
    checkA: color('check-a'),
    checkB: color('check-b'),
    back: color('back'),
    wire: color('wire'),
    wireOpacity: Number(value('wire-opacity')),
    boundary: color('boundary'),
    fill: color('fill'),
    edge: color('edge'),
    flipped: color('flipped'),
    tightened: color('tightened'),
    frame: color('frame'),
    seam: color('seam'),
    cut: color('cut'),
    faces: [
      ...Array.from({ length: CHART_COLORS }, (_, i) => color(`chart-${i}`)),
      ...FAULTS.map((fault) => color(fault)),
    ],
    ramp: Array.from({ length: RAMP_SIZE }, (_, i) => color(`ramp-${i}`)),
    twoSided: [color('heat-less'), color('heat-same'), color('heat-more')],
  };
}
