import type { UnwrapChart, UnwrapReport } from 'abflat';
import { CHART_COLUMNS } from '../words/charts';
import { brief, count, distortion, measure } from '../words/format';

/** A chart as a row of a table. */
export interface ChartRow {
  /** Its index in the report. */
  index: number;
  chart: UnwrapChart;
  /** Share of the surface's area. */
  share: number;
}

export interface ChartColumn {
  name: string;
  title: string;
  /** What rows are sorted by. */
  key(row: ChartRow): number;
  text(row: ChartRow): string;
}

/** Which column rows are sorted by. */
export interface Order {
  column: number;
  descending: boolean;
}

export const COLUMNS: ChartColumn[] = [
  {
    ...CHART_COLUMNS.chart,
    key: ({ index }) => index,
    text: ({ index }) => count(index),
  },
  {
    ...CHART_COLUMNS.faces,
    key: ({ chart }) => chart.faces,
    text: ({ chart }) => count(chart.faces),
  },
  {
    ...CHART_COLUMNS.area,
    key: ({ share }) => share,
    text: ({ share }) =>
      `${share < 0.0995 ? (100 * share).toPrecision(2) : (100 * share).toFixed(1)}\u202f%`,
  },
  {
    ...CHART_COLUMNS.stretch,
    key: ({ chart }) => chart.symmetricDirichlet,
    text: ({ chart }) => fixed(chart.symmetricDirichlet),
  },
  {
    ...CHART_COLUMNS.angle,
    key: ({ chart }) => chart.angularDistortion,
    text: ({ chart }) => distortion(chart.angularDistortion, brief),
  },
  {
    ...CHART_COLUMNS.valid,
    key: ({ chart }) => Number(!chart.valid),
    text: ({ chart }) => (chart.valid ? '\u2713' : '\u2717'),
  },
];

export function chartRows({ charts }: UnwrapReport): ChartRow[] {
  const total = charts.reduce((sum, { area }) => sum + (area ?? 0), 0);
  return charts.map((chart, index) => ({
    index,
    chart,
    share: total > 0 ? (chart.area ?? 0) / total : 0,
  }));
}

/** Equal rows keep the order of the report; NaN comes last. */
export function sortedRows(rows: ChartRow[], { column, descending }: Order): ChartRow[] {
  const sign = descending ? -1 : 1;
  const { key } = COLUMNS[column];
  return [...rows].sort((a, b) => {
    const [x, y] = [key(a), key(b)];
    if (!(Number.isFinite(x) && Number.isFinite(y)))
      return Number(!Number.isFinite(x)) - Number(!Number.isFinite(y)) || a.index - b.index;
    return sign * (x - y) || a.index - b.index;
  });
}

/** Three decimals below 10: near 1, the third one tells charts apart. */
function fixed(x: number): string {
  return Number.isFinite(x) && x < 10 ? x.toFixed(3) : measure(x);
}
