import type { Report, UnwrapReport } from 'abflat';
import { BADGES, VERDICT } from '../base/english';
import { sentence } from '../base/format';
import type { Outcome, Unwrapped } from '../model/model';

/** What would reduce stretch: more seams, or seams at all. */
export type Remedy = 'cut' | 'unwrap';

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

/** How abflat says that a chart of an atlas is in the wrong place. */
const OUTSIDE = /^it extends beyond its tile/;
const OVERLAPPING = /^it touches or overlaps the chart/;

/**
 * Judges what the user cares about: first that nothing overlaps, then that nothing is stretched too
 * much.
 */
export function verdictOf(outcome: Outcome): Verdict {
  return outcome.mode === 'unwrap' ? ofAtlas(outcome) : ofDisk(outcome.result.report);
}

function ofDisk({ charts: [chart], valid }: Report): Verdict {
  if (!valid) return { badge: BADGES.notValid, reason: sentence(chart.problem), remedy: null };
  const change = Math.sqrt(chart.lengthDistortion);
  if (!(change > MOST_CHANGE))
    return { badge: BADGES.valid, reason: VERDICT.noCrossings, remedy: null };
  return { badge: BADGES.stretched, reason: VERDICT.lengthsChange(change), remedy: 'unwrap' };
}

function ofAtlas({ result, settings }: Unwrapped): Verdict {
  const { charts, valid } = result.report;
  if (!valid) return { badge: BADGES.notValid, reason: defects(result.report), remedy: null };
  const stretched = stretchedCharts(result.report, settings.maxStretch);
  if (stretched.length === 0)
    return { badge: BADGES.valid, reason: VERDICT.noOverlaps, remedy: null };
  const most = Math.max(...stretched.map(({ symmetricDirichlet }) => symmetricDirichlet));
  const limit = settings.maxStretch;
  return {
    badge: BADGES.stretched,
    reason: VERDICT.stretched(above(most, limit), limit, stretched.length, charts.length),
    remedy: isAutomatic(settings.seams) ? null : 'cut',
  };
}

/** Leaves out charts whose shape the user asked to keep. */
function stretchedCharts({ charts }: UnwrapReport, maxStretch: number) {
  return charts.filter(
    (chart) => chart.solver !== 'given' && chart.symmetricDirichlet > maxStretch,
  );
}

/** Whether, with this value of `--seams`, charts are cut until they keep within the limit. */
export const isAutomatic = (seams: string) => seams.split(',').includes('auto');

/** With just enough decimals to show that it is above the limit. */
function above(stretch: number, limit: number): string {
  const digits = [2, 3, 4, 5].find((digits) => Number(stretch.toFixed(digits)) > limit);
  return stretch.toFixed(digits ?? 6);
}

/** Why charts are not valid: how many of each kind. */
function defects({ charts }: UnwrapReport): string {
  const problems = charts.filter((chart) => !chart.valid).map(({ problem }) => problem);
  const outside = problems.filter((problem) => OUTSIDE.test(problem));
  const overlapping = problems.filter((problem) => OVERLAPPING.test(problem));
  const others = problems.filter((problem) => !OUTSIDE.test(problem) && !OVERLAPPING.test(problem));
  return [
    ...(outside.length > 0 ? [VERDICT.outside(outside.length)] : []),
    ...(overlapping.length > 0 ? [VERDICT.overlapping(overlapping.length)] : []),
    ...(others.length > 0 ? [VERDICT.defects(others.length, others[0])] : []),
  ].join(', ');
}
