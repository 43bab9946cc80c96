import type { Color } from 'three';
import type { Motion } from '../arrange/motion';
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
  /** Charts that are being moved: only their outlines are drawn. */
  private moving: ReadonlySet<number> = new Set();

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

  /** Moves the outline of these charts; without any, all are drawn where they are. */
  move(charts: ReadonlySet<number>, { a, b, x, y }: Motion): void {
    this.outline.object.matrixAutoUpdate = false;
    this.outline.object.matrix.set(a, -b, 0, x, b, a, 0, y, 0, 0, 1, 0, 0, 0, 0, 1);
    if (charts === this.moving) return;
    this.moving = charts;
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
    const { ends, charts, hidden, selected, moving } = this;
    const isShown = (chart: number) => !hidden.has(chart) && !moving.has(chart);
    const hasAll = hidden.size === 0 && moving.size === 0;
    this.boundary.show(hasAll ? ends : edgesOfCharts(ends, charts, isShown));
    const isOutlined = (chart: number) =>
      moving.size > 0 ? moving.has(chart) : selected.has(chart) && isShown(chart);
    this.outline.show(edgesOfCharts(ends, charts, isOutlined));
  }
}
