import { type ChartStates, NO_STATES, type StackedCharts } from '../view/chart-flags';

const NONE = NO_STATES.selected;

/** Which charts of the atlas on screen are selected, hidden and pointed at. */
export class ChartSelection implements ChartStates {
  /** Sets are replaced, never changed: who shows them sees by that whether there is anything to do. */
  private picked = NONE;
  private away = NONE;
  private pointed: number | null = null;
  private bad = NONE;
  private above = NO_STATES.stacked;

  constructor(private readonly changed: () => void) {}

  get selected(): ReadonlySet<number> {
    return this.picked;
  }

  get hidden(): ReadonlySet<number> {
    return this.away;
  }

  get hovered(): number | null {
    return this.pointed;
  }

  get invalid(): ReadonlySet<number> {
    return this.bad;
  }

  get stacked(): StackedCharts {
    return this.above;
  }

  /** Charts that are not valid where they are, and those that lie on others. */
  setPlaced(invalid: ReadonlySet<number>, stacked: StackedCharts): void {
    this.bad = invalid.size > 0 ? invalid : NONE;
    this.above = stacked.on.size > 0 ? stacked : NO_STATES.stacked;
    this.changed();
  }

  clear(): void {
    this.picked = NONE;
    this.away = NONE;
    this.pointed = null;
    this.changed();
  }

  hover(chart: number | null): void {
    if (chart === this.pointed) return;
    this.pointed = chart;
    this.changed();
  }

  /** Selects one chart instead of all others, or with `adds` beside them; again takes it back. */
  pick(chart: number | null, adds: boolean): void {
    const picked = new Set(adds ? this.picked : []);
    if (chart !== null && !picked.delete(chart)) picked.add(chart);
    this.picked = picked;
    this.changed();
  }

  /** `count` charts: all that are not hidden. */
  pickAll(count: number): void {
    this.pickSome(Array(count).keys());
  }

  /** Those of some charts that are not hidden, instead of all others or with `adds` beside them. */
  pickSome(charts: Iterable<number>, adds = false): void {
    const all = [...(adds ? this.picked : []), ...charts];
    this.picked = new Set(all.filter((chart) => !this.away.has(chart)));
    this.changed();
  }

  pickNone(): void {
    this.pick(null, false);
  }

  hide(): void {
    this.away = new Set([...this.away, ...this.picked]);
    this.picked = new Set();
    this.pointed = null;
    this.changed();
  }

  /** Hides all of `count` charts but the selected ones. */
  isolate(count: number): void {
    if (this.picked.size === 0) return;
    const all = Array.from({ length: count }, (_, chart) => chart);
    this.away = new Set(all.filter((chart) => !this.picked.has(chart)));
    this.changed();
  }

  showAll(): void {
    this.away = new Set();
    this.changed();
  }

  /** Selects and hides these charts and no others. */
  put(selected: ReadonlySet<number>, hidden: ReadonlySet<number>): void {
    this.picked = selected;
    this.away = hidden;
    this.changed();
  }
}
