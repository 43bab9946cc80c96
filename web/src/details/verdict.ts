import type { Report, UnwrapReport } from 'abflat';
import type { ChartAreas } from '../mesh/chart-areas';
import { isMisplaced, isOutside, isOverlapping } from '../model/misplaced';
import type { Outcome, Unwrapped } from '../model/model';
import type { UnwrapSettings } from '../model/settings';
import { stackedCharts } from '../model/stacks';
import { inPageWords, sentence } from '../words/format';
import { BADGES, VERDICT } from '../words/result';
import { ofIslands } from './islands';
import type { Verdict } from './remedy';

/**
 * Limit for a mesh in one piece: the square root of its length distortion, which is how much its
 * edges change on average.
 */
const MOST_CHANGE = 0.5;

/** Charts that stayed where they were may have this many times the texels along an edge that others have. */
const MOST_UNEVEN = 1.1;

/**
 * Judges what the user cares about: first that nothing overlaps, then that all charts have the
 * texel density asked for, then that nothing is stretched too much. `areas`: those of the charts as
 * they are drawn.
 */
export function verdictOf(outcome: Outcome, areas: ChartAreas | null): Verdict {
  if (outcome.mode === 'pack') return ofIslands(outcome);
  return outcome.mode === 'unwrap' ? ofAtlas(outcome, areas) : ofDisk(outcome.result.report);
}

function ofDisk({ charts: [chart], valid }: Report): Verdict {
  if (!valid) return { badge: BADGES.notValid, reason: sentence(chart.problem), remedy: null };
  const change = Math.sqrt(chart.lengthDistortion);
  if (!(change > MOST_CHANGE))
    return { badge: BADGES.valid, reason: VERDICT.noCrossings, remedy: null };
  return { badge: BADGES.stretched, reason: VERDICT.lengthsChange(change), remedy: 'unwrap' };
}

function ofAtlas(outcome: Unwrapped, areas: ChartAreas | null): Verdict {
  const { result, settings, stacks } = outcome;
  const { charts, valid } = result.report;
  if (!valid) {
    const remedy = isMisplaced(result.report) ? 'pack' : null;
    return { badge: BADGES.notValid, reason: defects(result.report), remedy };
  }
  const uneven = areas && unevenDensity(outcome, areas);
  if (uneven) return { badge: BADGES.uneven, reason: VERDICT.uneven(...uneven), remedy: 'pack' };
  const beside = areas && unevenBesideKept(outcome, areas);
  if (beside) {
    const reason = VERDICT.unevenBesideKept(...beside);
    return { badge: BADGES.uneven, reason, remedy: null };
  }
  const stretched = stretchedCharts(result.report, settings.maxStretch);
  if (stretched.length === 0) {
    const reason = stacks ? VERDICT.stacked(stackedCharts(stacks)) : VERDICT.noOverlaps;
    return { badge: BADGES.valid, reason, remedy: null };
  }
  const most = Math.max(...stretched.map(({ symmetricDirichlet }) => symmetricDirichlet));
  const limit = settings.maxStretch;
  return {
    badge: BADGES.stretched,
    reason: VERDICT.stretched(above(most, limit), limit, stretched.length, charts.length),
    remedy: isCutEnough(settings) ? null : 'cut',
  };
}

/**
 * The least and the largest texel density, where charts that packing would make even differ; null
 * where they do not. Charts that ask for more texels count as if they did not.
 */
function unevenDensity(
  { result, settings }: Unwrapped,
  areas: ChartAreas,
): [number, number] | null {
  const { charts } = result.report;
  // Each tile of an object has its own density.
  if (settings.tiles) return null;
  if (!charts.some(({ solver, fixed }) => fixed && solver === 'known')) return null;
  const locked = new Set(settings.kept?.charts);
  const isLocked = (chart: number) => locked.has(chart) && settings.kept?.layout === result;
  const densities = charts.flatMap(({ solver, fixed }, i) => {
    return (fixed && solver !== 'known') || isLocked(i) ? [] : densityOf(result, areas, i);
  });
  const [low, high] = rangeOf(densities);
  return high > MOST_UNEVEN * low ? [low, high] : null;
}

/**
 * The least and the largest texel density, where a chart has another one than any that keeps the uv
 * of the file; null where none does. Those may differ from each other.
 */
function unevenBesideKept(
  { result, settings }: Unwrapped,
  areas: ChartAreas,
): [number, number] | null {
  if (!settings.fixedFaces) return null;
  const densities = (isKept: boolean) =>
    result.report.charts.flatMap(({ solver }, i) =>
      (solver === 'given') === isKept ? densityOf(result, areas, i) : [],
    );
  const [kept, others] = [rangeOf(densities(true)), rangeOf(densities(false))];
  const isUneven = others[1] > MOST_UNEVEN * kept[1] || MOST_UNEVEN * others[0] < kept[0];
  if (!isUneven || kept[1] === 0 || others[1] === 0) return null;
  return [Math.min(kept[0], others[0]), Math.max(kept[1], others[1])];
}

/** As if no chart asked for more than another; none where there is no surface. */
function densityOf({ report }: Unwrapped['result'], areas: ChartAreas, chart: number): number[] {
  const { flat, solid, asked } = areas;
  if (!(solid[chart] > 0)) return [];
  return [(report.atlas.resolution * Math.sqrt(flat[chart] / solid[chart])) / asked[chart]];
}

/** The least and the largest. */
const rangeOf = (densities: number[]): [number, number] => [
  densities.reduce((least, each) => Math.min(least, each), Infinity),
  densities.reduce((most, each) => Math.max(most, each), 0),
];

/** Leaves out charts whose shape the user asked to keep, and the front of a figure, within its leeway. */
function stretchedCharts({ charts }: UnwrapReport, maxStretch: number) {
  return charts.filter(
    ({ solver, symmetricDirichlet, leeway }) =>
      solver !== 'given' && symmetricDirichlet > 1 + leeway * (maxStretch - 1),
  );
}

/** Whether all was tried: charts that were moved or packed again are as they were cut before. */
const isCutEnough = ({ seams, seamEdges, placed }: UnwrapSettings) =>
  isAutomatic(seams) && (seamEdges !== undefined || placed === undefined);

/** Whether, with this value of `--seams`, charts are cut until they keep within the limit. */
export const isAutomatic = (seams: string) => seams.split(',').includes('auto');

/** With just enough decimals to show that it is above the limit. */
function above(stretch: number, limit: number): string {
  const digits = [2, 3, 4, 5].find((digits) => Number(stretch.toFixed(digits)) > limit);
  return stretch.toFixed(digits ?? 6);
}

/** Why charts are not valid: how many of each kind. One may be of two kinds. */
function defects({ charts }: UnwrapReport): string {
  const problems = charts.filter(({ valid }) => !valid).map(({ problem }) => problem);
  const outside = problems.filter(isOutside);
  const overlapping = problems.filter(isOverlapping);
  const others = problems.filter((problem) => !isOutside(problem) && !isOverlapping(problem));
  return [
    ...(outside.length > 0 ? [VERDICT.outside(outside.length)] : []),
    ...(overlapping.length > 0 ? [VERDICT.overlapping(overlapping.length)] : []),
    ...(others.length > 0 ? [VERDICT.defects(others.length, inPageWords(others[0]))] : []),
  ].join(', ');
}
