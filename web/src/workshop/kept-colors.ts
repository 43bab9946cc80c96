/** Charts keep their colours as long as they have the same triangles, however they are moved. */
export class KeptColors {
  private charts: Uint32Array | null = null;
  private colors: Float32Array | null = null;

  /** The colours of charts that were drawn last; undefined if those were others. */
  of(chartOfTriangle: Uint32Array, chartCount: number): Float32Array | undefined {
    const { charts, colors } = this;
    if (!charts || colors?.length !== chartCount || charts.length !== chartOfTriangle.length)
      return undefined;
    for (let f = 0; f < charts.length; ++f) if (charts[f] !== chartOfTriangle[f]) return undefined;
    return colors;
  }

  keep(chartOfTriangle: Uint32Array, colors: Float32Array | null): void {
    this.charts = chartOfTriangle;
    this.colors = colors;
  }
}
