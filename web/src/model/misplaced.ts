// How abflat says that a chart of an atlas is in the wrong place.

import type { UnwrapReport } from 'abflat';

const OUTSIDE = /it extends beyond its tile/;
const OVERLAPPING = /it touches or overlaps the chart/;

export const isOutside = (problem: string) => OUTSIDE.test(problem);
export const isOverlapping = (problem: string) => OVERLAPPING.test(problem);

/** Whether nothing is wrong but where charts are, and packing moves one of them. */
export function isMisplaced({ charts }: UnwrapReport): boolean {
  const bad = charts.filter(({ valid }) => !valid);
  return (
    bad.every(({ problem }) => isOutside(problem) || isOverlapping(problem)) &&
    bad.some(({ solver, fixed }) => fixed && solver === 'known')
  );
}
