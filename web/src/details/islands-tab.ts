import { create, element } from '../base/dom';
import type { Packed } from '../model/model';
import { islandNotes, islandsSummary } from './islands';

/** What the UVs of a file consist of, and what there is to know about them. */
export class IslandsTab {
  private readonly summary = element('islands-summary', HTMLElement);
  private readonly notes = element('islands-notes', HTMLUListElement);

  show(outcome: Packed): void {
    this.summary.textContent = islandsSummary(outcome.result.report);
    this.notes.replaceChildren(...islandNotes(outcome).map((note) => create('li', '', note)));
  }

  /** There is no layout. */
  clear(): void {
    this.summary.textContent = '';
    this.notes.replaceChildren();
  }
}
