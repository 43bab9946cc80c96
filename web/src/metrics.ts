import type { ChartReport, Report, UnwrapReport } from 'abflat';
import { atlasNotes } from './atlas-notes';
import { create, element } from './dom';
import { count, counted, duration, measure, sentence } from './format';
import type { Outcome } from './lay-out';
import { notes } from './notes';

/** `S` is what it is the measure of. */
interface Metric<S> {
  label: string;
  title: string;
  value(subject: S): string;
  isBad?(subject: S): boolean;
}

const OF_DISK: Metric<ChartReport>[] = [
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
];

const OF_ATLAS: Metric<UnwrapReport>[] = [
  {
    label: 'Charts',
    title: 'Pieces of the atlas; red when one is not valid',
    value: ({ charts }) => count(charts.length),
    isBad: ({ valid }) => !valid,
  },
  {
    label: 'Seam length',
    title: "Divided by the root of the surface's area: the same for every size of the mesh",
    value: ({ seams }) => measure(seams.relativeLength),
  },
  {
    label: 'Stretch',
    title:
      'Symmetric Dirichlet energy / 4, mean over the surface, each chart at its own scale; 1 keeps all lengths',
    value: ({ symmetricDirichlet }) => symmetricDirichlet.toFixed(4),
  },
  {
    label: 'Angular distortion',
    title: 'Mean over the surface of ((x - α)/α)², x in the layout, α in 3D',
    value: ({ angularDistortion }) => measure(angularDistortion),
  },
  {
    label: 'Utilisation',
    title: 'Share of the square, or of all tiles, that charts cover',
    value: ({ atlas }) => `${(100 * atlas.utilization).toFixed(1)}\u202f%`,
  },
  {
    label: 'Texel density',
    title: 'Texels per unit of length of the mesh, at this resolution',
    value: ({ atlas }) => measure(atlas.texelDensity),
  },
  {
    label: 'Faces',
    title: 'Triangles of the mesh',
    value: ({ input }) => count(input.triangles),
  },
];

const TIME: Metric<{ timings: { total: number } }> = {
  label: 'Time',
  title: 'From the first byte to the last, in the worker',
  value: ({ timings }) => duration(timings.total),
};

/** The numbers of a result and whether it is valid. */
export class MetricsPanel {
  private readonly panel = element('result', HTMLElement);
  private readonly badge = element('badge', HTMLElement);
  private readonly reason = element('reason', HTMLElement);
  private readonly notesButton = element('notes-button', HTMLButtonElement);
  private verdict = '';
  private readonly list = element('metrics', HTMLElement);

  /** `showNotes` opens them. */
  constructor(showNotes: () => void) {
    this.notesButton.addEventListener('click', showNotes);
    this.list.append(...[...OF_DISK, TIME].map(({ label, title }) => item(label, title, '\u2013')));
  }

  show(outcome: Outcome): void {
    const { report } = outcome.result;
    const items =
      outcome.mode === 'unwrap'
        ? itemsOf(OF_ATLAS, outcome.result.report)
        : itemsOf(OF_DISK, outcome.result.report.charts[0]);
    this.list.replaceChildren(...items, ...itemsOf([TIME], report));
    this.badge.textContent = report.valid ? 'Valid' : 'Not valid';
    this.badge.className = report.valid ? 'badge good' : 'badge bad';
    this.verdict = verdict(outcome);
    const noteCount = notesOf(outcome).length;
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

function itemsOf<S>(metrics: Metric<S>[], subject: S): HTMLElement[] {
  return metrics.map(({ label, title, value, isBad }) =>
    item(label, title, value(subject), isBad?.(subject)),
  );
}

function item(label: string, title: string, text: string, isBad = false): HTMLElement {
  const made = create('div', 'metric');
  made.title = title;
  made.append(create('dt', '', label), create('dd', isBad ? 'bad' : '', text));
  return made;
}

function notesOf(outcome: Outcome): string[] {
  return outcome.mode === 'unwrap'
    ? atlasNotes(outcome.result.report)
    : notes(outcome.result.report.charts[0]);
}

/** One sentence on why a result is valid or not. */
export function verdict(outcome: Outcome): string {
  return outcome.mode === 'unwrap'
    ? atlasVerdict(outcome.result.report)
    : diskVerdict(outcome.result.report);
}

function diskVerdict({ charts: [chart], valid }: Report): string {
  return valid ? 'No flipped triangles, no crossings' : sentence(chart.problem);
}

function atlasVerdict({ charts, valid }: UnwrapReport): string {
  if (valid) return 'No flipped triangles, no overlapping charts';
  const bad = charts.filter((chart) => !chart.valid);
  return `${count(bad.length)} of ${counted(charts.length, 'chart')}: ${bad[0].problem}`;
}
