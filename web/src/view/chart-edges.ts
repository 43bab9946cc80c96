import type { Color } from 'three';
import type { ChartStates } from './chart-flags';
import { EdgeLines } from './edge-lines';
import { edgesOfCharts } from './edges-of-charts';

/** Css pixels. */
const OUTLINE = 3;

/** Draws the boundary edges of charts: hidden charts have none, selected ones an outline as well. */
export class ChartEdges {
  readonly boundary: EdgeLines;
  private readonly outline: EdgeLines;
  private ends: Float32Array = new Float32Array();
  private charts: Uint32Array = new Uint32Array();
  private hidden: ReadonlySet<number> = new Set();
  private selected: ReadonlySet<number> = new Set();

  /** `width`: of the boundary, in css pixels. */
  constructor(width: number, depthTest: boolean) {
    this.boundary = new EdgeLines(width, depthTest);
    this.outline = new EdgeLines(OUTLINE, depthTest);
  }

  get objects() {
    return [this.boundary.object, this.outline.object];
  }

  /** `charts` has the chart of each edge; empty for a layout in one piece. */
  show(ends: Float32Array, charts: Uint32Array): void {
    this.ends = ends;
    this.charts = charts;
    this.draw();
  }

  showStates({ hidden, selected }: ChartStates): void {
    if (hidden === this.hidden && selected === this.selected) return;
    this.hidden = hidden;
    this.selected = selected;
    this.draw();
  }

  setOutlineColor(color: Color): void {
    this.outline.setColor(color);
  }

  setResolution(width: number, height: number): void {
    this.boundary.setResolution(width, height);
    this.outline.setResolution(width, height);
  }

  private draw(): void {
    const { ends, charts, hidden, selected } = this;
    const isShown = (chart: number) => !hidden.has(chart);
    this.boundary.show(hidden.size > 0 ? edgesOfCharts(ends, charts, isShown) : ends);
    const isOutlined = (chart: number) => selected.has(chart) && isShown(chart);
    this.outline.show(edgesOfCharts(ends, charts, isOutlined));
  }
}
