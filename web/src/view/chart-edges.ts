import type { Color } from 'three';
import type { Motion } from '../arrange/motion';
import { type ChartStates, NO_STATES } from './chart-flags';
import { EdgeLines } from './edge-lines';
import { edgesOfCharts } from './edges-of-charts';

/** Css pixels. */
const OUTLINE = 3;

/** Draws the boundary edges of charts: hidden charts have none, selected and invalid ones an outline as well. */
export class ChartEdges {
  readonly boundary: EdgeLines;
  private readonly outline: EdgeLines;
  private readonly invalid: EdgeLines;
  private ends: Float32Array = new Float32Array();
  private charts: Uint32Array = new Uint32Array();
  private states: ChartStates = NO_STATES;
  /** Charts that are being moved: only their outlines are drawn. */
  private moving: ReadonlySet<number> = new Set();

  /** `width`: of the boundary, in css pixels. */
  constructor(width: number, depthTest: boolean) {
    this.boundary = new EdgeLines(width, depthTest);
    this.invalid = new EdgeLines(OUTLINE, depthTest);
    this.outline = new EdgeLines(OUTLINE, depthTest);
  }

  get objects() {
    return [this.boundary.object, this.invalid.object, this.outline.object];
  }

  /** `charts` has the chart of each edge; empty for a layout in one piece. */
  show(ends: Float32Array, charts: Uint32Array): void {
    this.ends = ends;
    this.charts = charts;
    this.draw();
  }

  showStates({ hidden, selected, hovered, invalid, stacked }: ChartStates): void {
    const { states } = this;
    const isSame = hidden === states.hidden && selected === states.selected;
    if (isSame && invalid === states.invalid) return;
    this.states = { hidden, selected, hovered, invalid, stacked };
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

  /** Draws these edges in place of those of some charts, until `move` ends it. */
  replace(charts: ReadonlySet<number>, ends: Float32Array): void {
    this.outline.object.matrixAutoUpdate = false;
    this.outline.object.matrix.identity();
    if (charts !== this.moving) {
      this.moving = charts;
      this.draw();
    }
    this.outline.show(ends);
  }

  /** Of the outlines of selected and of invalid charts. */
  setColors(selected: Color, invalid: Color): void {
    this.outline.setColor(selected);
    this.invalid.setColor(invalid);
  }

  setResolution(width: number, height: number): void {
    this.boundary.setResolution(width, height);
    this.outline.setResolution(width, height);
    this.invalid.setResolution(width, height);
  }

  private draw(): void {
    const { ends, charts, moving } = this;
    const { hidden, selected, invalid } = this.states;
    const isShown = (chart: number) => !hidden.has(chart) && !moving.has(chart);
    const hasAll = hidden.size === 0 && moving.size === 0;
    this.boundary.show(hasAll ? ends : edgesOfCharts(ends, charts, isShown));
    const isOutlined = (chart: number) =>
      moving.size > 0 ? moving.has(chart) : selected.has(chart) && isShown(chart);
    this.outline.show(edgesOfCharts(ends, charts, isOutlined));
    const isInvalid = (chart: number) => invalid.has(chart) && isShown(chart);
    this.invalid.show(edgesOfCharts(ends, charts, isInvalid));
  }
}
