import type { TriangleAreas } from './mesh';

/** Of each chart of an atlas as it is drawn. */
export interface ChartAreas {
  /** In uv, whichever way triangles are turned. */
  flat: Float64Array;
  /** On the surface. */
  solid: Float64Array;
  /** The texel density asked for, relative to other charts. */
  asked: Float64Array;
}

/** `asked`: per face, the texel density relative to the others; `faces`: the face of each triangle, if that is not the triangle itself. */
export function chartAreas(
  { in3d, inUv }: TriangleAreas,
  charts: Uint32Array,
  chartCount: number,
  { asked, faces }: { asked?: Float32Array; faces?: Uint32Array },
): ChartAreas {
  const [flat, solid, texels] = Array.from({ length: 3 }, () => new Float64Array(chartCount));
  for (let f = 0; f < charts.length; ++f) {
    const chart = charts[f];
    if (chart >= chartCount) continue; // without area, and touched by nothing
    flat[chart] += inUv[f];
    solid[chart] += in3d[f];
    texels[chart] += in3d[f] * (asked?.[faces ? faces[f] : f] ?? 1) ** 2;
  }
  const askedOf = (sum: number, chart: number) =>
    solid[chart] > 0 ? Math.sqrt(sum / solid[chart]) : 1;
  return { flat, solid, asked: texels.map(askedOf) };
}
