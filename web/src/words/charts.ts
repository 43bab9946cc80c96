// The table of charts.

import { count, counted, listed, measure } from './format';

/** The columns of the charts' table. */
export const CHART_COLUMNS = {
  chart: { name: 'Island', title: 'Sort by number. Islands of the same colour never touch' },
  faces: { name: 'Faces', title: 'Number of triangles' },
  area: { name: 'Area', title: "Share of the surface's area" },
  stretch: { name: 'Stretch', title: 'Mean symmetric Dirichlet energy / 4: 1 keeps all lengths' },
  angle: { name: 'Angle', title: 'Angular distortion: mean over corners of ((x - α)/α)²' },
  valid: { name: 'Valid', title: 'No flipped triangles, no crossings' },
};

/** The table of charts, and what is said above it. */
export const CHART_LIST = {
  caption: 'Islands',
  more: (n: number) => `${counted(n, 'more island')}: sort by another column to see others.`,
  show: (chart: number) => `Show island ${chart}`,
  stacked: (others: number[]) =>
    `Stacked with ${others.length > 1 ? 'islands' : 'island'} ${listed(others.map(count))}`,
  summary: (charts: number, largest: number, cutEdges: number, stretchRatio: number) => {
    const which = charts > 1 ? ', the largest' : '';
    const sizes = `${counted(charts, 'island')}${which} of ${counted(largest, 'triangle')}`;
    const cuts = cutEdges > 0 ? `cut along ${counted(cutEdges, 'edge')}` : 'nothing was cut';
    return `${sizes}; ${cuts}; average stretch ratio ${measure(stretchRatio)}`;
  },
  aboutSummary:
    'Stretch ratio: how many times as much a triangle stretches in one direction as across it, mean over the surface; 1 keeps all angles. Stretch, above, also counts changes of size',
};

export const LOCKS = {
  column: 'Locked',
  lock: (chart: number) => `Lock island ${chart}`,
  about: 'Locked: the island keeps its shape and position, whatever else changes',
  locked: (chart: number) => `Locked island ${chart}`,
  unlocked: (chart: number) => `Unlocked island ${chart}`,
  keptUvs: 'Kept UVs stay in place; switch Keep UVs off to move them',
  summary: (locked: number, keptUvs: number) => {
    const texts = [
      ...(locked > 0 ? [`${counted(locked, 'island')} locked`] : []),
      ...(keptUvs > 0 ? [`${counted(keptUvs, 'island keeps its', 'islands keep their')} UVs`] : []),
    ];
    return texts.length > 0 ? texts.join(', ') : 'Locked islands stay in place';
  },
};
