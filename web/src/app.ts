import type { Abflat, Progress } from 'abflat';
import { hideAlert, showAlert } from './alert';
import { BoundControl } from './bound-control';
import { Details } from './details';
import { element } from './dom';
import { exportObj } from './export-obj';
import { type Bound, bound, count, counted, duration } from './format';
import type { DisplayMesh } from './mesh';
import { MetricsPanel } from './metrics';
import { bindOpen, FIRST_SAMPLE, showSample, titleOf } from './open-mesh';
import { RunPanel } from './run-panel';
import type { Outcome, SessionEvents, Source } from './session';
import { Session } from './session';
import { SolverTab } from './solver-tab';
import { flattenIfPossible } from './sweep';
import { SweepTab } from './sweep-tab';
import { bindTheme } from './theme';
import type { Views } from './views';

/** Connects the session with what is on the page. */
export class App implements SessionEvents {
  private readonly session: Session;
  private readonly bound = new BoundControl((t) => this.session.flatten(t));
  private readonly details = new Details(() => undefined);
  private readonly metrics = new MetricsPanel(() => this.showNotes());
  private readonly solver = new SolverTab();
  private readonly sweep = new SweepTab(
    (t, signal) =>
      this.session.aside(
        (abflat, input, signal) => flattenIfPossible(abflat, input, t, signal),
        signal,
      ),
    (t) => this.bound.choose(t),
  );
  private readonly run = new RunPanel(
    () => this.session.cancel() || this.sweep.stop(),
    () => this.session.flatten(this.bound.t),
  );
  private readonly exportButton = element('export', HTMLButtonElement);
  private readonly layoutNote = element('layout-note', HTMLElement);
  /** The mesh in the 3D view. */
  private shown: Source | null = null;
  /** The last result. */
  private outcome: Outcome | null = null;

  constructor(
    abflat: Promise<Abflat>,
    private readonly views: Views | null,
  ) {
    this.session = new Session(abflat, this);
    bindTheme(element('theme', HTMLButtonElement), () => this.views?.updateTheme());
    bindOpen((source) => void this.session.open(source, this.bound.t));
    this.exportButton.addEventListener('click', () => this.export());
    void this.session.open({ kind: 'sample', name: FIRST_SAMPLE }, this.bound.t);
  }

  started(source: Source, t: Bound | null): void {
    this.run.start(t === null ? `Reading ${titleOf(source)}` : `Flattening with t = ${bound(t)}`);
    document.body.setAttribute('aria-busy', 'true');
    this.markStale(t ?? this.bound.t);
  }

  progress(progress: Progress): void {
    this.run.progress(progress);
  }

  opened(source: Source, mesh: DisplayMesh): void {
    hideAlert();
    this.shown = source;
    this.views?.showMesh(mesh);
    this.sweep.clear();
    this.bound.setBoundaryVertices(null);
    showSample(source.kind === 'sample' ? source.name : null);
    this.showTitle(source);
    element('mesh-info', HTMLElement).textContent = counted(mesh.indices.length / 3, 'triangle');
    this.updateExport();
    this.markStale();
  }

  flattened(outcome: Outcome): void {
    const { report } = outcome.result;
    hideAlert();
    this.outcome = outcome;
    this.views?.showOutcome(outcome);
    this.metrics.show(report);
    this.solver.show(report.charts[0]);
    this.sweep.setCurrent(report.charts[0].t);
    this.bound.setBoundaryVertices(report.charts[0].boundaryVertices);
    if (outcome.t === 'auto') this.bound.showFound(report.charts[0]);
    this.updateExport();
    this.markStale(outcome.t);
    element('layout-info', HTMLElement).textContent = layoutInfo(outcome);
    const verdict = report.valid ? '' : ', not valid';
    this.finish(`Flattened in ${duration(report.timings.total)}${verdict}`, false);
  }

  cancelled(): void {
    this.finish('Cancelled', this.markStale() || this.outcome === null);
  }

  failed(source: Source, t: Bound | null, error: Error): void {
    const kept = this.outcome ? `The layout is still that of ${this.owner()}.` : '';
    showAlert(failure(source, t, error.message), kept);
    showSample(this.shown?.kind === 'sample' ? this.shown.name : null);
    const isStale = this.markStale();
    if (t === null) this.finish(`${titleOf(source)} was not opened`, isStale);
    else this.finish('Not flattened', false);
  }

  private finish(text: string, canRepeat: boolean): void {
    document.body.removeAttribute('aria-busy');
    this.run.finish(text, canRepeat);
  }

  /** What the last result belongs to, for people. */
  private owner(): string {
    if (!this.outcome) return '';
    const t = `t = ${bound(this.outcome.t)}`;
    return `${titleOf(this.outcome.source)}, ${t}`;
  }

  /** Marks layout and numbers when they do not belong to the mesh on screen and to t; returns whether that is so. */
  private markStale(t: Bound = this.bound.t): boolean {
    const isStale =
      this.outcome !== null && (this.outcome.source !== this.shown || this.outcome.t !== t);
    if (isStale) this.layoutNote.textContent = `Previous result: ${this.owner()}`;
    this.layoutNote.hidden = !isStale;
    element('layout-stage', HTMLElement).classList.toggle('stale', isStale);
    this.metrics.markStale(isStale ? this.owner() : null);
    return isStale;
  }

  private showNotes(): void {
    this.details.openAt('solver');
    element('notes', HTMLElement).scrollIntoView({ block: 'nearest' });
  }

  private showTitle(source: Source): void {
    const title = titleOf(source);
    const label = element('source', HTMLElement);
    // A sample's name is already what the list shows.
    label.textContent = source.kind === 'file' ? title : '';
    label.title = title;
    document.title = `${title} \u2013 abflat`;
  }

  /** Only what belongs to the mesh on screen is exported. */
  private updateExport(): void {
    this.exportButton.disabled = this.outcome === null || this.outcome.source !== this.shown;
  }

  private export(): void {
    if (!this.outcome) return;
    const name = exportObj(this.outcome);
    const size = this.outcome.result.obj?.length ?? 0;
    this.run.say(`Exported ${name}, ${count(Math.ceil(size / 1024))}\u202fKB`);
  }
}

/** What went wrong as a sentence that names the mesh. */
function failure(source: Source, t: Bound | null, message: string): string {
  const text = message.replace(/\.$/, '');
  if (text.includes(source.name)) return `${text}.`;
  const what = t === null ? 'was not opened' : 'was not flattened';
  return `${titleOf(source)} ${what}: ${text}.`;
}

/** The t of a layout, and what the automatic choice came to. */
function layoutInfo({ t, result }: Outcome): string {
  const [chart] = result.report.charts;
  const tightened = chart.bounds.length;
  const but = tightened > 0 ? ` but for ${counted(tightened, 'vertex', 'vertices')}` : '';
  const found = chart.t >= 2 ? 'free' : bound(chart.t);
  return `t = ${bound(t)}${t === 'auto' ? `: ${found}${but}` : ''}`;
}
