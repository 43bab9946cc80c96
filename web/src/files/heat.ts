/** Steps of the ratio's logarithm, from 1/2 to 2: more than the eye can tell apart. */
export const HEAT_STEPS = 65;

const LOW = [0x21, 0x66, 0xac];
const MIDDLE = [0xf7, 0xf7, 0xf7];
const HIGH = [0xb2, 0x18, 0x2b];
const NO_AREA = '#808080';

/** The colour of a step: blue if area is lost, white if it is kept, red if it is gained. */
export function heatColor(step: number): string {
  if (step < 0) return NO_AREA;
  const octaves = (2 * step) / (HEAT_STEPS - 1) - 1;
  const end = octaves < 0 ? LOW : HIGH;
  const mixed = MIDDLE.map((x, d) => Math.round(x + Math.abs(octaves) * (end[d] - x)));
  return `rgb(${mixed.join(' ')})`;
}

/**
 * The step of each triangle by its area in uv divided by its area in 3D, relative to that ratio for
 * the whole atlas; -1 without area.
 */
export function heatSteps(in3d: Float64Array, inUv: Float64Array): Int8Array {
  const sum = (areas: Float64Array) => areas.reduce((total, area) => total + area, 0);
  const scale = sum(in3d) / sum(inUv);
  return Int8Array.from(in3d, (area, f) => {
    if (!(area > 0 && inUv[f] > 0)) return -1;
    const octaves = Math.min(1, Math.max(-1, Math.log2((scale * inUv[f]) / area)));
    return Math.round(((octaves + 1) / 2) * (HEAT_STEPS - 1));
  });
}
