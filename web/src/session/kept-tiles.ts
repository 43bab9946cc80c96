// Tiles of parts of which an edit of seams has changed no chart.

import type { UnwrapResult } from 'abflat';
import { isIsland, tileAt } from '../mesh/own-tiles';

export type TiledLayout = Pick<UnwrapResult, 'uv' | 'indices' | 'vertexMap' | 'chartOfTriangle'>;

/**
 * The charts of `now` that stay as they are in `before`: all charts of a tile are there with the same
 * triangles and seams, and no other chart was in it. `tiles` has the tile of each chart of `now`.
 */
export function keptCharts(
  before: TiledLayout,
  now: UnwrapResult,
  tiles: Uint32Array,
): Set<number> {
  if (before.indices.length !== now.indices.length) return new Set();
  const tilesBefore = tilesIn(before);
  const changed = new Set<number>();
  const stays = now.report.charts.map(({ solver, fixed }) => fixed || solver === 'known');
  const twin = new Map<number, number>();
  now.chartOfTriangle.forEach((chart, f) => {
    const was = before.chartOfTriangle[f];
    if (!isIsland(chart) || !isIsland(was)) {
      if (isIsland(chart)) changed.add(tiles[chart]);
      if (isIsland(was)) changed.add(tilesBefore[was]);
      return;
    }
    if (!twin.has(was)) twin.set(was, chart);
    const isSame =
      twin.get(was) === chart &&
      stays[chart] &&
      tiles[chart] === tilesBefore[was] &&
      [0, 1, 2].every((k) => inputAt(before, 3 * f + k) === inputAt(now, 3 * f + k));
    if (isSame) return;
    changed.add(tiles[chart]);
    changed.add(tilesBefore[was]);
  });
  return new Set([...tiles.keys()].filter((chart) => !changed.has(tiles[chart])));
}

const inputAt = ({ vertexMap, indices }: TiledLayout, corner: number) => vertexMap[indices[corner]];

/** The tile of each chart's first corner. */
function tilesIn({ uv, indices, chartOfTriangle }: TiledLayout): number[] {
  const out: number[] = [];
  chartOfTriangle.forEach((chart, f) => {
    if (!isIsland(chart)) return;
    const v = indices[3 * f];
    out[chart] ??= tileAt(uv[2 * v], uv[2 * v + 1]);
  });
  return out;
}
