import type { ChartReport } from 'abflat';
import type { ChartSpec, Column, Mark, Series } from '../plot/chart-spec';
import { fixedScale, linearScale } from '../plot/scale';
import { VALIDITY } from '../words/details';
import { type Bound, bound, measure } from '../words/format';
import { SWEEP_CHART } from '../words/plots';

/** The values of t to try, close together where distortion changes fast. */
export const SWEEP_T: Bound[] = ['auto', 2, 1.8, 1.6, 1.4, 1.2, 1.1, 1.05, 1, 0.98];

/** The result for one t; no chart if that t is infeasible for this mesh. */
export interface SweepPoint {
  t: Bound;
  chart: ChartReport | null;
}

interface Drawn {
  t: Bound;
  chart: ChartReport;
}

const LEAST = 0.95;
const MOST = 2;
const TICKS = [1, 1.2, 1.4, 1.6, 1.8, 2];

/**
 * Distortion over t. `current` is the t of the layout on screen; `choose` is called with the t of a
 * point.
 */
export function sweepChart(
  points: SweepPoint[],
  current: number,
  choose: (t: Bound) => void,
): ChartSpec {
  const drawn = points.filter((point): point is Drawn => point.chart !== null);
  const shown = drawn.sort((a, b) => placeOf(a) - placeOf(b));
  const most = shown.reduce((high, { chart }) => Math.max(high, finite(chart)), 0);
  return {
    title: SWEEP_CHART.title,
    description: SWEEP_CHART.about,
    xName: SWEEP_CHART.t,
    x: fixedScale(
      LEAST,
      MOST,
      TICKS.map((value) => ({ value, text: bound(value) })),
    ),
    y: linearScale(most, 4),
    series: seriesOf(shown),
    columns: columnsOf(shown, choose),
    current: Math.min(MOST, Math.max(LEAST, current)),
    table: {
      head: [SWEEP_CHART.t, SWEEP_CHART.title, VALIDITY.column],
      rows: points.map(({ t, chart }) => [
        bound(t),
        chart ? measure(chart.angularDistortion) : SWEEP_CHART.notPossible,
        chart?.valid ? SWEEP_CHART.yes : SWEEP_CHART.no,
      ]),
    },
  };
}

/** Always the same three names, so that the legend does not move. */
function seriesOf(shown: Drawn[]): Series[] {
  const numbers = shown.filter(({ t }) => t !== 'auto');
  const series = (
    name: string,
    color: Series['color'],
    shape: Series['shape'],
    points: Drawn[],
  ): Series => ({ name, color, shape, hasLine: false, marks: points.map(markOf) });
  return [
    series(
      VALIDITY.valid,
      'first',
      'filled',
      numbers.filter(({ chart }) => chart.valid),
    ),
    series(
      VALIDITY.notValid,
      'second',
      'hollow',
      numbers.filter(({ chart }) => !chart.valid),
    ),
    series(
      SWEEP_CHART.auto,
      'third',
      'diamond',
      shown.filter(({ t }) => t === 'auto'),
    ),
  ];
}

function columnsOf(shown: Drawn[], choose: (t: Bound) => void): Column[] {
  return shown.map((point) => ({
    ...markOf(point),
    text: textOf(point),
    select: () => choose(point.t),
  }));
}

function markOf({ t, chart }: Drawn): Mark {
  return { x: placeOf({ t, chart }), y: finite(chart) };
}

function textOf({ t, chart }: Drawn): string {
  const verdict = chart.valid ? VALIDITY.valid : chart.problem.replace(/[.;].*$/, '');
  return SWEEP_CHART.point(t, chart.angularDistortion, verdict);
}

/** Values of 2 and above all mean free. */
function placeOf({ chart }: Drawn): number {
  return Math.min(MOST, chart.t);
}

function finite({ angularDistortion }: ChartReport): number {
  return Number.isFinite(angularDistortion) ? angularDistortion : 0;
}
