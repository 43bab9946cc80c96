import type { ChartReport, DelaunayReport } from 'abflat';
import { ended, sentence } from '../words/format';
import { DISK_NOTES } from '../words/result';

/**
 * What is worth knowing about a result beyond its numbers, one sentence each: why it is not valid,
 * and what was done to get it.
 */
export function notes(chart: ChartReport): string[] {
  const all = [...(chart.problem ? [chart.problem] : []), ...chart.fallbacks];
  if (chart.bounds.length > 0) all.push(tightening(chart));
  if (chart.delaunay?.resisting.length === 0) all.push(delaunayNote(chart, chart.delaunay));
  return all.map((note) => ended(sentence(note)));
}

function delaunayNote(
  { angularDistortion }: ChartReport,
  { edges, violated, violatedBefore, angularDistortionBefore }: DelaunayReport,
): string {
  return DISK_NOTES.delaunay(
    edges,
    [violatedBefore, violated],
    [angularDistortionBefore, angularDistortion],
  );
}

function tightening({ bounds }: ChartReport): string {
  const least = bounds.reduce((low, { t }) => Math.min(low, t), Infinity);
  return DISK_NOTES.tightened(bounds.length, least);
}
