import { middleOf } from '../arrange/charts';
import type { GestureKind } from '../arrange/gesture';
import { type Motion, STILL, turned } from '../arrange/motion';
import { element } from '../base/dom';
import { DensityField } from '../controls/density-field';
import type { ChartList } from '../model/arrangeable';
import { Aim, type Modifiers } from '../view/aim';
import type { ChartStates, StackedCharts } from '../view/chart-flags';
import type { Pixel } from '../view/sight';
import type { ViewName, Views } from '../view/views';
import { SELECTION } from '../words/selection';
import type { Arranged } from '../workshop/workshop';
import { type ArrangeName, densityText, isGesture, isName, movedText } from './arrange-words';
import { ChartSelection } from './chart-selection';
import { type Movable, Mover } from './mover';
import type { PinTool } from './pin-tool';
import { SelectionBar } from './selection-bar';

export interface SelectionEvents {
  /** Whether a click on the mesh is free to select: no seam tool takes it. */
  isFree(): boolean;
  /** Other charts are selected or hidden. */
  changed(states: ChartStates): void;
  /** The charts of the atlas on screen that stay where they are. */
  staying(): ReadonlySet<number>;
  /** Those that stay because the file has them there. */
  keptUvs(): ReadonlySet<number>;
  /** The texel density that each chart asks for, relative to the others; null where nothing is asked for. */
  densities(): ArrayLike<number> | null;
  /** Charts are to be moved; `what` has been done to them. */
  arranged(arranged: Arranged, what: string): void;
  say(text: string): void;
}

const QUARTER = Math.PI / 2;
const NO_CHARTS: ReadonlySet<number> = new Set();

/** Lets the user select charts in either view, and frame, isolate, hide and move them. */
export class SelectionPanel {
  readonly selection = new ChartSelection(() => this.show());
  private readonly bar: SelectionBar;
  private readonly density: DensityField;
  private readonly densityLabel = element('selection-density-label', HTMLElement);
  private readonly mover: Mover;
  private report: ChartList | null = null;

  constructor(
    private readonly views: Views,
    private readonly pins: PinTool,
    private readonly events: SelectionEvents,
  ) {
    const pickNone = () => this.selection.pickNone();
    this.bar = new SelectionBar({
      frame: () => this.frame(),
      isolate: () => this.isolate(),
      hide: () => this.selection.hide(),
      showAll: () => this.selection.showAll(),
      pickNone,
      arrange: (how) => isName(how) && this.arrange(how),
    });
    this.density = new DensityField(
      element('selection-density', HTMLInputElement),
      (density) => this.setDensity(density, this.selection.selected),
      events.say,
    );
    this.mover = new Mover(views, {
      movableAt: (at) => (pins.isActive ? pins.movableAt(at) : this.chartsAt(at)),
      resolution: () => this.report?.atlas.resolution ?? 1,
      shows: (text) => this.showGesture(text),
    });
    for (const name of ['mesh', 'layout'] as const) this.bind(name);
    window.addEventListener('keydown', ({ key }) => {
      if (key === 'Escape' && this.selection.selected.size > 0) pickNone();
    });
  }

  /** The charts of another atlas; null for a layout in one piece. The same charts stay selected. */
  open(report: ChartList | null): void {
    const isSame = hasSameCharts(report, this.report);
    this.report = report;
    if (!isSame) {
      this.mover.cancel();
      this.selection.clear();
    }
    this.selection.setPlaced(invalidCharts(report), stackedIn(report));
    this.showDensity();
  }

  /** What is selected and hidden. */
  get states(): ChartStates {
    return this.selection;
  }

  /** Selects and hides these charts and no others. */
  put(selected: ReadonlySet<number>, hidden: ReadonlySet<number>): void {
    this.selection.put(selected, hidden);
  }

  /** Whether clicks and drags in the layout are for charts, and nothing is being moved. */
  get isFree(): boolean {
    return this.report !== null && !this.mover.isActive && !this.pins.isActive;
  }

  /** Selects one chart instead of the others. */
  pick(chart: number): void {
    this.selection.pick(chart, false);
  }

  private get movable(): ReadonlySet<number> {
    return this.movableOf(this.selection.selected);
  }

  private movableOf(charts: ReadonlySet<number>): ReadonlySet<number> {
    const staying = this.events.staying();
    return new Set([...charts].filter((chart) => !staying.has(chart)));
  }

  /** All that a drag of the chart at a pixel moves. */
  private chartsAt(at: Pixel): Movable | null {
    const chart = this.views.chartAt('layout', at);
    const { movable } = this;
    return chart !== null && movable.has(chart) ? this.together(movable) : null;
  }

  private together(charts: ReadonlySet<number>): Movable {
    const show = (shown: ReadonlySet<number>, motion: Motion) => {
      this.views.moveCharts(shown, motion);
      this.pins.follow(shown, motion);
    };
    return {
      middle: middleOf(this.views.boxOf(charts)),
      show: (motion) => show(charts, motion),
      putBack: () => show(NO_CHARTS, STILL),
      moved: (motion, kind) =>
        this.events.arranged(together(charts, motion), movedText(charts, kind)),
    };
  }

  private bind(name: ViewName): void {
    const canvas = this.views.canvasOf(name);
    const takesClicks = () => (name === 'layout' ? !this.pins.isActive : this.events.isFree());
    const isFree = () => this.report !== null && !this.mover.isActive && takesClicks();
    const chartAt = (at: Pixel | null) => (at && isFree() ? this.views.chartAt(name, at) : null);
    const aim = new Aim(canvas, {
      moved: (at) => this.hover(name, chartAt(at)),
      clicked: (at, { shift }: Modifiers) => {
        if (!isFree()) return;
        this.selection.pick(chartAt(at), shift);
        this.bar.uncover(canvas);
      },
    });
    this.views.onMoved(name, () => aim.refresh());
    canvas.addEventListener('keydown', (event) => this.onKey(event, name));
  }

  private hover(name: ViewName, chart: number | null): void {
    this.selection.hover(chart);
    if (name === 'layout' && this.pins.isActive) return; // which has a pointer of its own
    const isMovable = name === 'layout' && chart !== null && this.movable.has(chart);
    this.views.canvasOf(name).classList.toggle('movable', isMovable);
  }

  private onKey(event: KeyboardEvent, view: ViewName): void {
    if (!this.report || event.ctrlKey || event.metaKey) return;
    const { length } = this.report.charts;
    const actions: Record<string, () => void> = {
      '.': () => this.frame(),
      '/': () => this.isolate(),
      h: () => this.selection.hide(),
      'alt h': () => this.selection.showAll(),
      a: () => this.selection.pickAll(length),
      'alt a': () => this.selection.pickNone(),
    };
    const gestures: Record<string, () => void> = {
      g: () => this.arrange('move'),
      r: () => this.arrange('turn'),
      s: () => this.arrange('scale'),
    };
    const name = nameOf(event);
    const pin = view === 'layout' && this.pins.isActive && this.pins.aimedMovable;
    if (pin) gestures.g = () => this.mover.start('move', pin);
    const action = actions[name] ?? (view === 'layout' ? gestures[name] : undefined);
    if (!action) return;
    event.preventDefault();
    action();
  }

  private arrange(how: ArrangeName): void {
    const { movable } = this;
    if (movable.size === 0) {
      this.events.say(this.whyNoneMoves(this.selection.selected));
      return;
    }
    if (isGesture(how)) {
      this.views.canvasOf('layout').focus();
      this.mover.start(how, this.together(movable));
      return;
    }
    this.events.arranged(this.arranged(how, movable), movedText(movable, how));
  }

  private whyNoneMoves(charts: ReadonlySet<number>): string {
    if (charts.size === 0) return SELECTION.none;
    const keptUvs = this.events.keptUvs();
    const isOfFile = [...charts].every((chart) => keptUvs.has(chart));
    return isOfFile ? SELECTION.keptUvs : SELECTION.locked;
  }

  private arranged(how: Exclude<ArrangeName, GestureKind>, movable: ReadonlySet<number>): Arranged {
    const charts = Uint32Array.from(movable);
    const fixed = [...this.selection.selected].filter((chart) => !movable.has(chart));
    if (how !== 'left' && how !== 'right') return { how, charts, fixed: Uint32Array.from(fixed) };
    const middle = middleOf(this.views.boxOf(movable));
    return together(movable, turned(middle, how === 'left' ? QUARTER : -QUARTER));
  }

  /** Returns whether any of the charts can have it. */
  setDensity(density: number, charts: ReadonlySet<number>): boolean {
    const movable = this.movableOf(charts);
    if (movable.size === 0) this.events.say(this.whyNoneMoves(charts));
    else
      this.events.arranged(
        { density, charts: Uint32Array.from(movable) },
        densityText(movable, density),
      );
    return movable.size > 0;
  }

  private showGesture(text: string | null): void {
    // The chart under the pointer shows its own colours while it moves.
    if (text !== null) this.selection.hover(null);
    if (this.pins.isActive) this.pins.showGesture(text);
    else this.bar.showGesture(text, this.selection, this.report);
  }

  private frame(): void {
    const { selected } = this.selection;
    if (selected.size > 0) this.views.goToCharts([...selected]);
  }

  /** Again shows all. */
  private isolate(): void {
    if (this.selection.hidden.size > 0) this.selection.showAll();
    else this.selection.isolate(this.report?.charts.length ?? 0);
  }

  /** The densities of charts may have changed. */
  showDensity(): void {
    const { movable } = this;
    const asked = movable.size > 0 ? this.events.densities() : null;
    const densities = asked ? Array.from(movable, (chart) => asked[chart]) : [];
    this.densityLabel.hidden = densities.length === 0;
    this.density.update(densities);
  }

  private show(): void {
    this.views.showStates(this.selection);
    this.bar.show(this.selection, this.report);
    this.showDensity();
    this.events.changed(this.selection);
  }
}

const together = (charts: ReadonlySet<number>, motion: Motion): Arranged => ({
  charts: Uint32Array.from(charts),
  motions: Array.from(charts, () => motion),
});

const invalidCharts = (report: ChartList | null): ReadonlySet<number> =>
  new Set(report?.charts.flatMap(({ valid }, chart) => (valid ? [] : [chart])));

/** The charts that abflat has put on others. */
function stackedIn(report: ChartList | null): StackedCharts {
  const charts = [...(report?.charts ?? []).entries()];
  const stacked = charts.filter(([, { stackedOn }]) => stackedOn >= 0);
  return {
    on: new Map(stacked.map(([chart, { stackedOn }]) => [chart, stackedOn])),
    mirrored: new Set(charts.filter(([, { mirrored }]) => mirrored).map(([chart]) => chart)),
  };
}

/** Whether two atlases have the same charts, if perhaps in other places. */
function hasSameCharts(a: ChartList | null, b: ChartList | null): boolean {
  return (
    a !== null &&
    a.charts.length === b?.charts.length &&
    a.charts.every(
      ({ faces, firstFace }, i) =>
        faces === b.charts[i].faces && firstFace === b.charts[i].firstFace,
    )
  );
}

/** With Alt a Mac's keys write other letters, so the key itself counts. */
function nameOf({ altKey, key, code }: KeyboardEvent): string {
  return altKey ? `alt ${code.replace(/^Key/, '').toLowerCase()}` : key.toLowerCase();
}
