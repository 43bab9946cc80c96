import { areasOf, type FlatMesh, type TriangleAreas } from './mesh';

/** How each triangle of a layout differs from the triangle in 3D. Without area there: angle 0, area 1, stretch 1. */
export interface Distortions {
  /**
   * Root mean square over the corners of the relative change of the angle. The square's mean over all triangles is the
   * angular distortion of the report.
   */
  angle: Float32Array;
  /** Area in uv divided by area in 3D, at equal area of the whole layout. */
  area: Float32Array;
  /**
   * Symmetric Dirichlet energy / 4, at equal area of the triangle's chart. Its mean by 3D area is the report's; 1 keeps
   * all lengths.
   */
  stretch: Float32Array;
  /** Area in 3D. */
  area3d: Float64Array;
}

/** `charts`: the chart of each triangle; without, all are one. `areas`: `areasOf` the mesh. */
export function distortionsOf(
  mesh: FlatMesh,
  charts?: Uint32Array,
  { in3d, inUv }: TriangleAreas = areasOf(mesh),
): Distortions {
  const whole = areaScale(in3d, inUv);
  const scales = charts && chartScales(in3d, inUv, charts);
  const count = in3d.length;
  const found = {
    angle: new Float32Array(count),
    area: new Float32Array(count).fill(1),
    stretch: new Float32Array(count).fill(1),
    area3d: in3d,
  };
  const before = new Float64Array(3);
  const after = new Float64Array(3);
  for (let f = 0; f < count; ++f) {
    measure(mesh.positions, 3, mesh.indices, f, before);
    measure(mesh.uv, 2, mesh.indices, f, after);
    const error = angleError(before, after);
    if (!(in3d[f] > 0) || !Number.isFinite(error)) continue;
    found.angle[f] = error;
    found.area[f] = (whole * inUv[f]) / in3d[f];
    const scale = scales ? scales[(charts as Uint32Array)[f]] : whole;
    found.stretch[f] = energy(before, after, in3d[f], inUv[f], scale);
  }
  return found;
}

/** The lengths of the sides of triangle f, each opposite its corner. */
function measure(
  points: Float64Array,
  size: number,
  indices: Uint32Array,
  f: number,
  lengths: Float64Array,
): void {
  const i = indices[3 * f];
  const j = indices[3 * f + 1];
  const k = indices[3 * f + 2];
  lengths[0] = distance(points, size, j, k);
  lengths[1] = distance(points, size, k, i);
  lengths[2] = distance(points, size, i, j);
}

function distance(p: Float64Array, size: number, v: number, w: number): number {
  let sum = 0;
  for (let d = 0; d < size; ++d) sum += (p[size * v + d] - p[size * w + d]) ** 2;
  return Math.sqrt(sum);
}

/** Interior angle opposite the first side, radians. */
function angle(opposite: number, s: number, t: number): number {
  const cosine = (s * s + t * t - opposite * opposite) / (2 * s * t);
  return Math.acos(Math.min(1, Math.max(-1, cosine)));
}

function angleError(before: Float64Array, after: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < 3; ++k) {
    const l = (k + 1) % 3;
    const m = (k + 2) % 3;
    const alpha = angle(before[k], before[l], before[m]);
    sum += ((angle(after[k], after[l], after[m]) - alpha) / alpha) ** 2;
  }
  return Math.sqrt(sum / 3);
}

/**
 * (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 of the map from 3D to uv, whose areas are multiplied by `scale`. By Pinkall and Polthier, σ₁² + σ₂² is
 * the sum of the squared sides in uv, each weighted by the cotangent of the angle opposite it in 3D, over twice the area
 * in 3D; σ₁σ₂ is the ratio of the areas.
 */
function energy(
  before: Float64Array,
  after: Float64Array,
  in3d: number,
  inUv: number,
  scale: number,
): number {
  let sum = 0;
  for (let k = 0; k < 3; ++k) {
    const a = before[k];
    const b = before[(k + 1) % 3];
    const c = before[(k + 2) % 3];
    const cotangent = (b * b + c * c - a * a) / (4 * in3d);
    sum += cotangent * after[k] * after[k];
  }
  const squares = (scale * sum) / (2 * in3d);
  const ratio = (scale * inUv) / in3d;
  return (squares + squares / (ratio * ratio)) / 4;
}

export function sum(values: Float64Array): number {
  let total = 0;
  for (let i = 0; i < values.length; ++i) total += values[i];
  return total;
}

/** What areas in uv are multiplied by to add up to those in 3D. */
function areaScale(in3d: Float64Array, inUv: Float64Array): number {
  return sum(in3d) / sum(inUv);
}

/** Triangles without uv have no chart. */
const NO_CHART = 0xffffffff;

function chartScales(in3d: Float64Array, inUv: Float64Array, charts: Uint32Array): Float64Array {
  let count = 0;
  for (let f = 0; f < charts.length; ++f)
    if (charts[f] >= count && charts[f] !== NO_CHART) count = charts[f] + 1;
  const before = new Float64Array(count);
  const after = new Float64Array(count);
  for (let f = 0; f < charts.length; ++f) {
    before[charts[f]] += in3d[f];
    after[charts[f]] += inUv[f];
  }
  return before.map((area, chart) => area / after[chart]);
}
