import { type ChartArrays, pointOf, verticesOf } from './charts';
import { type Motion, moved } from './motion';

/** How each of some charts is moved. */
export interface Motions {
  charts: Uint32Array;
  motions: Motion[];
  /** Vertices that come to the very place of others: one and the other in turn. */
  onto?: Uint32Array;
  /** How many other charts those come to lie on. */
  below?: number;
}

/**
 * The coordinates with charts moved, in single precision, as files and graphics cards hold them. Of
 * other charts only the vertices are rounded that others come to.
 */
export function movedUv(
  arrays: ChartArrays,
  { charts, motions, onto = NONE }: Motions,
): Float64Array {
  const uv = arrays.uv.slice();
  const vertices = verticesOf(arrays, charts);
  charts.forEach((chart, i) => {
    for (const v of vertices.get(chart) ?? []) {
      const [x, y] = moved(motions[i], pointOf(arrays.uv, v));
      uv[2 * v] = Math.fround(x);
      uv[2 * v + 1] = Math.fround(y);
    }
  });
  for (let i = 0; i < onto.length; i += 2) {
    const place = pointOf(uv, onto[i + 1]).map(Math.fround);
    uv.set(place, 2 * onto[i]);
    uv.set(place, 2 * onto[i + 1]);
  }
  return uv;
}

const NONE = new Uint32Array();
