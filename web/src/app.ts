import type { Abflat, Progress } from 'abflat';
import { hideAlert, showAlert } from './alert';
import { BoundControl } from './bound-control';
import { element } from './dom';
import { exportObj } from './export-obj';
import { bound, count, counted, duration } from './format';
import type { DisplayMesh } from './mesh';
import { MetricsPanel } from './metrics';
import { bindOpen, FIRST_SAMPLE, showSample, titleOf } from './open-mesh';
import { RunPanel } from './run-panel';
import type { Outcome, SessionEvents, Source } from './session';
import { Session } from './session';
import { bindTheme } from './theme';
import type { Views } from './views';

/** Connects the session with what is on the page. */
export class App implements SessionEvents {
  private readonly session: Session;
  private readonly bound = new BoundControl((t) => this.session.flatten(t));
  private readonly metrics = new MetricsPanel();
  private readonly run = new RunPanel(
    () => this.session.cancel(),
    () => this.session.flatten(this.bound.t),
  );
  private readonly exportButton = element('export', HTMLButtonElement);
  private readonly layoutNote = element('layout-note', HTMLElement);
  /** The mesh in the 3D view. */
  private shown: Source | null = null;
  /** The last result. */
  private outcome: Outcome | null = null;

  constructor(
    abflat: Abflat,
    private readonly views: Views | null,
  ) {
    this.session = new Session(abflat, this);
    bindTheme(element('theme', HTMLButtonElement), () => this.views?.updateTheme());
    bindOpen((source) => void this.session.open(source, this.bound.t));
    this.exportButton.addEventListener('click', () => this.export());
    void this.session.open({ kind: 'sample', name: FIRST_SAMPLE }, this.bound.t);
  }

  started(source: Source, t: number | null): void {
    this.run.start(t === null ? `Reading ${titleOf(source)}` : `Flattening with t = ${bound(t)}`);
    document.body.setAttribute('aria-busy', 'true');
  }

  progress(progress: Progress): void {
    this.run.progress(progress);
  }

  opened(source: Source, mesh: DisplayMesh): void {
    hideAlert();
    this.shown = source;
    this.views?.showMesh(mesh);
    this.bound.setBoundaryVertices(null);
    showSample(source.kind === 'sample' ? source.name : null);
    this.showTitle(titleOf(source));
    element('mesh-info', HTMLElement).textContent = counted(mesh.indices.length / 3, 'triangle');
    this.markStale();
  }

  flattened(outcome: Outcome): void {
    const { report } = outcome.result;
    hideAlert();
    this.outcome = outcome;
    this.views?.showOutcome(outcome);
    this.metrics.show(report);
    this.bound.setBoundaryVertices(report.charts[0].boundaryVertices);
    this.exportButton.disabled = false;
    this.layoutNote.hidden = true;
    element('layout-stage', HTMLElement).classList.remove('stale');
    element('layout-info', HTMLElement).textContent = `t = ${bound(outcome.t)}`;
    const verdict = report.valid ? '' : ', not valid';
    this.finish(`Flattened in ${duration(report.timings.total)}${verdict}`, false);
  }

  cancelled(): void {
    this.markStale();
    this.finish('Cancelled', this.shown !== null);
  }

  failed(source: Source, t: number | null, error: Error): void {
    const kept = this.outcome ? `The layout is still that of ${this.owner()}.` : '';
    showAlert(error.message, kept);
    this.markStale();
    showSample(this.shown?.kind === 'sample' ? this.shown.name : null);
    this.finish(t === null ? `${titleOf(source)} was not opened` : 'Not flattened', false);
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

  /** The layout and the numbers no longer belong to what the controls say. */
  private markStale(): void {
    if (!this.outcome) return;
    this.metrics.markStale(this.owner());
    this.layoutNote.textContent = `Previous result: ${this.owner()}`;
    this.layoutNote.hidden = false;
    element('layout-stage', HTMLElement).classList.add('stale');
  }

  private showTitle(title: string): void {
    const label = element('source', HTMLElement);
    label.textContent = title;
    label.title = title;
    document.title = `${title} \u2013 abflat`;
  }

  private export(): void {
    if (!this.outcome) return;
    const name = exportObj(this.outcome);
    const size = this.outcome.result.obj?.length ?? 0;
    this.finish(`Exported ${name}, ${count(Math.ceil(size / 1024))} KB`, false);
  }
}
