import { ChartNeighbours, type ColoredAtlas } from './chart-neighbours';

/** Colours there are; --chart-0 and so on in the style sheet. */
export const CHART_COLORS = 9;

/**
 * The number of a colour for each chart: another one for charts that share an edge of the surface, and as far as there are colours also
 * for those that touch in a point or lie side by side in the layout.
 */
export function chartColors(atlas: ColoredAtlas): Float32Array {
  const near = new ChartNeighbours(atlas);
  const colors = new Float32Array(atlas.chartCount).fill(-1);
  const uses = new Array<number>(CHART_COLORS).fill(0);
  for (const chart of coloringOrder(near.byEdge)) {
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

/** Whether colour `a` is better than `b`: by the first list in which they differ. */
function isLess(lists: number[][], a: number, b: number): boolean {
  const found = lists.find((list) => list[a] !== list[b]);
  return found !== undefined && found[a] < found[b];
}

/**
 * The chart with the fewest neighbours last, and so on with those that are left: then none has many neighbours before it. On a sphere
 * it has at most 5, on a surface with three handles at most 8.
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
