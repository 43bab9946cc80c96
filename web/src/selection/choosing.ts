// Which charts of an atlas have something in common.

import type { ChartArrays } from '../arrange/charts';
import { areaOf } from '../arrange/stacks';
import type { Arrangeable } from '../model/arrangeable';
import { isOverlapping } from '../model/misplaced';

/** The charts with triangles that run clockwise. */
export function flippedCharts(arrays: ChartArrays): Set<number> {
  const found = new Set<number>();
  arrays.chartOfTriangle.forEach((chart, f) => {
    if (!found.has(chart) && areaOf(arrays, f) < 0) found.add(chart);
  });
  return found;
}

/** Those that overlap another one, which abflat names by a face, and those that share texels on purpose. */
export function overlappingCharts(outcome: Arrangeable): Set<number> {
  if (outcome.mode === 'pack') {
    const islands = [...outcome.result.report.charts.entries()];
    return new Set(islands.flatMap(([i, { lies }]) => (lies === 'apart' ? [] : i)));
  }
  const { result, stacks = [] } = outcome;
  const { charts } = result.report;
  const found = new Set(stacks.flat());
  charts.forEach(({ problem }, chart) => {
    if (!isOverlapping(problem)) return;
    found.add(chart);
    const face = Number(/containing face (\d+)/.exec(problem)?.[1]);
    const other = charts.findIndex(({ firstFace }) => firstFace === face);
    if (other >= 0) found.add(other);
  });
  return found;
}

export function stretchedCharts({ result }: Arrangeable, limit: number): Set<number> {
  const charts = [...result.report.charts.entries()];
  return new Set(
    charts.flatMap(([i, { symmetricDirichlet }]) => (symmetricDirichlet > limit ? i : [])),
  );
}

/** The charts with a part of some charts, and these; `parts`: a number per triangle. */
export function chartsWithParts(
  { chartOfTriangle }: Pick<ChartArrays, 'chartOfTriangle'>,
  parts: ArrayLike<number>,
  charts: ReadonlySet<number>,
): Set<number> {
  const wanted = new Set<number>();
  chartOfTriangle.forEach((chart, f) => {
    if (charts.has(chart)) wanted.add(parts[f]);
  });
  const found = new Set(charts);
  chartOfTriangle.forEach((chart, f) => {
    if (wanted.has(parts[f])) found.add(chart);
  });
  return found;
}
