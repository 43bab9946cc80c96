// What the heat maps show, and where on the colour ramp a value lies.

import { HEAT_MAPS } from '../words/view';

/** In the order of the numbers in `TriangleMarks.heat`. */
export const MEASURES = ['angle', 'area', 'stretch', 'texels'] as const;
export type Measure = (typeof MEASURES)[number];

interface Scale {
  title: string;
  /** What the numbers of the legend mean. */
  explanation: string;
  /** 0 at the low end of the ramp and 1 at the high one. Fixed, so that colours compare across layouts and meshes. */
  place(value: number): number;
  value(place: number): number;
  /** `mean`: that of the whole layout, where values are relative to it. */
  text(value: number, mean: number): string;
  /** Whether the middle of the ramp is the best value, not its low end. */
  isTwoSided: boolean;
}

const times = (value: number) => `\u00d7${value.toFixed(2)}`;
const threeDigits = (value: number) => String(Number(value.toPrecision(3)));
const percent = (value: number) => `${(100 * value).toFixed(0)}\u202f%`;

/** At the high end of the ramp. */
const MOST_ANGLE = 0.25;
const MOST_STRETCH = 1.3;

export const SCALES: Record<Measure, Scale> = {
  angle: {
    ...HEAT_MAPS.angle,
    place: (value) => value / MOST_ANGLE,
    value: (place) => place * MOST_ANGLE,
    text: percent,
    isTwoSided: false,
  },
  area: {
    ...HEAT_MAPS.area,
    place: (value) => (Math.log2(value) + 1) / 2,
    value: (place) => 2 ** (2 * place - 1),
    text: times,
    isTwoSided: true,
  },
  stretch: {
    ...HEAT_MAPS.stretch,
    place: (value) => (value - 1) / (MOST_STRETCH - 1),
    value: (place) => 1 + place * (MOST_STRETCH - 1),
    text: (value) => value.toFixed(2),
    isTwoSided: false,
  },
  texels: {
    ...HEAT_MAPS.texels,
    place: (value) => (Math.log2(value) + 1) / 2,
    value: (place) => 2 ** (2 * place - 1),
    text: (value, mean) => (mean > 0 ? threeDigits(value * mean) : times(value)),
    isTwoSided: true,
  },
};

/** Bars of a histogram; what lies beyond the ends of the ramp is in the first or the last. */
export const BARS = 24;

/** How one measure is spread over the surface. */
export interface Spread {
  /** Share of the surface in each bar, by 3D area. */
  shares: Float64Array;
  /** The hundredth of the surface with the worst values lies beyond this distance from the best value, on the ramp. */
  worst: number;
  /** Of the whole layout, in texels per unit of the mesh; 0 if there are no texels. */
  mean: number;
}

/** How far a place on the ramp is from the best value's. */
export const distanceFromBest = (measure: Measure, place: number): number =>
  SCALES[measure].isTwoSided ? Math.abs(place - 0.5) : place;
