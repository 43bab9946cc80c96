// Objects or materials of an atlas that have UDIM tiles of their own. Loaded when that is asked for.

import type { UnwrapResult } from 'abflat';
import { copied } from '../base/buffers';
import type { DisplayMesh } from '../mesh/mesh';
import { isIsland, tilesOfParts } from '../mesh/own-tiles';
import { positionsOf } from '../mesh/positions-of';
import type { NamedPart } from '../model/named-parts';
import type { UnwrapSettings } from '../model/settings';
import { stacksIn } from '../model/stacks';
import { keptCharts, type TiledLayout } from './kept-tiles';
import { inPlace, type Judged, judged, type Runs, withVerdict } from './stacks';

/**
 * The atlas with the charts of each part packed in a tile of its own, in their sizes beside each
 * other. A chart belongs to the part of its first triangle, and a stack to that of its lowest chart.
 * Charts that are fixed stay, and so do those of tiles in which nothing has changed since `before`.
 */
export async function inPartTiles(
  { result, stacks }: Judged,
  parts: readonly NamedPart[],
  {
    settings,
    mesh,
    before,
  }: { settings: UnwrapSettings; mesh: DisplayMesh; before: TiledLayout | null },
  runs: Runs,
): Promise<Judged> {
  const { chartOfTriangle, report } = result;
  const together = stacks ?? stacksIn(report) ?? [];
  const tiles = tilesOfParts(parts, chartOfTriangle, report.charts.length, together);
  const positions = positionsOf(result, mesh);
  const kept = before ? keptCharts(before, result, tiles) : new Set<number>();
  const uv = before ? withPlaces(result, before, kept) : result.uv;
  const isFixed = (chart: number) => report.charts[chart].fixed;
  const onFixed = new Set(together.filter((stack) => stack.some(isFixed)).flat());
  const stays = (chart: number) => isFixed(chart) || onFixed.has(chart) || kept.has(chart);
  const packedUv = await packed({ ...result, uv, positions }, { tiles, stays }, settings, runs);
  // The files are of the charts before.
  const { obj: _obj, ply: _ply, ...rest } = { ...result, uv: packedUv };
  const placed = await inPlace(rest, runs, settings.stack);
  const { tiles: count, utilization, texelDensity } = placed.report.atlas;
  const atlas = { ...report.atlas, tiles: count, utilization, texelDensity };
  return judged({ ...rest, report: withVerdict(rest, placed, atlas) }, runs);
}

/** The coordinates with these charts where they were before. */
function withPlaces(
  { uv, indices, chartOfTriangle }: UnwrapResult,
  before: TiledLayout,
  charts: Set<number>,
): Float64Array {
  const out = uv.slice();
  indices.forEach((v, c) => {
    if (!charts.has(chartOfTriangle[Math.floor(c / 3)])) return;
    for (const d of [0, 1]) out[2 * v + d] = before.uv[2 * before.indices[c] + d];
  });
  return out;
}

/** Where charts that are still to be packed lie on none that stay, as those would stay together. */
const ASIDE = 16;

/** Where each chart goes, and which ones are there already. */
interface Places {
  tiles: Uint32Array;
  stays: (chart: number) => boolean;
}

/** The coordinates of the charts in these tiles. */
async function packed(
  { positions, uv, indices, chartOfTriangle }: UnwrapResult & { positions: Float64Array },
  { tiles, stays }: Places,
  { resolution, padding, rotate, texelDensity }: UnwrapSettings,
  { abflat, signal }: Runs,
): Promise<Float64Array> {
  const isLoose = (f: number) => isIsland(chartOfTriangle[f]) && !stays(chartOfTriangle[f]);
  const texcoords = uv.slice();
  indices.forEach((v, c) => {
    if (isLoose(Math.floor(c / 3))) texcoords[2 * v] = uv[2 * v] + ASIDE;
  });
  const layout = () => copied({ positions, indices, texcoords });
  const asked = { resolution, transfer: true, signal };
  const found = await abflat.pack(await layout(), { ...asked, keepPlaces: true });
  const tileOfIsland = new Uint32Array(found.report.islands);
  const loose = new Set<number>();
  found.islandOfTriangle.forEach((island, f) => {
    const chart = chartOfTriangle[f];
    if (!isIsland(island) || !isIsland(chart)) return;
    tileOfIsland[island] = tiles[chart];
    if (isLoose(f)) loose.add(island);
  });
  if (loose.size === 0) return uv;
  const isPart = loose.size < found.report.islands;
  const made = await abflat.pack(await layout(), {
    ...asked,
    padding,
    rotate,
    texelDensity,
    tileOfIsland,
    ...(isPart && { islands: Uint32Array.from(loose) }),
  });
  const out = uv.slice();
  indices.forEach((v, c) => {
    if (!isLoose(Math.floor(c / 3))) return;
    for (const d of [0, 1]) out[2 * v + d] = Math.fround(made.uv[2 * made.indices[c] + d]);
  });
  return out;
}
