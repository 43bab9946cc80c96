import type { ChartReport } from 'abflat';
import type { Flattened } from './model';

/** The report of a disk, whose bounds are those that were found, not those asked for. */
export function foundChart({ settings, result }: Flattened): ChartReport {
  const [chart] = result.report.charts;
  const own = new Set(settings.bounds?.map(({ vertex }) => vertex));
  return { ...chart, bounds: chart.bounds.filter(({ vertex }) => !own.has(vertex)) };
}
