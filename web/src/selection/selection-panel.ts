import type { UnwrapReport } from 'abflat';
import { Aim, type Modifiers } from '../view/aim';
import type { Pixel } from '../view/sight';
import type { ViewName, Views } from '../view/views';
import { ChartSelection } from './chart-selection';
import { SelectionBar } from './selection-bar';

export interface SelectionEvents {
  /** Whether a click on the mesh is free to select: no seam tool takes it. */
  isFree(): boolean;
  /** The selection has changed. */
  changed(selected: ReadonlySet<number>): void;
}

/** Lets the user select charts in either view, and frame, isolate and hide them. */
export class SelectionPanel {
  private readonly selection = new ChartSelection(() => this.show());
  private readonly bar: SelectionBar;
  private report: UnwrapReport | null = null;

  constructor(
    private readonly views: Views,
    private readonly events: SelectionEvents,
  ) {
    const pickNone = () => this.selection.pickNone();
    this.bar = new SelectionBar({
      frame: () => this.frame(),
      isolate: () => this.isolate(),
      hide: () => this.selection.hide(),
      showAll: () => this.selection.showAll(),
      pickNone,
    });
    for (const name of ['mesh', 'layout'] as const) this.bind(name);
    window.addEventListener('keydown', ({ key }) => {
      if (key === 'Escape' && this.selection.selected.size > 0) pickNone();
    });
  }

  /** The charts of another atlas; null for a layout in one piece. */
  open(report: UnwrapReport | null): void {
    this.report = report;
    this.selection.clear();
  }

  /** Selects one chart instead of the others. */
  pick(chart: number): void {
    this.selection.pick(chart, false);
  }

  private bind(name: ViewName): void {
    const canvas = this.views.canvasOf(name);
    const isFree = () => this.report !== null && (name === 'layout' || this.events.isFree());
    const chartAt = (at: Pixel | null) => (at && isFree() ? this.views.chartAt(name, at) : null);
    const aim = new Aim(canvas, {
      moved: (at) => this.selection.hover(chartAt(at)),
      clicked: (at, { shift }: Modifiers) => {
        if (isFree()) this.selection.pick(chartAt(at), shift);
      },
    });
    this.views.onMoved(name, () => aim.refresh());
    canvas.addEventListener('keydown', (event) => this.onKey(event));
  }

  private onKey(event: KeyboardEvent): void {
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
    const action = actions[nameOf(event)];
    if (!action) return;
    event.preventDefault();
    action();
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

  private show(): void {
    this.views.showStates(this.selection);
    this.bar.show(this.selection, this.report);
    this.events.changed(this.selection.selected);
  }
}

/** With Alt a Mac's keys write other letters, so the key itself counts. */
function nameOf({ altKey, key, code }: KeyboardEvent): string {
  return altKey ? `alt ${code.replace(/^Key/, '').toLowerCase()}` : key.toLowerCase();
}
