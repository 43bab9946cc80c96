import type { UnwrapReport } from 'abflat';
import { create, element } from '../base/dom';
import type { Unwrapped } from '../model/model';
import type { Views } from '../view/views';
import { CHART_LIST, LOCKS } from '../words/charts';
import { atlasNotes } from './atlas-notes';
import { ChartTable } from './chart-table';
import type { Locks } from './locks';

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
  private readonly table: ChartTable;
  private readonly lockSummary = element('locks-summary', HTMLElement);
  private readonly pack = element('pack-again', HTMLButtonElement);
  private readonly summary = element('charts-summary', HTMLElement);

  /** `views` highlight the chart under the pointer. */
  constructor(
    views: Views | null,
    private readonly locks: Locks,
    events: ChartsTabEvents,
  ) {
    this.table = new ChartTable({
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
    });
    this.pack.addEventListener('click', () => events.packAgain());
  }

  show(outcome: Unwrapped, colors: Float32Array | null): void {
    const lines = atlasNotes(outcome);
    const { report } = outcome.result;
    this.notes.replaceChildren(...lines.map((line) => create('li', '', line)));
    this.notes.hidden = lines.length === 0;
    this.summary.textContent = summary(report);
    this.summary.title = CHART_LIST.aboutSummary;
    this.table.show(report, colors, outcome.stacks);
    this.showLocks();
    this.pack.disabled = false;
  }

  /** There is no atlas. */
  clear(): void {
    this.notes.hidden = true;
    this.summary.textContent = '';
    this.summary.title = '';
    this.table.clear();
    this.pack.disabled = true;
  }

  showSelected(charts: ReadonlySet<number>): void {
    this.table.showSelected(charts);
  }

  private showLocks(): void {
    const { charts, keptUvs } = this.locks;
    this.table.showLocks(charts, keptUvs);
    this.lockSummary.textContent = LOCKS.summary(charts.size, keptUvs.size);
  }
}

function summary({ charts, seams, quasiConformalMean }: UnwrapReport): string {
  const largest = charts.reduce((most, { faces }) => Math.max(most, faces), 0);
  return CHART_LIST.summary(charts.length, largest, seams.edges, quasiConformalMean);
}
