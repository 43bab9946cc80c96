import { Color, type ShaderMaterial, Vector2 } from 'three';
import { type Palette, RAMP_SIZE } from '../colors/palette';
import { MEASURES, type Measure, SCALES } from '../model/measures';

/** Triangles whose place on the ramp lies in a range, or whose distance from the best value does. */
export interface Chosen {
  low: number;
  high: number;
  isDistance: boolean;
}

/** Beyond every place on the ramp. */
export const BEYOND = 1e9;
const ALL: Chosen = { low: -BEYOND, high: BEYOND, isDistance: false };

/** What HEAT_GLSL reads. */
export const heatUniforms = () => ({
  ramp: { value: Array.from({ length: RAMP_SIZE }, () => new Color()) },
  twoSided: { value: Array.from({ length: 3 }, () => new Color()) },
  measure: { value: 0 },
  isTwoSided: { value: false },
  chosen: { value: new Vector2(ALL.low, ALL.high) },
  choosesByDistance: { value: false },
});

export function paintHeat({ uniforms }: ShaderMaterial, palette: Palette): void {
  uniforms.ramp.value = palette.ramp;
  uniforms.twoSided.value = palette.twoSided;
}

export function showMeasure({ uniforms }: ShaderMaterial, measure: Measure): void {
  uniforms.measure.value = MEASURES.indexOf(measure);
  uniforms.isTwoSided.value = SCALES[measure].isTwoSided;
}

/** Lights some triangles only; null: all. */
export function choose({ uniforms }: ShaderMaterial, chosen: Chosen | null): void {
  const { low, high, isDistance } = chosen ?? ALL;
  uniforms.chosen.value.set(low, high);
  uniforms.choosesByDistance.value = isDistance;
}
