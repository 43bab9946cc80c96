import type { PackReport, Report, UnwrapReport } from 'abflat';
import { bindToggle, create, element, showText } from '../base/dom';
import { FAULTS, type UvFault } from '../colors/fault-colors';
import type { ChartAreas } from '../mesh/chart-areas';
import type { FlatDrawing } from '../model/drawing';
import { faultyFaces } from '../model/faulty-faces';
import { foundChart } from '../model/found-chart';
import type { Measure } from '../model/measures';
import type { Outcome } from '../model/model';
import { count, distortion, duration, measure } from '../words/format';
import {
  ATLAS_METRICS,
  BADGES,
  DISK_METRICS,
  ISLAND_METRICS,
  METRICS,
  REMEDIES,
} from '../words/result';
import { atlasNotes } from './atlas-notes';
import { islandNotes } from './islands';
import { notes } from './notes';
import type { Remedy, Verdict } from './remedy';
import { verdictOf } from './verdict';

/** `S` is what it measures. */
interface Metric<S> {
  label: string;
  title: string;
  value(subject: S): string;
  isBad?(subject: S): boolean;
  /** Whose heat map shows where the number comes from. */
  measure?: Measure;
}

/** An atlas as it is drawn: what its report says of packing need not hold any more. */
type MeasuredAtlas = UnwrapReport & { areas: ChartAreas | null };

/** The UVs of a file, with the number of faces that have each fault. */
type MeasuredLayout = PackReport & { faulty: Record<UvFault, number> };

/** Texels per unit of the mesh, of the whole surface. */
function densityOf(areas: ChartAreas | null, resolution: number): number {
  const sum = (values: Float64Array = new Float64Array()) =>
    values.reduce((total, each) => total + each, 0);
  return resolution * Math.sqrt(sum(areas?.flat) / sum(areas?.solid));
}

const OF_DISK: Metric<Report>[] = [
  {
    ...DISK_METRICS.stretch,
    value: ({ charts: [chart] }) => stretch(chart.symmetricDirichlet),
    measure: 'stretch',
  },
  {
    ...DISK_METRICS.angle,
    value: ({ charts: [chart] }) => distortion(chart.angularDistortion),
    measure: 'angle',
  },
  {
    ...DISK_METRICS.crossings,
    value: ({ charts: [chart] }) => count(chart.boundaryCrossings),
    isBad: ({ charts: [chart] }) => chart.boundaryCrossings > 0,
  },
  {
    ...DISK_METRICS.flipped,
    value: ({ charts: [chart] }) => count(chart.flippedTriangles),
    isBad: ({ charts: [chart] }) => chart.flippedTriangles > 0,
  },
  {
    ...DISK_METRICS.length,
    value: ({ charts: [chart] }) => distortion(chart.lengthDistortion),
  },
  {
    ...METRICS.faces,
    value: ({ input }) => count(input.faces),
  },
  {
    ...DISK_METRICS.steps,
    value: ({ charts: [chart] }) => count(chart.iterations),
  },
];

const OF_ATLAS: Metric<MeasuredAtlas>[] = [
  {
    ...ATLAS_METRICS.charts,
    value: ({ charts }) => count(charts.length),
    isBad: ({ valid }) => !valid,
  },
  {
    ...ATLAS_METRICS.stretch,
    value: ({ symmetricDirichlet }) => stretch(symmetricDirichlet),
    measure: 'stretch',
  },
  {
    ...ATLAS_METRICS.utilization,
    value: ({ atlas }) => percent(atlas.utilization),
  },
  {
    ...ATLAS_METRICS.texelDensity,
    value: ({ atlas, areas }) => measure(densityOf(areas, atlas.resolution)),
  },
  {
    ...ATLAS_METRICS.seamLength,
    value: ({ seams }) => measure(seams.relativeLength),
  },
  {
    ...ATLAS_METRICS.angle,
    value: ({ angularDistortion }) => distortion(angularDistortion),
    measure: 'angle',
  },
  {
    ...METRICS.faces,
    value: ({ input }) => count(input.faces),
  },
];

const OF_ISLANDS: Metric<MeasuredLayout>[] = [
  {
    ...ISLAND_METRICS.islands,
    value: ({ islands }) => count(islands),
    isBad: ({ valid }) => !valid,
  },
  {
    ...ISLAND_METRICS.utilization,
    value: ({ utilization }) => percent(utilization),
  },
  ...FAULTS.map((fault) => ({
    ...ISLAND_METRICS[fault],
    value: ({ faulty }: MeasuredLayout) => count(faulty[fault]),
  })),
  {
    ...METRICS.faces,
    value: ({ input }) => count(input.faces),
  },
];

/** What refining gained, if it did anything. */
const REFINED: Metric<{ refined: Energies }> = {
  ...METRICS.energy,
  value: ({ refined: { before, after } }) => `${stretch(before)} \u2192 ${stretch(after)}`,
};

const TIME: Metric<{ timings: { total: number } }> = {
  ...METRICS.time,
  value: ({ timings }) => duration(timings.total),
};

const NO_VALUE = '\u2013';

const GRADES: Record<Verdict['badge'], string> = {
  [BADGES.valid]: 'good',
  [BADGES.stretched]: 'warn',
  [BADGES.uneven]: 'warn',
  [BADGES.asInFile]: 'warn',
  [BADGES.notValid]: 'bad',
};

export interface MetricsEvents {
  showNotes(): void;
  /** Carries out the remedy that the verdict offers. */
  help(remedy: Remedy): void;
  /** A number was clicked: shows where it comes from. Undefined if there are no views. */
  showWorst?: ((measure: Measure) => void) | undefined;
}

/** The numbers of a result, the first ones in sight, and how good it is. */
export class MetricsPanel {
  private readonly panel = element('result', HTMLElement);
  private readonly badge = element('badge', HTMLElement);
  private readonly reason = element('reason', HTMLElement);
  private readonly notesButton = element('notes-button', HTMLButtonElement);
  private readonly remedyButton = element('remedy', HTMLButtonElement);
  private verdict: Verdict | null = null;
  private readonly list = element('metrics', HTMLElement);

  constructor(private readonly events: MetricsEvents) {
    bindToggle('all-figures', (isOn) => this.panel.classList.toggle('all', isOn));
    this.notesButton.addEventListener('click', () => events.showNotes());
    this.remedyButton.addEventListener('click', () => {
      if (this.verdict?.remedy) events.help(this.verdict.remedy);
    });
    this.list.addEventListener('click', ({ target }) => {
      const { measure } = target instanceof HTMLButtonElement ? target.dataset : {};
      if (measure) events.showWorst?.(measure as Measure);
    });
    this.list.append(...[...OF_DISK, TIME].map(({ label, title }) => item(label, title, NO_VALUE)));
  }

  show(outcome: Outcome, { areas }: FlatDrawing): void {
    const { report } = outcome.result;
    const items = this.figuresOf(outcome, areas);
    const refined = energiesOf(outcome);
    // Replaces the time, so that the number of items stays the same.
    const last = refined ? this.itemsOf([REFINED], { refined }) : this.itemsOf([TIME], report);
    this.list.replaceChildren(...items, ...last);
    this.verdict = verdictOf(outcome, areas);
    this.badge.textContent = this.verdict.badge;
    this.badge.className = `badge ${GRADES[this.verdict.badge]}`;
    const noteCount = notesOf(outcome).length;
    this.notesButton.textContent = METRICS.notes(noteCount);
    this.notesButton.hidden = noteCount === 0;
    this.mark(null);
  }

  /** There is no result. */
  clear(): void {
    for (const value of this.list.querySelectorAll('dd')) {
      value.className = '';
      value.textContent = NO_VALUE;
    }
    this.verdict = null;
    this.badge.textContent = BADGES.none;
    this.badge.className = 'badge';
    this.notesButton.hidden = true;
    this.mark(null);
  }

  /** Says that the numbers are not those of what is on screen, but of `owner`; null: they are. */
  mark(other: { text: string; owner: string } | null): void {
    this.panel.classList.toggle('stale', other !== null);
    if (other) this.setReason(other.text, other.owner);
    else this.setReason(this.verdict?.reason ?? '');
    this.showRemedy(other ? null : (this.verdict?.remedy ?? null));
  }

  private figuresOf(outcome: Outcome, areas: ChartAreas | null): HTMLElement[] {
    if (outcome.mode === 'flatten') return this.itemsOf(OF_DISK, outcome.result.report);
    if (outcome.mode === 'pack')
      return this.itemsOf(OF_ISLANDS, { ...outcome.result.report, faulty: faultyFaces(outcome) });
    return this.itemsOf(OF_ATLAS, { ...outcome.result.report, areas });
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

  private setReason(text: string, title = text): void {
    showText(this.reason, text, title);
  }
}

interface Energies {
  before: number;
  after: number;
}

/** Area-weighted means over the refined charts; null if there are none. */
function energiesOf(outcome: Outcome): Energies | null {
  if (outcome.mode === 'pack') return null;
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

const percent = (share: number) => `${(100 * share).toFixed(1)}\u202f%`;

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
  button.title = METRICS.toWorst(title);
  return button;
}

function notesOf(outcome: Outcome): string[] {
  if (outcome.mode === 'pack') return islandNotes(outcome);
  return outcome.mode === 'unwrap' ? atlasNotes(outcome) : notes(foundChart(outcome));
}
