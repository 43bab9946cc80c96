import type { ChartReport } from 'abflat';
import { bound, counted, sentence } from './format';

/** What is worth knowing about a result beyond its numbers, one sentence each: why it is not valid, what was done to get it. */
export function notes(chart: ChartReport): string[] {
  const all = [...(chart.problem ? [chart.problem] : []), ...chart.fallbacks];
  if (chart.bounds.length > 0) all.push(tightening(chart));
  return all.map((note) => `${sentence(note).replace(/\.$/, '')}.`);
}

function tightening({ bounds }: ChartReport): string {
  const least = bounds.reduce((low, { t }) => Math.min(low, t), Infinity);
  const vertices = counted(bounds.length, 'boundary vertex is', 'boundary vertices are');
  return `${vertices} tightened, ${bounds.length === 1 ? '' : 'down '}to t\u00a0=\u00a0${bound(least)}`;
}
