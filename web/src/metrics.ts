import type { ChartReport, Report } from 'abflat';
import { create, element } from './dom';
import { count, counted, duration, measure, sentence } from './format';
import { notes } from './notes';

interface Metric {
  label: string;
  title: string;
  value(chart: ChartReport, report: Report): string;
  isBad?(chart: ChartReport): boolean;
}

const METRICS: Metric[] = [
  {
    label: 'Angular distortion',
    title: 'Mean over all corners of ((x - α)/α)², x in the layout, α in 3D',
    value: (chart) => measure(chart.angularDistortion),
  },
  {
    label: 'Length distortion',
    title:
      'Mean over all edges of (sL/l - 1)², L in the layout, l in 3D, s the ratio of their sums',
    value: (chart) => measure(chart.lengthDistortion),
  },
  {
    label: 'Crossings',
    title: 'Pairs of boundary edges that cross or touch',
    value: (chart) => count(chart.boundaryCrossings),
    isBad: (chart) => chart.boundaryCrossings > 0,
  },
  {
    label: 'Flipped',
    title: 'Triangles of the layout that are not positively oriented',
    value: (chart) => count(chart.flippedTriangles),
    isBad: (chart) => chart.flippedTriangles > 0,
  },
  {
    label: 'Faces',
    title: 'Triangles of the layout',
    value: (chart) => count(chart.faces),
  },
  {
    label: 'Boundary vertices',
    title: 'Vertices on the boundary',
    value: (chart) => count(chart.boundaryVertices),
  },
  {
    label: 'Newton steps',
    title: 'Steps of the solver',
    value: (chart) => count(chart.iterations),
  },
  {
    label: 'Time',
    title: 'From the first byte to the last, in the worker',
    value: (_, report) => duration(report.timings.total),
  },
];

/** The numbers of a result and whether it is valid. */
export class MetricsPanel {
  private readonly panel = element('result', HTMLElement);
  private readonly badge = element('badge', HTMLElement);
  private readonly reason = element('reason', HTMLElement);
  private readonly notesButton = element('notes-button', HTMLButtonElement);
  private verdict = '';
  private readonly values = METRICS.map(({ label, title }) => {
    const value = create('dd', '', '\u2013');
    const item = create('div', 'metric');
    item.title = title;
    item.append(create('dt', '', label), value);
    element('metrics', HTMLElement).append(item);
    return value;
  });

  /** `showNotes` opens them. */
  constructor(showNotes: () => void) {
    this.notesButton.addEventListener('click', showNotes);
  }

  show(report: Report): void {
    const [chart] = report.charts;
    METRICS.forEach(({ value, isBad }, i) => {
      this.values[i].textContent = value(chart, report);
      this.values[i].classList.toggle('bad', isBad?.(chart) ?? false);
    });
    this.badge.textContent = report.valid ? 'Valid' : 'Not valid';
    this.badge.className = report.valid ? 'badge good' : 'badge bad';
    this.verdict = verdict(report);
    const noteCount = notes(chart).length;
    this.notesButton.textContent = counted(noteCount, 'note');
    this.notesButton.hidden = noteCount === 0;
    this.markStale(null);
  }

  /** Marks the numbers as those of an earlier state, which `owner` names; null: they are current. */
  markStale(owner: string | null): void {
    this.panel.classList.toggle('stale', owner !== null);
    this.setReason(owner === null ? this.verdict : `Numbers of ${owner}`);
  }

  private setReason(text: string): void {
    this.reason.textContent = text;
    this.reason.title = text;
  }
}

/** One sentence on why a result is valid or not. */
export function verdict({ charts: [chart], valid }: Report): string {
  return valid ? 'No flipped triangles, no crossings' : sentence(chart.problem);
}
