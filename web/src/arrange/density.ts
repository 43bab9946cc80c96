import { tileAt } from '../mesh/own-tiles';
import { DENSITY_RULE, type FaceDensities } from '../model/face-densities';
import { boxOf, type ChartArrays, isChart, middleOf, verticesOf } from './charts';
import { turned } from './motion';
import type { Motions } from './move-charts';

export interface SurfaceArrays extends ChartArrays {
  /** xyz per vertex of the layout. */
  positions: ArrayLike<number>;
  /** The face of the mesh that each triangle belongs to, if that is not the triangle itself. */
  faces?: Uint32Array;
  /** Each tile has a density of its own, so charts are compared with those in their tile. */
  isByTile?: boolean;
}

/** A chart that grows by less was not scaled: numbers are rounded. */
const GROWTH = 1e-3;
/** What differs from 1 by less is 1: charts are even again. */
const EVEN = 0.01;

/** Areas per chart. */
interface Areas {
  flat: Float64Array;
  solid: Float64Array;
}

/**
 * Scales each chart so that as many texels fall on its surface as on that of all other charts, or of
 * the whole atlas if there are no others.
 */
export function evened(arrays: SurfaceArrays, charts: Uint32Array): Motions {
  const { flat, solid } = areasOf(arrays);
  const chosen = new Set(charts);
  const groups = groupsOf(arrays, flat.length);
  const sum = (areas: Float64Array, some: number[]) =>
    some.reduce((total, chart) => total + areas[chart], 0);
  const densityOf = (some: number[]) => Math.sqrt(sum(flat, some) / sum(solid, some));
  const wanted = new Map(
    Array.from(chartsIn(groups), ([group, every]) => {
      const others = every.filter((chart) => !chosen.has(chart));
      return [group, densityOf(others.length > 0 ? others : every)];
    }),
  );
  return scaled(
    arrays,
    charts,
    (chart) => (wanted.get(groups[chart]) ?? Number.NaN) / densityOf([chart]),
  );
}

/** Scales each chart to a texel density relative to those that ask for 1. */
export function atDensity(
  arrays: SurfaceArrays,
  charts: Uint32Array,
  density: number,
  asked: FaceDensities,
): Motions {
  const areas = areasOf(arrays);
  const base = basesOf(areas, askedOf(arrays, areas, asked), groupsOf(arrays, areas.flat.length));
  return scaled(
    arrays,
    charts,
    (chart) => (density * base[chart]) / Math.sqrt(areas.flat[chart] / areas.solid[chart]),
  );
}

/**
 * What faces ask for so that charts which were scaled keep their size relative to the others when
 * all are packed anew. `before`: the atlas when they asked for `asked`; `uv`: where charts are now.
 */
export function keptDensities(
  before: SurfaceArrays,
  uv: Float64Array,
  asked: FaceDensities,
): FaceDensities {
  const areas = areasOf(before);
  const ofChart = askedOf(before, areas, asked);
  const base = basesOf(areas, ofChart, groupsOf(before, ofChart.length));
  const { flat, solid } = areasOf({ ...before, uv });
  const now = ofChart.map((old, chart) => {
    const grown = Math.sqrt(flat[chart] / areas.flat[chart]);
    if (!(Math.abs(grown - 1) > GROWTH)) return old;
    const density = Math.sqrt(flat[chart] / solid[chart]) / base[chart];
    if (!Number.isFinite(density) || Math.abs(density - 1) < EVEN) return 1;
    return Math.min(DENSITY_RULE.atMost, Math.max(DENSITY_RULE.atLeast, density));
  });
  const { chartOfTriangle, faces } = before;
  const count = faces ? faces[faces.length - 1] + 1 : chartOfTriangle.length;
  const out = asked?.slice() ?? new Float32Array(count).fill(1);
  chartOfTriangle.forEach((chart, f) => {
    // Faces of other charts keep what they ask for each.
    if (now[chart] !== ofChart[chart]) out[faces ? faces[f] : f] = now[chart];
  });
  if (out.every((density) => density === 1)) return undefined;
  return asked && out.every((density, f) => density === asked[f]) ? asked : out;
}

/** Grows each chart from the middle of its box. */
function scaled(
  arrays: ChartArrays,
  charts: Uint32Array,
  scaleOf: (chart: number) => number,
): Motions {
  const vertices = verticesOf(arrays, charts);
  const motions = [...charts].map((chart) => {
    const scale = scaleOf(chart);
    const middle = middleOf(boxOf(arrays.uv, vertices.get(chart) ?? []));
    // A chart without area has no density.
    return turned(middle, 0, Number.isFinite(scale) && scale > 0 ? scale : 1);
  });
  return { charts, motions };
}

/** What each chart asks for: its faces' texels together, as in the package. */
function askedOf(
  { chartOfTriangle, faces, ...arrays }: SurfaceArrays,
  { solid }: Areas,
  asked: FaceDensities,
) {
  if (!asked) return new Float64Array(solid.length).fill(1);
  const texels = new Float64Array(solid.length);
  chartOfTriangle.forEach((chart, f) => {
    if (chart < texels.length)
      texels[chart] += solidArea(arrays, f) * asked[faces ? faces[f] : f] ** 2;
  });
  return texels.map((sum, chart) => (solid[chart] > 0 ? Math.sqrt(sum / solid[chart]) : 1));
}

/** For each chart, the number of those that it is compared with. */
function groupsOf(arrays: SurfaceArrays, count: number): Uint32Array {
  const groups = new Uint32Array(count);
  if (!arrays.isByTile) return groups;
  for (const [chart, own] of verticesOf(arrays, Uint32Array.from(groups.keys())))
    groups[chart] = tileAt(...middleOf(boxOf(arrays.uv, own)));
  return groups;
}

function chartsIn(groups: Uint32Array): Map<number, number[]> {
  const all = new Map<number, number[]>();
  groups.forEach((group, chart) => {
    const own = all.get(group) ?? [];
    own.push(chart);
    all.set(group, own);
  });
  return all;
}

/** For each chart, the density of those in its group that ask for 1. */
function basesOf(areas: Areas, asked: Float64Array, groups: Uint32Array): Float64Array {
  const bases = new Float64Array(groups.length);
  for (const charts of chartsIn(groups).values()) {
    const base = baseOf(areas, asked, charts);
    for (const chart of charts) bases[chart] = base;
  }
  return bases;
}

/** The density of those of some charts that ask for 1: that of most of their surface. */
function baseOf({ flat, solid }: Areas, asked: Float64Array, charts: number[]): number {
  const bases = charts
    .map((chart) => ({
      base: Math.sqrt(flat[chart] / solid[chart]) / asked[chart],
      area: solid[chart],
    }))
    .filter(({ base }) => base > 0 && Number.isFinite(base));
  bases.sort((a, b) => a.base - b.base);
  let left = bases.reduce((sum, { area }) => sum + area, 0) / 2;
  for (const { base, area } of bases) {
    left -= area;
    if (left <= 0) return base;
  }
  return 1;
}

function areasOf(arrays: SurfaceArrays): Areas {
  const { chartOfTriangle } = arrays;
  const count = chartOfTriangle.reduce(
    (n, chart) => (isChart(chart) ? Math.max(n, chart + 1) : n),
    0,
  );
  const flat = new Float64Array(count);
  const solid = new Float64Array(count);
  chartOfTriangle.forEach((chart, f) => {
    if (!isChart(chart)) return;
    flat[chart] += Math.abs(flatArea(arrays, f));
    solid[chart] += solidArea(arrays, f);
  });
  return { flat, solid };
}

function flatArea({ uv, indices }: Pick<SurfaceArrays, 'uv' | 'indices'>, f: number): number {
  const [i, j, k] = [indices[3 * f], indices[3 * f + 1], indices[3 * f + 2]];
  const [x1, y1] = [uv[2 * j] - uv[2 * i], uv[2 * j + 1] - uv[2 * i + 1]];
  const [x2, y2] = [uv[2 * k] - uv[2 * i], uv[2 * k + 1] - uv[2 * i + 1]];
  return (x1 * y2 - x2 * y1) / 2;
}

function solidArea(
  { positions: p, indices }: Pick<SurfaceArrays, 'positions' | 'indices'>,
  f: number,
): number {
  const [i, j, k] = [3 * indices[3 * f], 3 * indices[3 * f + 1], 3 * indices[3 * f + 2]];
  const [a, b, c] = [p[j] - p[i], p[j + 1] - p[i + 1], p[j + 2] - p[i + 2]];
  const [d, e, g] = [p[k] - p[i], p[k + 1] - p[i + 1], p[k + 2] - p[i + 2]];
  return Math.hypot(b * g - c * e, c * d - a * g, a * e - b * d) / 2;
}
