import type { UnwrapReport } from 'abflat';
import { create, element } from '../base/dom';
import { loadPart, reasonOf } from '../base/load-part';
import type { Unwrapped } from '../model/model';
import type { Views } from '../view/views';
import { CHART_LIST, LOCKS } from '../words/charts';
import { atlasNotes } from './atlas-notes';
import type { ChartTable, ChartTableEvents } from './chart-table';
import type { Locks } from './locks';

const chartTables = () => loadPart(import('./chart-table'));

export interface ChartsTabEvents {
  /** A row was chosen. */
  chosen(chart: number): void;
  /** A chart was locked or unlocked; `what` says so. */
  locked(what: string): void;
  packAgain(): void;
  say(text: string): void;
}

/** What an atlas consists of and how it was made. */
export class ChartsTab {
  private readonly notes = element('atlas-notes', HTMLUListElement);
  private table: ChartTable | null = null;
  private shown: Unwrapped | null = null;
  private colors: Float32Array | null = null;
  private selected: ReadonlySet<number> = new Set();
  private readonly ofTable: ChartTableEvents;
  private readonly lockSummary = element('locks-summary', HTMLElement);
  private readonly pack = element('pack-again', HTMLButtonElement);
  private readonly summary = element('charts-summary', HTMLElement);

  /** `views` highlight the chart under the pointer. */
  constructor(
    views: Views | null,
    private readonly locks: Locks,
    private readonly events: ChartsTabEvents,
  ) {
    this.ofTable = {
      pointed: (chart) => views?.lightChart(chart),
      chosen: (chart) => {
        views?.goToCharts([chart]);
        events.chosen(chart);
      },
      locked: (chart) => {
        if (locks.keptUvs.has(chart)) {
          events.say(LOCKS.keptUvs);
          return;
        }
        locks.toggle(chart);
        this.showLocks();
        events.locked(locks.charts.has(chart) ? LOCKS.locked(chart) : LOCKS.unlocked(chart));
      },
    };
    this.pack.addEventListener('click', () => events.packAgain());
  }

  show(outcome: Unwrapped, colors: Float32Array | null): void {
    const lines = atlasNotes(outcome);
    const { report } = outcome.result;
    this.notes.replaceChildren(...lines.map((line) => create('li', '', line)));
    this.notes.hidden = lines.length === 0;
    this.summary.textContent = summary(report);
    this.summary.title = CHART_LIST.aboutSummary;
    this.shown = outcome;
    this.colors = colors;
    if (this.table) this.list(this.table);
    else void this.load();
    this.showLocks();
    this.pack.disabled = false;
  }

  /** There is no atlas. */
  clear(): void {
    this.notes.hidden = true;
    this.summary.textContent = '';
    this.summary.title = '';
    this.shown = null;
    this.table?.clear();
    this.pack.disabled = true;
  }

  showSelected(charts: ReadonlySet<number>): void {
    this.selected = charts;
    this.table?.showSelected(charts);
  }

  private async load(): Promise<void> {
    try {
      const { ChartTable } = await chartTables();
      this.table ??= new ChartTable(this.ofTable);
      this.list(this.table);
    } catch (error) {
      this.events.say(reasonOf(error as Error));
    }
  }

  private list(table: ChartTable): void {
    if (!this.shown) return;
    table.show(this.shown.result.report, this.colors, this.shown.stacks);
    table.showSelected(this.selected);
    table.showLocks(this.locks.charts, this.locks.keptUvs);
  }

  private showLocks(): void {
    const { charts, keptUvs } = this.locks;
    this.table?.showLocks(charts, keptUvs);
    this.lockSummary.textContent = LOCKS.summary(charts.size, keptUvs.size);
  }
}

function summary({ charts, seams, quasiConformalMean }: UnwrapReport): string {
  const largest = charts.reduce((most, { faces }) => Math.max(most, faces), 0);
  return CHART_LIST.summary(charts.length, largest, seams.edges, quasiConformalMean);
}
