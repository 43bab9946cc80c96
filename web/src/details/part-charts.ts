// What becomes of the selection when the charts of a part are selected, hidden or isolated.

import type { NamedPart } from '../model/named-parts';
import type { ChartStates } from '../view/chart-flags';

type Charts = ReadonlySet<number>;
type States = Pick<ChartStates, 'selected' | 'hidden'>;

/** All with a triangle of the part. */
export function chartsOf({ runs }: NamedPart, chartOfTriangle: Uint32Array, count: number): Charts {
  const has = new Uint8Array(count);
  for (const [first, length] of runs)
    for (let f = first; f < first + length; ++f) has[chartOfTriangle[f]] = 1;
  return new Set(allOf(count).filter((chart) => has[chart]));
}

/** With `adds` beside what is selected, or away from it if they all are. */
export function selecting(charts: Charts, adds: boolean, { selected, hidden }: States): States {
  if (!adds) return { selected: charts, hidden };
  const isTaken = isWithin(charts, selected);
  return { selected: isTaken ? without(selected, charts) : both(selected, charts), hidden };
}

/** Again shows them. */
export function hiding(charts: Charts, { selected, hidden }: States): States {
  if (isWithin(charts, hidden)) return { selected, hidden: without(hidden, charts) };
  return { selected: without(selected, charts), hidden: both(hidden, charts) };
}

/** Hides all others; again shows all. `count`: of all charts. */
export function isolating(charts: Charts, count: number, { selected, hidden }: States): States {
  if (isIsolated(charts, count, hidden)) return { selected, hidden: new Set() };
  const others = without(new Set(allOf(count)), charts);
  return { selected: without(selected, others), hidden: others };
}

export const isIsolated = (charts: Charts, count: number, hidden: Charts): boolean =>
  hidden.size > 0 &&
  hidden.size === count - charts.size &&
  without(hidden, charts).size === hidden.size;

/** Not so if there are none. */
export const isWithin = (charts: Charts, all: Charts): boolean =>
  charts.size > 0 && [...charts].every((chart) => all.has(chart));

const allOf = (count: number) => Array.from({ length: count }, (_, chart) => chart);
const both = (a: Charts, b: Charts): Charts => new Set([...a, ...b]);
const without = (all: Charts, charts: Charts): Charts =>
  new Set([...all].filter((chart) => !charts.has(chart)));
