import { boxOf, type ChartArrays, pointOf, trianglesOf, verticesOf } from './charts';
import { areaOf } from './stacks';

export interface Flipped {
  /** In single precision where charts are flipped, as files and graphics cards hold them. */
  uv: Float64Array;
  /** Those of the charts with faces that run either way: some are mirrored before and after. */
  folded: number[];
}

/** Mirrors each chart along u, about the middle of its box. */
export function flipped(arrays: ChartArrays, charts: Uint32Array): Flipped {
  const uv = arrays.uv.slice();
  for (const vertices of verticesOf(arrays, charts).values()) {
    const { low, high } = boxOf(arrays.uv, vertices);
    const sum = low[0] + high[0];
    for (const v of vertices) {
      const [x, y] = pointOf(arrays.uv, v);
      uv[2 * v] = Math.fround(sum - x);
      uv[2 * v + 1] = Math.fround(y);
    }
  }
  const triangles = trianglesOf(arrays.chartOfTriangle, charts);
  const folded = [...charts].filter((chart) => runsEitherWay(arrays, triangles.get(chart) ?? []));
  return { uv, folded };
}

function runsEitherWay(arrays: ChartArrays, triangles: readonly number[]): boolean {
  const areas = triangles.map((f) => areaOf(arrays, f));
  return areas.some((area) => area > 0) && areas.some((area) => area < 0);
}
