import type { ChartReport, DelaunayReport } from 'abflat';
import { bound, count, counted, measure, sentence } from '../base/format';

/**
 * What is worth knowing about a result beyond its numbers, one sentence each: why it is not valid,
 * and what was done to get it.
 */
export function notes(chart: ChartReport): string[] {
  const all = [...(chart.problem ? [chart.problem] : []), ...chart.fallbacks];
  if (chart.bounds.length > 0) all.push(tightening(chart));
  if (chart.delaunay?.resisting.length === 0) all.push(delaunayNote(chart, chart.delaunay));
  return all.map((note) => `${sentence(note).replace(/\.$/, '')}.`);
}

function delaunayNote(
  { angularDistortion }: ChartReport,
  { edges, violated, violatedBefore, angularDistortionBefore }: DelaunayReport,
): string {
  const before = `${count(violatedBefore)} of ${counted(edges, 'interior edge')} before`;
  const change = `angular distortion ${measure(angularDistortionBefore)} before, ${measure(angularDistortion)} now`;
  return `edges that are not Delaunay: ${before}, ${count(violated)} now; ${change}`;
}

function tightening({ bounds }: ChartReport): string {
  const least = bounds.reduce((low, { t }) => Math.min(low, t), Infinity);
  const vertices = counted(bounds.length, 'boundary vertex was', 'boundary vertices were');
  return `${vertices} tightened, ${bounds.length === 1 ? '' : 'down '}to t\u00a0=\u00a0${bound(least)}`;
}
