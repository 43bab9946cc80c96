import type { Report, UnwrapReport } from 'abflat';
import { create, element } from '../base/dom';
import { count, counted, distortion, duration, measure } from '../base/format';
import { foundChart } from '../model/found-chart';
import type { Measure } from '../model/measures';
import type { Outcome } from '../model/model';
import { atlasNotes } from './atlas-notes';
import { notes } from './notes';
import { type Remedy, type Verdict, verdictOf } from './verdict';

/** `S` is what it measures. */
interface Metric<S> {
  label: string;
  title: string;
  value(subject: S): string;
  isBad?(subject: S): boolean;
  /** Whose heat map shows where the number comes from. */
  measure?: Measure;
}

const STRETCH = 'Symmetric Dirichlet energy / 4, mean over the surface; 1 keeps all lengths';

const AS_IN_FILE = 'Faces of the input: triangles, quads and larger polygons';

const OF_DISK: Metric<Report>[] = [
  {
    label: 'Angular distortion',
    title: 'Mean over all corners of ((x - α)/α)², x in the layout, α in 3D',
    value: ({ charts: [chart] }) => distortion(chart.angularDistortion),
    measure: 'angle',
  },
  {
    label: 'Length distortion',
    title:
      'Mean over all edges of (sL/l - 1)², L in the layout, l in 3D, s the ratio of their sums',
    value: ({ charts: [chart] }) => distortion(chart.lengthDistortion),
  },
  {
    label: 'Stretch',
    title: STRETCH,
    value: ({ charts: [chart] }) => stretch(chart.symmetricDirichlet),
    measure: 'stretch',
  },
  {
    label: 'Crossings',
    title: 'Pairs of boundary edges that cross or touch',
    value: ({ charts: [chart] }) => count(chart.boundaryCrossings),
    isBad: ({ charts: [chart] }) => chart.boundaryCrossings > 0,
  },
  {
    label: 'Flipped',
    title: 'Triangles of the layout that are not positively oriented',
    value: ({ charts: [chart] }) => count(chart.flippedTriangles),
    isBad: ({ charts: [chart] }) => chart.flippedTriangles > 0,
  },
  {
    label: 'Faces',
    title: AS_IN_FILE,
    value: ({ input }) => count(input.faces),
  },
  {
    label: 'Newton steps',
    title: 'Steps of the solver',
    value: ({ charts: [chart] }) => count(chart.iterations),
  },
];

const OF_ATLAS: Metric<UnwrapReport>[] = [
  {
    label: 'Charts',
    title: 'Charts in the atlas; red if one is not valid',
    value: ({ charts }) => count(charts.length),
    isBad: ({ valid }) => !valid,
  },
  {
    label: 'Seam length',
    title:
      'Divided by the square root of the surface area, so it does not depend on the size of the mesh',
    value: ({ seams }) => measure(seams.relativeLength),
  },
  {
    label: 'Stretch',
    title:
      'Symmetric Dirichlet energy / 4, mean over the surface, each chart at its own scale; 1 keeps all lengths',
    value: ({ symmetricDirichlet }) => stretch(symmetricDirichlet),
    measure: 'stretch',
  },
  {
    label: 'Angular distortion',
    title: 'Mean over the surface of ((x - α)/α)², x in the layout, α in 3D',
    value: ({ angularDistortion }) => distortion(angularDistortion),
    measure: 'angle',
  },
  {
    label: 'Utilisation',
    title: 'Share of the square, or of all tiles, that the charts cover',
    value: ({ atlas }) => `${(100 * atlas.utilization).toFixed(1)}\u202f%`,
  },
  {
    label: 'Texel density',
    title: 'Texels per mesh unit at this resolution',
    value: ({ atlas }) => measure(atlas.texelDensity),
  },
  {
    label: 'Faces',
    title: AS_IN_FILE,
    value: ({ input }) => count(input.faces),
  },
];

/** What refining gained, if it did anything. */
const REFINED: Metric<{ refined: Energies }> = {
  label: 'Energy',
  title:
    'Energy minimised for the balance b, averaged over the refined surface, before and after: (1 - b)·(σ₁/σ₂ + σ₂/σ₁)/2 + b·(σ₁² + σ₂² + 1/σ₁² + 1/σ₂²)/4',
  value: ({ refined: { before, after } }) => `${stretch(before)} \u2192 ${stretch(after)}`,
};

const TIME: Metric<{ timings: { total: number } }> = {
  label: 'Time',
  title: 'Total time in the worker, including reading and writing',
  value: ({ timings }) => duration(timings.total),
};

const GRADES: Record<Verdict['badge'], string> = {
  Valid: 'good',
  Stretched: 'warn',
  'Not valid': 'bad',
};

const REMEDIES: Record<Remedy, { label: string; title: string }> = {
  cut: {
    label: 'Cut further',
    title: 'Keep these seams and add automatic ones until every chart is within the limit',
  },
  unwrap: { label: 'Unwrap', title: 'Cut the mesh into charts that stretch less' },
};

export interface MetricsEvents {
  showNotes(): void;
  /** Carries out the remedy that the verdict offers. */
  help(remedy: Remedy): void;
  /** A number was clicked: shows where it comes from. Undefined if there are no views. */
  showWorst?: ((measure: Measure) => void) | undefined;
}

/** The numbers of a result, and how good it is. */
export class MetricsPanel {
  private readonly panel = element('result', HTMLElement);
  private readonly badge = element('badge', HTMLElement);
  private readonly reason = element('reason', HTMLElement);
  private readonly notesButton = element('notes-button', HTMLButtonElement);
  private readonly remedyButton = element('remedy', HTMLButtonElement);
  private verdict: Verdict | null = null;
  private readonly list = element('metrics', HTMLElement);

  constructor(private readonly events: MetricsEvents) {
    this.notesButton.addEventListener('click', () => events.showNotes());
    this.remedyButton.addEventListener('click', () => {
      if (this.verdict?.remedy) events.help(this.verdict.remedy);
    });
    this.list.addEventListener('click', ({ target }) => {
      const { measure } = target instanceof HTMLButtonElement ? target.dataset : {};
      if (measure) events.showWorst?.(measure as Measure);
    });
    this.list.append(...[...OF_DISK, TIME].map(({ label, title }) => item(label, title, '\u2013')));
  }

  show(outcome: Outcome): void {
    const { report } = outcome.result;
    const items =
      outcome.mode === 'unwrap'
        ? this.itemsOf(OF_ATLAS, outcome.result.report)
        : this.itemsOf(OF_DISK, outcome.result.report);
    const refined = energiesOf(outcome);
    // Replaces the time, so that the number of items stays the same.
    const last = refined ? this.itemsOf([REFINED], { refined }) : this.itemsOf([TIME], report);
    this.list.replaceChildren(...items, ...last);
    this.verdict = verdictOf(outcome);
    this.badge.textContent = this.verdict.badge;
    this.badge.className = `badge ${GRADES[this.verdict.badge]}`;
    const noteCount = notesOf(outcome).length;
    this.notesButton.textContent = counted(noteCount, 'note');
    this.notesButton.hidden = noteCount === 0;
    this.markStale(null);
  }

  /**
   * Marks the numbers as those of an earlier state, named by `owner`; null means they are current.
   */
  markStale(owner: string | null): void {
    this.panel.classList.toggle('stale', owner !== null);
    this.setReason(owner === null ? (this.verdict?.reason ?? '') : `Numbers of ${owner}`);
    this.showRemedy(owner === null ? (this.verdict?.remedy ?? null) : null);
  }

  private itemsOf<S>(metrics: Metric<S>[], subject: S): HTMLElement[] {
    const canShow = this.events.showWorst !== undefined;
    return metrics.map(({ label, title, value, isBad, measure }) => {
      const text = value(subject);
      const content = measure && canShow ? linked(text, title, measure) : text;
      return item(label, title, content, isBad?.(subject));
    });
  }

  private showRemedy(remedy: Remedy | null): void {
    this.remedyButton.hidden = remedy === null;
    if (!remedy) return;
    this.remedyButton.textContent = REMEDIES[remedy].label;
    this.remedyButton.title = REMEDIES[remedy].title;
  }

  private setReason(text: string): void {
    this.reason.textContent = text;
    this.reason.title = text;
  }
}

interface Energies {
  before: number;
  after: number;
}

/** Area-weighted means over the refined charts; null if there are none. */
function energiesOf(outcome: Outcome): Energies | null {
  const charts =
    outcome.mode === 'unwrap'
      ? outcome.result.report.charts
      : outcome.result.report.charts.map(({ refined }) => ({ refined, area: 1 }));
  let [area, before, after] = [0, 0, 0];
  for (const chart of charts) {
    if (!chart.refined) continue;
    area += chart.area ?? 0;
    before += (chart.area ?? 0) * chart.refined.energyBefore;
    after += (chart.area ?? 0) * chart.refined.energy;
  }
  return area > 0 ? { before: before / area, after: after / area } : null;
}

const stretch = (energy: number) => (energy < 100 ? energy.toFixed(4) : measure(energy));

function item(label: string, title: string, value: string | Node, isBad = false): HTMLElement {
  const made = create('div', 'metric');
  made.title = title;
  const shown = create('dd', isBad ? 'bad' : '');
  shown.append(value);
  made.append(create('dt', '', label), shown);
  return made;
}

/** A number whose click shows where it is worst. */
function linked(text: string, title: string, measure: Measure): HTMLElement {
  const button = create('button', 'metric-button', text);
  button.type = 'button';
  button.dataset.measure = measure;
  button.title = `${title}. Click to see where it is worst`;
  return button;
}

function notesOf(outcome: Outcome): string[] {
  return outcome.mode === 'unwrap' ? atlasNotes(outcome.result.report) : notes(foundChart(outcome));
}
