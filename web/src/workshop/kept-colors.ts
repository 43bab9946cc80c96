/** In place of a chart: there is no triangle yet, or there are some of several charts. */
const NONE = -1;
const MIXED = -2;

/** Charts keep their colours as long as they have the same triangles, whatever becomes of the others. */
export class KeptColors {
  private charts: Uint32Array | null = null;
  private colors: Float32Array | null = null;

  /** The colour of each chart that was drawn last with the same triangles, -1 for others; undefined if there are none. */
  of(chartOfTriangle: Uint32Array, chartCount: number): Float32Array | undefined {
    const { charts, colors } = this;
    if (!charts || !colors || charts.length !== chartOfTriangle.length) return undefined;
    const sizes = sizesOf(charts, colors.length);
    const sizesNow = sizesOf(chartOfTriangle, chartCount);
    const before = new Int32Array(chartCount).fill(NONE);
    chartOfTriangle.forEach((chart, f) => {
      if (chart >= chartCount) return;
      const isSame = before[chart] === NONE || before[chart] === charts[f];
      before[chart] = isSame ? charts[f] : MIXED;
    });
    return Float32Array.from(before, (chart, i) =>
      chart >= 0 && sizes[chart] === sizesNow[i] ? colors[chart] : -1,
    );
  }

  keep(chartOfTriangle: Uint32Array, colors: Float32Array | null): void {
    this.charts = chartOfTriangle;
    this.colors = colors;
  }
}

/** The triangles of each chart. */
function sizesOf(charts: Uint32Array, count: number): Uint32Array {
  const sizes = new Uint32Array(count);
  for (const chart of charts) if (chart < count) sizes[chart] += 1;
  return sizes;
}
