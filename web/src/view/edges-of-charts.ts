/** The ends (xyz of both) of the edges whose chart `isWanted`; `charts` has the chart of each edge. */
export function edgesOfCharts(
  ends: Float32Array,
  charts: Uint32Array,
  isWanted: (chart: number) => boolean,
): Float32Array {
  const wanted = charts.reduce((sum, chart) => sum + (isWanted(chart) ? 1 : 0), 0);
  const found = new Float32Array(6 * wanted);
  let size = 0;
  charts.forEach((chart, e) => {
    if (!isWanted(chart)) return;
    found.set(ends.subarray(6 * e, 6 * e + 6), size);
    size += 6;
  });
  return found;
}
