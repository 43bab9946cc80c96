import { type FlatMesh, triangleAreas } from './mesh';

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

/** `charts`: the chart of each triangle; without, all are one. */
export function distortionsOf(mesh: FlatMesh, charts?: Uint32Array): Distortions {
  const in3d = triangleAreas(mesh.positions, 3, mesh.indices);
  const inUv = triangleAreas(mesh.uv, 2, mesh.indices);
  const whole = areaScale(in3d, inUv);
  const scales = charts && chartScales(in3d, inUv, charts);
  const count = in3d.length;
  const found = {
    angle: new Float32Array(count),
    area: new Float32Array(count).fill(1),
    stretch: new Float32Array(count).fill(1),
    area3d: in3d,
  };
  for (let f = 0; f < count; ++f) {
    const before = lengths(mesh.positions, 3, mesh.indices, f);
    const after = lengths(mesh.uv, 2, mesh.indices, f);
    const error = angleError(before, after);
    if (!(in3d[f] > 0) || !Number.isFinite(error)) continue;
    found.angle[f] = error;
    found.area[f] = (whole * inUv[f]) / in3d[f];
    const scale = scales ? scales[(charts as Uint32Array)[f]] : whole;
    found.stretch[f] = energy(before, after, { in3d: in3d[f], inUv: inUv[f] }, scale);
  }
  return found;
}

type Lengths = [number, number, number];

/** Of the sides of triangle f, each opposite its corner. */
function lengths(p: Float64Array, size: number, indices: Uint32Array, f: number): Lengths {
  const distance = (v: number, w: number) => {
    let sum = 0;
    for (let d = 0; d < size; ++d) sum += (p[size * v + d] - p[size * w + d]) ** 2;
    return Math.sqrt(sum);
  };
  const [i, j, k] = [indices[3 * f], indices[3 * f + 1], indices[3 * f + 2]];
  return [distance(j, k), distance(k, i), distance(i, j)];
}

/** Interior angle opposite the first side, radians. */
function angle(opposite: number, s: number, t: number): number {
  const cosine = (s * s + t * t - opposite * opposite) / (2 * s * t);
  return Math.acos(Math.min(1, Math.max(-1, cosine)));
}

function angleError(before: Lengths, after: Lengths): number {
  let sum = 0;
  for (let k = 0; k < 3; ++k) {
    const [l, m] = [(k + 1) % 3, (k + 2) % 3];
    const alpha = angle(before[k], before[l], before[m]);
    sum += ((angle(after[k], after[l], after[m]) - alpha) / alpha) ** 2;
  }
  return Math.sqrt(sum / 3);
}

interface Areas {
  in3d: number;
  inUv: number;
}

/**
 * (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 of the map from 3D to uv, whose areas are multiplied by `scale`. By Pinkall and Polthier, σ₁² + σ₂² is
 * the sum of the squared sides in uv, each weighted by the cotangent of the angle opposite it in 3D, over twice the area
 * in 3D; σ₁σ₂ is the ratio of the areas.
 */
function energy(before: Lengths, after: Lengths, { in3d, inUv }: Areas, scale: number): number {
  let sum = 0;
  for (let k = 0; k < 3; ++k) {
    const [a, b, c] = [before[k], before[(k + 1) % 3], before[(k + 2) % 3]];
    const cotangent = (b * b + c * c - a * a) / (4 * in3d);
    sum += cotangent * after[k] * after[k];
  }
  const squares = (scale * sum) / (2 * in3d);
  const ratio = (scale * inUv) / in3d;
  return (squares + squares / (ratio * ratio)) / 4;
}

/** What areas in uv are multiplied by to add up to those in 3D. */
function areaScale(in3d: Float64Array, inUv: Float64Array): number {
  const sum = (areas: Float64Array) => areas.reduce((total, area) => total + area, 0);
  return sum(in3d) / sum(inUv);
}

function chartScales(in3d: Float64Array, inUv: Float64Array, charts: Uint32Array): Float64Array {
  const count = charts.reduce((most, chart) => Math.max(most, chart + 1), 0);
  const [before, after] = [new Float64Array(count), new Float64Array(count)];
  charts.forEach((chart, f) => {
    before[chart] += in3d[f];
    after[chart] += inUv[f];
  });
  return before.map((area, chart) => area / after[chart]);
}
