/** Colours there are; --chart-0 and so on in the style sheet. */
export const CHART_COLORS = 10;

/**
 * A colour for every triangle, by the number of its chart: the same for all triangles of a chart, another one for charts that
 * meet in 3D as far as there are colours. `places`: which vertices are one in 3D.
 */
export function chartColors(
  indices: Uint32Array,
  chartOfTriangle: Uint32Array,
  places: Uint32Array,
): Float32Array {
  const neighbours = neighbouringCharts(indices, chartOfTriangle, places);
  const uses = new Array<number>(CHART_COLORS).fill(0);
  const colorOf = new Map<number, number>();
  // The largest first: they are seen most, and have most neighbours.
  const sizes = new Map<number, number>();
  for (const chart of chartOfTriangle) sizes.set(chart, (sizes.get(chart) ?? 0) + 1);
  const order = [...sizes.keys()].sort(
    (a, b) => (sizes.get(b) ?? 0) - (sizes.get(a) ?? 0) || a - b,
  );
  for (const chart of order) {
    const near = new Array<number>(CHART_COLORS).fill(0);
    for (const other of neighbours.get(chart) ?? []) {
      const color = colorOf.get(other);
      if (color !== undefined) near[color] += 1;
    }
    let best = 0;
    for (let c = 1; c < CHART_COLORS; ++c)
      if (near[c] < near[best] || (near[c] === near[best] && uses[c] < uses[best])) best = c;
    colorOf.set(chart, best);
    uses[best] += 1;
  }
  return Float32Array.from(chartOfTriangle, (chart) => colorOf.get(chart) ?? 0);
}

/** Charts that share a place with each chart. */
function neighbouringCharts(
  indices: Uint32Array,
  chartOfTriangle: Uint32Array,
  places: Uint32Array,
): Map<number, Set<number>> {
  const chartsAt = new Map<number, number[]>();
  indices.forEach((v, c) => {
    const chart = chartOfTriangle[Math.floor(c / 3)];
    const here = chartsAt.get(places[v]);
    if (!here) chartsAt.set(places[v], [chart]);
    else if (!here.includes(chart)) here.push(chart);
  });
  const found = new Map<number, Set<number>>();
  for (const charts of chartsAt.values())
    for (const a of charts)
      for (const b of charts) {
        if (a === b) continue;
        const known = found.get(a);
        if (known) known.add(b);
        else found.set(a, new Set([b]));
      }
  return found;
}
