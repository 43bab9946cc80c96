import { create, element } from '../base/dom';
import { loadPart, reasonOf } from '../base/load-part';
import type { ChartAreas } from '../mesh/chart-areas';
import type { Packed } from '../model/model';
import type { IslandTable, IslandTableEvents } from './island-table';
import { islandNotes, islandsSummary } from './islands';

export interface IslandsTabEvents extends IslandTableEvents {
  say(text: string): void;
}

/** What the UVs of a file consist of, and what there is to know about them. */
export class IslandsTab {
  private readonly summary = element('islands-summary', HTMLElement);
  private readonly notes = element('islands-notes', HTMLUListElement);
  private table: IslandTable | null = null;
  private shown: Packed | null = null;
  private selected: ReadonlySet<number> = new Set();

  constructor(private readonly events: IslandsTabEvents) {}

  show(outcome: Packed, areas: ChartAreas | null): void {
    this.shown = outcome;
    this.summary.textContent = islandsSummary(outcome.result.report);
    this.notes.replaceChildren(...islandNotes(outcome).map((note) => create('li', '', note)));
    if (areas) void this.list(outcome, areas);
  }

  /** There is no layout. */
  clear(): void {
    this.shown = null;
    this.summary.textContent = '';
    this.notes.replaceChildren();
    this.table?.show([]);
  }

  showSelected(islands: ReadonlySet<number>): void {
    this.selected = islands;
    this.table?.showSelected(islands);
  }

  private async list(outcome: Packed, areas: ChartAreas): Promise<void> {
    try {
      const { IslandTable, islandsOf } = await loadPart(import('./island-table'));
      if (this.shown !== outcome) return;
      this.table ??= new IslandTable(this.events);
      this.notes.after(this.table.element);
      this.table.show(islandsOf(outcome, areas));
      this.table.showSelected(this.selected);
    } catch (error) {
      this.events.say(reasonOf(error as Error));
    }
  }
}
