import { type FlatMesh, triangleAreas } from './mesh';

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
  { positions, uv, indices }: FlatMesh,
  charts: Uint32Array,
  chartCount: number,
  { asked, faces }: { asked?: Float32Array; faces?: Uint32Array },
): ChartAreas {
  const [flatOf, solidOf] = [triangleAreas(uv, 2, indices), triangleAreas(positions, 3, indices)];
  const [flat, solid, texels] = Array.from({ length: 3 }, () => new Float64Array(chartCount));
  charts.forEach((chart, f) => {
    if (chart >= chartCount) return; // without area, and touched by nothing
    flat[chart] += flatOf[f];
    solid[chart] += solidOf[f];
    texels[chart] += solidOf[f] * (asked?.[faces ? faces[f] : f] ?? 1) ** 2;
  });
  const askedOf = (sum: number, chart: number) =>
    solid[chart] > 0 ? Math.sqrt(sum / solid[chart]) : 1;
  return { flat, solid, asked: texels.map(askedOf) };
}
