import { ChartNeighbours, type ColoredAtlas } from './chart-neighbours';

/** How many colours there are: --chart-0 and so on in the style sheet. */
export const CHART_COLORS = 9;

/**
 * A colour number for each chart. Charts that share an edge of the surface get different colours
 * and, as far as the colours suffice, so do charts that touch at a point or lie side by side in the
 * layout. `kept`: the colours of charts that have one already; -1 for others.
 */
export function chartColors(atlas: ColoredAtlas, kept?: Float32Array): Float32Array {
  const colors = kept?.slice() ?? new Float32Array(atlas.chartCount).fill(-1);
  if (colors.every((color) => color >= 0)) return colors;
  const near = new ChartNeighbours(atlas);
  const uses = new Array<number>(CHART_COLORS).fill(0);
  for (const color of colors) if (color >= 0) uses[color] += 1;
  for (const chart of coloringOrder(near.byEdge)) {
    if (colors[chart] >= 0) continue;
    const costs = [near.byEdge, near.byPoint, near.inLayout].map((neighbours) => {
      const taken = new Array<number>(CHART_COLORS).fill(0);
      for (const other of neighbours[chart]) if (colors[other] >= 0) taken[colors[other]] += 1;
      return taken;
    });
    const order = [...costs, uses];
    let best = 0;
    for (let c = 1; c < CHART_COLORS; ++c) if (isLess(order, c, best)) best = c;
    colors[chart] = best;
    uses[best] += 1;
  }
  return colors;
}

/** Whether colour `a` is better than `b`, decided by the first list in which they differ. */
function isLess(lists: number[][], a: number, b: number): boolean {
  const found = lists.find((list) => list[a] !== list[b]);
  return found !== undefined && found[a] < found[b];
}

/**
 * Puts the chart with the fewest neighbours last, and so on with the remaining ones, so that no
 * chart has many neighbours before it: at most 5 on a sphere, at most 8 on a surface with three
 * handles.
 */
function coloringOrder(neighbours: Set<number>[]): number[] {
  const degrees = neighbours.map(({ size }) => size);
  const buckets: number[][] = [];
  const put = (chart: number) => {
    buckets[degrees[chart]] ??= [];
    buckets[degrees[chart]].push(chart);
  };
  for (let chart = 0; chart < degrees.length; ++chart) put(chart);
  const isTaken = new Uint8Array(degrees.length);
  const order: number[] = [];
  for (let degree = 0; order.length < degrees.length; ) {
    const chart = buckets[degree]?.pop();
    if (chart === undefined) {
      degree += 1;
      continue;
    }
    if (isTaken[chart] || degrees[chart] !== degree) continue;
    isTaken[chart] = 1;
    order.push(chart);
    for (const other of neighbours[chart]) {
      if (isTaken[other]) continue;
      degrees[other] -= 1;
      put(other);
    }
    degree = Math.max(0, degree - 1);
  }
  return order.reverse();
}
