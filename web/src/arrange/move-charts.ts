import { type ChartArrays, pointOf, verticesOf } from './charts';
import { type Motion, moved } from './motion';

/** How each of some charts is moved. */
export interface Motions {
  charts: Uint32Array;
  motions: Motion[];
}

/**
 * The coordinates with charts moved, in single precision, as files and graphics cards hold them. No
 * other chart changes.
 */
export function movedUv(arrays: ChartArrays, { charts, motions }: Motions): Float64Array {
  const uv = arrays.uv.slice();
  const vertices = verticesOf(arrays, charts);
  charts.forEach((chart, i) => {
    for (const v of vertices.get(chart) ?? []) {
      const [x, y] = moved(motions[i], pointOf(arrays.uv, v));
      uv[2 * v] = Math.fround(x);
      uv[2 * v + 1] = Math.fround(y);
    }
  });
  return uv;
}
