import { bent, type ChartMesh, type Coordinates } from '../arrange/chart-mesh';
import { type Motion, moved, type Point, STILL } from '../arrange/motion';
import { isMessageNext } from '../base/messages';
import type { Unwrapped } from '../model/model';
import { Aim } from '../view/aim';
import type { Bending } from '../view/bending';
import type { Pixel } from '../view/sight';
import type { Views } from '../view/views';
import { PINS } from '../words/selection';
import type { Movable } from './mover';
import { PinBar } from './pin-bar';
import {
  chartOfCorner,
  cornerNear,
  othersInChart,
  type Pins,
  pinNear,
  pointOfCorner,
  toggled,
} from './pin-set';

export interface PinEvents {
  /** The atlas on screen, with charts where they are now; null if there is none. */
  layout(): Unwrapped | null;
  /** Charts that must not change. */
  staying(): ReadonlySet<number>;
  /** Those that must not because the file has them as they are. */
  keptUvs(): ReadonlySet<number>;
  hidden(): ReadonlySet<number>;
  /** Charts as meshes of their own. */
  charts(outcome: Unwrapped, charts: Uint32Array): Promise<ChartMesh[]>;
  /** How a layout follows the first of some pinned vertices. */
  weights(layout: ChartMesh, pins: number[]): Promise<Float64Array>;
  /** Other vertices are pinned; `what` was done. */
  changed(pins: Pins, what: string): void;
  /** A chart was bent. */
  bent(change: (before: Coordinates) => Coordinates, what: string): void;
  say(text: string): void;
}

/** Css pixels. */
const REACH = { pin: 12, vertex: 16 };
const NO_PINS: Pins = new Uint32Array();
const NO_CHARTS: ReadonlySet<number> = new Set();
const STAYS: Point = [0, 0];

/** Lets the user pin vertices of the layout, and bend charts by dragging the pins. */
export class PinTool {
  private isOn = false;
  private pins: Pins = NO_PINS;
  /** A corner of the vertex that a click would hit. */
  private aimed: number | null = null;
  /** The pin that is being dragged, and how far in uv. */
  private dragged: { corner: number; by: Point } | null = null;
  private gesture: string | null = null;
  /** What the last drag has asked for: the next one may need the same. */
  private prepared: { name: unknown[]; bending: Promise<Bending> } | null = null;
  private readonly bar: PinBar;

  constructor(
    private readonly views: Views,
    private readonly events: PinEvents,
  ) {
    this.bar = new PinBar({ toggle: () => this.toggle(), removeAll: () => this.removeAll() });
    const canvas = views.canvasOf('layout');
    const aim = new Aim(canvas, {
      moved: (at) => this.aimAt(at),
      clicked: (at) => this.click(at),
    });
    views.onMoved('layout', () => aim.refresh());
    canvas.addEventListener('keydown', (event) => this.onKey(event));
  }

  get all(): Pins {
    return this.pins;
  }

  get isActive(): boolean {
    return this.isOn;
  }

  /** Shows the pins of another atlas, or of the same one with charts in other places. */
  show(pins: Pins = this.pins): void {
    const corners = this.layout?.indices.length ?? 0;
    this.pins = pins.filter((corner) => corner < corners);
    this.aimed = null;
    this.dragged = null;
    this.draw();
  }

  /** Shows the pins of some charts as if those were moved. */
  follow(charts: ReadonlySet<number>, motion: Motion): void {
    this.draw((corner, at) =>
      this.layout && charts.has(chartOfCorner(this.layout, corner)) ? moved(motion, at) : at,
    );
  }

  /** What a drag from here moves. */
  movableAt(at: Pixel): Movable | null {
    return this.movable(this.pinAt(at));
  }

  /** The pin that the user aims at, to be moved by keys. */
  get aimedMovable(): Movable | null {
    const { aimed } = this;
    return this.movable(aimed !== null && this.pins.includes(aimed) ? aimed : null);
  }

  /** Shows what a gesture does so far; null: it has ended. */
  showGesture(text: string | null): void {
    this.gesture = text;
    this.showBar();
  }

  private get layout() {
    return this.events.layout()?.result ?? null;
  }

  /** Null if there is no pin, or it must not be moved now. */
  private movable(corner: number | null): Movable | null {
    const outcome = this.events.layout();
    if (corner === null || !outcome || this.dragged) return null;
    if (this.stays(outcome, corner)) {
      const isOfFile = this.events.keptUvs().has(chartOfCorner(outcome.result, corner));
      this.events.say(isOfFile ? PINS.keptUvs : PINS.locked);
      return null;
    }
    const middle = pointOfCorner(outcome.result, corner);
    const bending = this.bending(outcome, corner);
    let ready: Bending | null = null;
    const show = (by: Point) => {
      this.dragged = { corner, by };
      if (ready) this.views.bendChart(ready, by);
      this.draw();
    };
    bending.then(
      (made) => {
        ready = made;
        if (this.dragged?.corner === corner) show(this.dragged.by);
      },
      () => undefined, // said when the drag has ended
    );
    return {
      middle,
      show: ({ x, y }) => show([x, y]),
      putBack: () => this.putBack(),
      moved: ({ x, y }) => void this.place(bending, [x, y]),
    };
  }

  private stays({ result }: Unwrapped, corner: number): boolean {
    return this.events.staying().has(chartOfCorner(result, corner));
  }

  private async place(bending: Promise<Bending>, by: Point): Promise<void> {
    try {
      const { mesh, weights, chart } = await bending;
      this.events.bent((before) => bent(before, mesh, weights, by), PINS.moved(chart));
    } catch (error) {
      this.putBack();
      this.events.say(PINS.notMoved((error as Error).message));
    }
  }

  private putBack(): void {
    this.dragged = null;
    this.views.moveCharts(NO_CHARTS, STILL);
    this.draw();
  }

  /** How the chart of a pin follows it. */
  private bending(outcome: Unwrapped, corner: number): Promise<Bending> {
    const name = [outcome.result, this.pins, corner];
    if (this.prepared?.name.every((each, i) => each === name[i])) return this.prepared.bending;
    const bending = this.makeBending(outcome, corner);
    this.prepared = { name, bending };
    bending.catch(() => {
      if (this.prepared?.bending === bending) this.prepared = null;
    });
    return bending;
  }

  private async makeBending(outcome: Unwrapped, corner: number): Promise<Bending> {
    const { result } = outcome;
    const chart = chartOfCorner(result, corner);
    const corners = [corner, ...othersInChart(this.pins, result, corner)];
    const [mesh] = await this.events.charts(outcome, Uint32Array.of(chart));
    const numbers = corners.map((each) => mesh.vertices.indexOf(result.indices[each]));
    return { chart, mesh, weights: await this.events.weights(mesh, numbers) };
  }

  private toggle(): void {
    this.isOn = !this.isOn;
    this.aimed = null;
    this.draw();
    if (this.isOn) this.views.canvasOf('layout').focus();
  }

  private removeAll(): void {
    const { length } = this.pins;
    this.change(NO_PINS, PINS.removedAll(length));
  }

  private change(pins: Pins, what: string): void {
    this.pins = pins;
    this.draw();
    this.events.changed(pins, what);
  }

  private aimAt(at: Pixel | null): void {
    if (!this.isOn || this.dragged) return;
    const outcome = this.events.layout();
    const pin = at && this.pinAt(at);
    const aimed = pin ?? (at && this.cornerAt(at));
    this.views.canvasOf('layout').classList.toggle('movable', pin !== null);
    // So that it follows at once when it is dragged.
    if (pin !== null && outcome && !this.stays(outcome, pin)) void this.bending(outcome, pin);
    if (aimed === this.aimed) return;
    this.aimed = aimed;
    this.draw();
  }

  private click(at: Pixel): void {
    const { layout } = this;
    if (!this.isOn || !layout || this.dragged) return;
    const corner = this.pinAt(at) ?? this.cornerAt(at);
    if (corner === null) return;
    this.aimed = corner; // keys aim at nothing before
    const chart = chartOfCorner(layout, corner);
    const pins = toggled(this.pins, layout, corner);
    const isMore = pins.length > this.pins.length;
    this.change(pins, isMore ? PINS.pinned(chart) : PINS.removed(chart));
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.layout) return;
    const leaves = this.isOn && event.key === 'Escape' && !isMessageNext();
    if (!leaves && event.key.toLowerCase() !== 'p') return;
    event.preventDefault();
    event.stopPropagation();
    this.toggle();
  }

  private pinAt(at: Pixel): number | null {
    const reach = REACH.pin / this.views.pixelsPerUv;
    const { layout } = this;
    return layout && pinNear(this.pins, layout, this.events.hidden(), this.views.uvAt(at), reach);
  }

  private cornerAt(at: Pixel): number | null {
    const reach = REACH.vertex / this.views.pixelsPerUv;
    const { layout } = this;
    return layout && cornerNear(layout, this.events.hidden(), this.views.uvAt(at), reach);
  }

  private draw(placed = (_: number, at: Point): Point => at): void {
    const { layout, dragged, aimed } = this;
    this.showBar();
    if (!layout) {
      this.views.showPins([], null);
      return;
    }
    const points = [...this.pins].map((corner) => {
      const [u, v] = pointOfCorner(layout, corner);
      const [x, y] = corner === dragged?.corner ? dragged.by : STAYS;
      return placed(corner, [u + x, v + y]);
    });
    const isAiming = this.isOn && aimed !== null && !dragged;
    this.views.showPins(points, isAiming ? pointOfCorner(layout, aimed) : null);
  }

  private showBar(): void {
    this.bar.show(this.isOn, this.layout !== null, this.pins.length, this.gesture);
  }
}
