import type { Report, UnwrapReport } from 'abflat';
import { BADGES, VERDICT } from '../base/english';
import { sentence } from '../base/format';
import type { ChartAreas } from '../mesh/chart-areas';
import { isOutside, isOverlapping } from '../model/misplaced';
import type { Outcome, Unwrapped } from '../model/model';
import type { UnwrapSettings } from '../model/settings';
import { stackedCharts } from '../model/stacks';

/** What would help: more seams, seams at all, or packing all charts anew. */
export type Remedy = 'cut' | 'unwrap' | 'pack';

export interface Verdict {
  badge: (typeof BADGES)[Exclude<keyof typeof BADGES, 'none'>];
  /** One sentence on why. */
  reason: string;
  /** What the user can do about it; null if no single click helps. */
  remedy: Remedy | null;
}

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
  { flat, solid, asked }: ChartAreas,
): [number, number] | null {
  const { charts, atlas } = result.report;
  if (!charts.some(({ solver, fixed }) => fixed && solver === 'known')) return null;
  const locked = new Set(settings.kept?.charts);
  const isLocked = (chart: number) => locked.has(chart) && settings.kept?.layout === result;
  const densities = charts.flatMap(({ solver, fixed }, i) => {
    if ((fixed && solver !== 'known') || isLocked(i) || !(solid[i] > 0)) return [];
    return (atlas.resolution * Math.sqrt(flat[i] / solid[i])) / asked[i];
  });
  const low = densities.reduce((least, each) => Math.min(least, each), Infinity);
  const high = densities.reduce((most, each) => Math.max(most, each), 0);
  return high > MOST_UNEVEN * low ? [low, high] : null;
}

/** Leaves out charts whose shape the user asked to keep. */
function stretchedCharts({ charts }: UnwrapReport, maxStretch: number) {
  return charts.filter(
    (chart) => chart.solver !== 'given' && chart.symmetricDirichlet > maxStretch,
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

/** Whether nothing is wrong but where charts are, and packing moves one of them. */
function isMisplaced({ charts }: UnwrapReport): boolean {
  const bad = charts.filter(({ valid }) => !valid);
  return (
    bad.every(({ problem }) => isOutside(problem) || isOverlapping(problem)) &&
    bad.some(({ solver, fixed }) => fixed && solver === 'known')
  );
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
    ...(others.length > 0 ? [VERDICT.defects(others.length, others[0])] : []),
  ].join(', ');
}
