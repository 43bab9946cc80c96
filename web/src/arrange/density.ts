import { boxOf, type ChartArrays, middleOf, trianglesOf, verticesOf } from './charts';
import { turned } from './motion';
import type { Motions } from './move-charts';

export interface SurfaceArrays extends ChartArrays {
  /** xyz per vertex of the layout. */
  positions: ArrayLike<number>;
}

/**
 * Scales each chart so that as many texels fall on its surface as on that of all other charts, or of
 * the whole atlas if there are no others.
 */
export function evened(arrays: SurfaceArrays, charts: Uint32Array): Motions {
  const chosen = new Set(charts);
  const every = new Set(arrays.chartOfTriangle);
  const others = [...every].filter((chart) => !chosen.has(chart));
  const triangles = trianglesOf(arrays.chartOfTriangle, Uint32Array.from(every));
  const areas = new Map([...every].map((c) => [c, areasOf(arrays, triangles.get(c) ?? [])]));
  const densityOf = (some: Iterable<number>) => {
    let [flat, solid] = [0, 0];
    for (const chart of some) {
      flat += areas.get(chart)?.flat ?? 0;
      solid += areas.get(chart)?.solid ?? 0;
    }
    return Math.sqrt(flat / solid);
  };
  const wanted = densityOf(others.length > 0 ? others : every);
  const vertices = verticesOf(arrays, charts);
  const motions = [...charts].map((chart) => {
    const scale = wanted / densityOf([chart]);
    const middle = middleOf(boxOf(arrays.uv, vertices.get(chart) ?? []));
    // A chart without area has no density.
    return turned(middle, 0, Number.isFinite(scale) && scale > 0 ? scale : 1);
  });
  return { charts, motions };
}

function areasOf({ uv, indices, positions }: SurfaceArrays, triangles: number[]) {
  let [flat, solid] = [0, 0];
  for (const f of triangles) {
    const corners = [0, 1, 2].map((k) => indices[3 * f + k]);
    flat += Math.abs(flatArea(uv, corners));
    solid += solidArea(positions, corners);
  }
  return { flat, solid };
}

function flatArea(uv: ArrayLike<number>, [i, j, k]: number[]): number {
  const [x1, y1] = [uv[2 * j] - uv[2 * i], uv[2 * j + 1] - uv[2 * i + 1]];
  const [x2, y2] = [uv[2 * k] - uv[2 * i], uv[2 * k + 1] - uv[2 * i + 1]];
  return (x1 * y2 - x2 * y1) / 2;
}

function solidArea(p: ArrayLike<number>, [i, j, k]: number[]): number {
  const side = (to: number) => [0, 1, 2].map((d) => p[3 * to + d] - p[3 * i + d]);
  const [[a, b, c], [d, e, f]] = [side(j), side(k)];
  return Math.hypot(b * f - c * e, c * d - a * f, a * e - b * d) / 2;
}
