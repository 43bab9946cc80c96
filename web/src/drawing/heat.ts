import { distortionsOf, sum } from '../mesh/distortion';
import { areasOf, type FlatMesh, type TriangleAreas } from '../mesh/mesh';
import {
  BARS,
  distanceFromBest,
  MEASURES,
  type Measure,
  SCALES,
  type Spread,
} from '../model/measures';

/** Of the surface, the share whose values count as the worst. */
const WORST = 0.01;
export interface Heat {
  /** Per triangle, a place on the ramp for each of MEASURES. */
  places: Float32Array;
  spreads: Record<Measure, Spread>;
}

/** `resolution`: texels along the unit of uv; 0: there are none. */
export function heatOf(
  mesh: FlatMesh,
  charts?: Uint32Array,
  sizes: TriangleAreas = areasOf(mesh),
  resolution = 0,
): Heat {
  const distortions = distortionsOf(mesh, charts, sizes);
  const areas = distortions.area3d;
  const found = { ...distortions, texels: distortions.area.map(Math.sqrt) };
  const mean = resolution * Math.sqrt(sum(sizes.inUv) / sum(areas));
  const places = new Float32Array(MEASURES.length * areas.length);
  MEASURES.forEach((measure, k) => {
    const { place } = SCALES[measure];
    const values = found[measure];
    for (let f = 0; f < values.length; ++f) {
      const at = place(values[f]);
      // A triangle without area in uv is as far from the best value as can be drawn.
      places[MEASURES.length * f + k] = Number.isFinite(at) ? at : values[f] > 1 ? 2 : -1;
    }
  });
  const spreads = MEASURES.map((measure) => [measure, { ...spread(measure, places, areas), mean }]);
  return { places, spreads: Object.fromEntries(spreads) };
}

/** To the three corners of each triangle. */
export function heatOfCorners(places: Float32Array): Float32Array {
  const size = MEASURES.length;
  const corners = new Float32Array(3 * places.length);
  for (let f = 0; f < places.length / size; ++f)
    for (let c = 0; c < 3; ++c)
      for (let k = 0; k < size; ++k) corners[size * (3 * f + c) + k] = places[size * f + k];
  return corners;
}

function spread(measure: Measure, places: Float32Array, areas: Float64Array): Omit<Spread, 'mean'> {
  const shares = new Float64Array(BARS);
  const distances = new Float32Array(areas.length);
  const k = MEASURES.indexOf(measure);
  for (let f = 0; f < areas.length; ++f) {
    const place = places[MEASURES.length * f + k];
    shares[barOf(place)] += areas[f];
    distances[f] = Math.max(0, distanceFromBest(measure, place));
  }
  const total = sum(areas);
  if (total > 0) for (let bar = 0; bar < BARS; ++bar) shares[bar] /= total;
  return { shares, worst: threshold(distances, areas, WORST * total) };
}

/**
 * The largest number, to within a hundredth of itself, that values of at least this `area` reach. Values are not negative: the bits of such
 * floats are in the order of the values, so their upper halves count them without sorting.
 */
function threshold(values: Float32Array, areas: Float64Array, area: number): number {
  const bits = new Uint32Array(values.buffer, values.byteOffset, values.length);
  const reached = new Float64Array(1 << 15);
  for (let f = 0; f < bits.length; ++f) reached[bits[f] >>> 16] += areas[f];
  let step = reached.length - 1;
  for (let left = area; step > 0 && reached[step] < left; --step) left -= reached[step];
  return new Float32Array(Uint32Array.of(step << 16).buffer)[0];
}

export const barOf = (place: number): number =>
  Math.min(BARS - 1, Math.max(0, Math.floor(place * BARS)));
