import type { UnwrapReport } from 'abflat';
import { atlasNotes } from './atlas-notes';
import { create, element } from './dom';
import { counted, measure } from './format';

/** What an atlas consists of and what was done to get it. */
export class ChartsTab {
  private readonly notes = element('atlas-notes', HTMLUListElement);
  private readonly summary = element('charts-summary', HTMLElement);

  show(report: UnwrapReport): void {
    const lines = atlasNotes(report);
    this.notes.replaceChildren(...lines.map((line) => create('li', '', line)));
    this.notes.hidden = lines.length === 0;
    this.summary.textContent = summary(report);
  }
}

function summary({ charts, seams, quasiConformalMean }: UnwrapReport): string {
  const largest = charts.reduce((most, { faces }) => Math.max(most, faces), 0);
  const sizes = `${counted(charts.length, 'chart')}, the largest of ${counted(largest, 'triangle')}`;
  const cuts = seams.edges > 0 ? `cut along ${counted(seams.edges, 'edge')}` : 'nothing was cut';
  return `${sizes}; ${cuts}; mean ratio of stretches ${measure(quasiConformalMean)}`;
}
