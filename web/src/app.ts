import type { Abflat, Comparison, MethodResult } from 'abflat';
import type { ChartMesh } from './arrange/chart-mesh';
import { Arranging } from './arranging';
import { hideAlert, showAlert } from './base/alert';
import { element } from './base/dom';
import { duration } from './base/format';
import { loadPart } from './base/load-part';
import { Lost } from './base/lost';
import { bindShortcuts } from './base/shortcuts';
import { bindTheme } from './base/theme';
import { BoundPainting } from './bound-painting';
import { Notice } from './controls/notice';
import { RunPanel } from './controls/run-panel';
import { ChartsTab } from './details/charts-tab';
import { CopyReport } from './details/copy-report';
import { Details } from './details/details';
import { plots } from './details/late-chart';
import { MethodsTab, methodTables } from './details/methods-tab';
import { MetricsPanel } from './details/metrics';
import { SolverTab } from './details/solver-tab';
import { SweepTab } from './details/sweep-tab';
import { type Remedy, verdictOf } from './details/verdict';
import { exportMeshes } from './export/exporter';
import { HelpSheet } from './help/help-sheet';
import { Welcome } from './help/welcome';
import { LastVisit } from './last-visit';
import type { FlatDrawing } from './model/drawing';
import { foundChart } from './model/found-chart';
import type { AnyProgress, Opened, Outcome, Source } from './model/model';
import type { Settings } from './model/settings';
import { MeshTabs } from './opening/mesh-tabs';
import { FIRST_SAMPLE, Opening } from './opening/open-mesh';
import { showSample } from './opening/samples';
import { PageHistory } from './page-history';
import { Rest } from './rest';
import { Saving } from './saving';
import { SeamPanel } from './seams/seam-panel';
import { Session, type SessionEvents } from './session/session';
import type { Step } from './session/steps';
import { flattenIfPossible } from './session/sweep';
import { titleOf } from './session/titles';
import {
  facesText,
  failure,
  isOnlyPlaced,
  kept,
  layoutInfo,
  settingsText,
  WORDS,
} from './session/words';
import { ShownLook } from './shown-look';
import { ShownMethod } from './shown-method';
import { ownerOf, StaleMark } from './stale-mark';
import type { Views } from './view/views';
import { Wishes } from './wishes';
import { Workshop } from './workshop/workshop';

/** Connects the session with what is on the page. */
export class App implements SessionEvents {
  private readonly workshop = new Workshop();
  private readonly session: Session;
  private readonly say = (text: string) => this.run.say(text);
  private readonly wishes: Wishes;
  private readonly visit = new LastVisit((settings) => this.follow(settings));
  private readonly history = new PageHistory((step, said) => this.goBack(step, said));
  private readonly details = new Details((tab) => {
    if (tab === 'methods') this.methods.leave();
  });
  private readonly metrics: MetricsPanel;
  private readonly staleMark: StaleMark;
  private readonly solver = new SolverTab();
  private readonly charts: ChartsTab;
  private readonly seams: SeamPanel;
  private readonly arranging: Arranging | null;
  private readonly painting: BoundPainting | null;
  private readonly sweep = new SweepTab(
    (t, signal) =>
      this.session.aside(
        (abflat, input, signal) =>
          flattenIfPossible(abflat, input, { ...this.wishes.disk, t }, signal),
        signal,
      ),
    (t) => this.wishes.bound.choose(t),
  );
  private readonly methods = new MethodsTab(
    (signal, onProgress) =>
      this.session.aside(
        (abflat, input, signal) => abflat.compare(input, { signal, onProgress }),
        signal,
      ),
    (method, comparison) => this.showMethod(method, comparison),
  );
  private readonly run = new RunPanel(
    () =>
      this.opening.stop() ||
      this.session.cancel() ||
      this.saving.stop() ||
      this.sweep.stop() ||
      this.methods.stop() ||
      this.methods.leave(),
    () => this.again(),
  );
  private readonly opening: Opening;
  private readonly tabs = new MeshTabs((source) => void this.session.open(source));
  private readonly notice = new Notice({
    tabs: (sources) => this.tabs.add(sources),
    oneAtlas: (sources) => this.opening.join(sources),
  });
  private readonly look = new ShownLook(this.workshop, this.notice);
  private readonly saving: Saving;
  private readonly shownMethod: ShownMethod;
  private readonly copyReport = new CopyReport(this.say);
  private readonly help = new HelpSheet();
  private readonly welcome = new Welcome();
  private readonly rest = new Rest([
    () => this.workshop.loadRest(),
    () => this.seams.loadRest(),
    plots,
    methodTables,
    exportMeshes,
  ]);
  /** The mesh in the 3D view. */
  private shown: Source | null = null;
  /** The last result. */
  private outcome: Outcome | null = null;
  /** What the button beside the last run does. */
  private again: () => void = () => this.session.refresh();
  /** Why nothing was opened, if that was said during a run: the run's end hides what was said. */
  private refusal = '';
  /** What the user has done, where the result does not say it. */
  private said = '';
  /** The drawing of the last result. */
  private drawing: FlatDrawing | null = null;

  constructor(
    abflat: () => Promise<Abflat>,
    private readonly views: Views | null,
  ) {
    this.seams = new SeamPanel(views?.mesh ?? null, this.workshop, {
      changed: (what) => this.wishes.seamsChanged(what),
      say: this.say,
    });
    this.wishes = new Wishes(this.seams, {
      changed: (what) => this.changed(what),
      modeChanged: () => this.modeChanged(),
      say: this.say,
    });
    this.session = new Session(abflat, this, () => this.wishes.settings, this.workshop);
    this.metrics = new MetricsPanel({
      showNotes: () => this.showNotes(),
      help: (remedy) => this.remedy(remedy),
      showWorst: views ? (measure) => views.showWorst(measure) : undefined,
    });
    this.staleMark = new StaleMark(this.metrics);
    this.saving = new Saving(this.session, this.workshop, views, this.say);
    this.shownMethod = new ShownMethod(this.workshop, this.metrics, views);
    this.charts = new ChartsTab(views, this.wishes.locks, {
      chosen: (chart) => this.arranging?.pick(chart),
      locked: (what) => this.locked(what),
      packAgain: () => this.wishes.packAgain(),
    });
    this.arranging =
      views &&
      new Arranging(views, this.workshop, {
        isFree: () => this.seams.isIdle,
        selected: (charts) => this.charts.showSelected(charts),
        locked: () => this.wishes.locks.charts,
        weights: (layout, pins) => this.weights(layout, pins),
        pinned: (pins, what) => {
          this.wishes.pin(pins);
          this.marked(what);
        },
        say: this.say,
        placing: () => document.body.setAttribute('aria-busy', 'true'),
        placed: (layout, what) => this.wishes.place(layout, what),
        notPlaced: (error) => {
          if (error) showAlert(`The charts were not moved: ${error.message}`);
          if (!this.session.isBusy) this.finish('Nothing was moved', false);
        },
      });
    this.painting =
      views &&
      new BoundPainting(views, this.workshop, {
        bounds: () => this.wishes.disk.bounds ?? [],
        changed: (bounds, what) => this.wishes.paint(bounds, what),
        say: this.say,
      });
    bindTheme(element('theme', HTMLButtonElement), () => this.views?.updateTheme());
    this.opening = new Opening({
      joined: async (sources, signal) => {
        const { oneFile } = await loadPart(import('./opening/one-atlas'));
        return oneFile(sources, { abflat: await abflat(), workshop: this.workshop }, signal);
      },
      gathering: (fraction, text) => this.run.show(fraction, text),
      gathered: (text) => (this.session.isBusy ? this.say(text) : this.finish(text, false)),
      open: (source) => {
        this.refusal = '';
        void this.session.open(source);
      },
      refused: (reason) => this.refuse(reason),
    });
    bindShortcuts({
      'Ctrl+O': () => element('open', HTMLButtonElement).click(),
      'Ctrl+S': () => element('export', HTMLButtonElement).click(),
      'Ctrl+E': () => this.saving.openMenu(),
      '?': () => this.help.open(),
    });
    element('method-back', HTMLButtonElement).addEventListener('click', () => this.backToResult());
    this.showMode();
    this.start(abflat);
  }

  /** Opens the mesh of the last visit, or a sample. */
  private start(abflat: () => Promise<Abflat>): void {
    const finding = this.visit.find();
    if (!finding) {
      this.openFirst(null);
      return;
    }
    abflat().catch(() => undefined); // starts in the meantime; reading says why it does not
    void finding.then((source) => {
      if (!this.session.isBusy && !this.shown) this.openFirst(source);
    });
  }

  private openFirst(source: Source | null): void {
    void this.session.open(source ?? { kind: 'sample', name: FIRST_SAMPLE });
  }

  /** The user wants something else. */
  private changed(what?: string): void {
    const { settings } = this.wishes;
    this.said = what ?? '';
    this.visit.changed();
    this.history.change(settings, what);
    // With another t alone, the plot against t stays as it is.
    if (settings.mode === 'flatten') this.sweep.use(settings);
    this.painting?.update();
    this.session.refresh();
  }

  /** Switches the page to the other kind of layout. */
  private modeChanged(): void {
    this.leaveMode();
    this.showMode();
    this.changed();
  }

  private leaveMode(): void {
    this.methods.leave();
    this.methods.stop();
    this.sweep.stop();
    this.seams.hide();
    this.painting?.show(null);
  }

  private showMode(): void {
    const { mode } = this.wishes.mode;
    this.details.setMode(mode);
    this.saving.setMode(mode);
    if (mode === 'flatten') this.sweep.offer();
    element('delaunay', HTMLButtonElement).hidden = mode === 'unwrap';
  }

  private remedy(remedy: Remedy): void {
    if (remedy === 'unwrap') this.wishes.mode.choose('unwrap');
    else this.seams.cutFurther();
  }

  private locked(what: string): void {
    this.marked(what);
    // The run in flight would move the chart that was just locked.
    if (this.session.isBusy) this.session.refresh();
  }

  /** Locking and pinning change nothing on screen. */
  private marked(what: string): void {
    const { outcome } = this;
    this.history.change(this.wishes.settings, what);
    if (this.session.isBusy || !outcome) return;
    this.history.settle(outcome);
    this.visit.keep(outcome, this.wishes.marks);
  }

  /** How a chart follows a pin. */
  private weights({ positions, indices, texcoords }: ChartMesh, pins: number[]) {
    const layout = { positions, indices, texcoords };
    return this.session.aside(
      async (abflat, _, signal) => (await abflat.pinWeights(layout, pins, { signal })).weights,
      new AbortController().signal,
    );
  }

  /** Returns to an earlier step, or to one that was undone. */
  private goBack({ settings, outcome }: Step, said: string): void {
    this.methods.leave();
    this.ask(settings);
    if (settings.mode === 'flatten') this.sweep.use(settings);
    this.said = said;
    this.say(said);
    if (!outcome) {
      this.session.refresh();
      return;
    }
    document.body.setAttribute('aria-busy', 'true');
    void this.session.restore(outcome);
  }

  /** Shows other settings. */
  private ask(settings: Settings): void {
    const isOther = settings.mode !== this.wishes.mode.mode;
    if (isOther) this.leaveMode();
    this.wishes.restore(settings);
    if (isOther) this.showMode();
    this.painting?.update();
  }

  /** The address of the page got other settings. */
  private follow(settings: Settings): void {
    this.history.change(settings, 'Settings of a link');
    this.goBack({ text: '', settings, outcome: null }, '');
    this.visit.takeRemarks().forEach(this.notice.add, this.notice);
  }

  started(source: Source, settings: Settings | null): void {
    this.methods.leave();
    const { doing, verb } = WORDS[this.wishes.mode.mode];
    this.run.start(
      settings ? `${doing} with ${settingsText(settings)}` : `Reading ${titleOf(source)}`,
      verb,
    );
    this.again = () => this.session.refresh();
    // On a first visit, the layout comes before what its seams are edited with.
    const isFirst = source.kind === 'sample' && this.outcome === null;
    if (settings?.mode === 'unwrap' && !isFirst) void this.seams.prepare();
    document.body.setAttribute('aria-busy', 'true');
    this.markStale(settings ?? this.wishes.settings);
  }

  progress(progress: AnyProgress): void {
    this.run.progress(progress);
  }

  opened(opened: Opened): void {
    const { source, mesh, summary, drawing, gltf } = opened;
    hideAlert();
    this.wishes.open({ mesh, summary, name: source.name });
    const asked = this.visit.opened(opened);
    if (asked) this.ask(asked);
    this.history.begin(`Open ${titleOf(source)}`, this.wishes.settings);
    this.saving.open(source);
    this.arranging?.show(null);
    this.painting?.show(null);
    this.shown = source;
    this.tabs.show(source);
    if (source.kind === 'file') {
      this.notice.show(source, gltf?.compressions ?? [], this.tabs.has(source));
      this.welcome.done();
    } else this.notice.hide();
    for (const remark of this.visit.takeRemarks()) this.notice.add(remark);
    if (this.views) void this.look.open(opened, this.views);
    this.views?.showMesh(drawing);
    this.sweep.clear();
    this.sweep.use(this.wishes.disk);
    this.methods.clear();
    this.wishes.bound.setBoundaryVertices(null);
    this.showOpenSample();
    this.showTitle(source);
    element('mesh-info', HTMLElement).textContent = facesText(mesh, summary);
    this.markStale();
  }

  laidOut(outcome: Outcome, drawing: FlatDrawing): void {
    const { report } = outcome.result;
    this.show(outcome, drawing);
    this.rest.load();
    const { badge } = verdictOf(outcome);
    const but = badge === 'Valid' ? '' : `, ${badge.toLowerCase()}`;
    const time = duration(report.timings.total);
    const { done } = WORDS[outcome.mode];
    const what = isOnlyPlaced(outcome)
      ? `${this.said}, checked in ${time}${but}`
      : `${done} in ${time}${but}${kept(outcome)}`;
    this.finish(this.visit.takeSaid() || what, false);
  }

  restored(outcome: Outcome, drawing: FlatDrawing): void {
    this.show(outcome, drawing);
    this.finish(this.said, false);
  }

  private show(outcome: Outcome, drawing: FlatDrawing): void {
    hideAlert();
    this.history.settle(outcome);
    this.outcome = outcome;
    this.drawing = drawing;
    this.showResult(outcome, drawing);
    this.metrics.show(outcome);
    this.copyReport.show(outcome);
    this.showDetails(outcome);
    this.saving.show(outcome, drawing);
    this.markStale(outcome.settings);
    this.visit.keep(outcome, this.wishes.marks);
  }

  private showDetails(outcome: Outcome): void {
    const { settings } = this.wishes;
    const wanted = settings.mode === 'unwrap' ? settings : {};
    this.arranging?.show(outcome.mode === 'unwrap' ? outcome : null, wanted);
    this.painting?.show(outcome);
    if (outcome.mode === 'unwrap') {
      this.wishes.locks.show(outcome);
      this.charts.show(outcome.result.report, this.drawing?.chartColors ?? null);
      this.seams.show(outcome);
      return;
    }
    const chart = foundChart(outcome);
    this.solver.show(chart);
    this.sweep.setCurrent(chart.t);
    this.wishes.bound.setBoundaryVertices(chart.boundaryVertices);
    if (outcome.settings.t === 'auto') this.wishes.bound.showFound(chart);
  }

  cancelled(): void {
    this.visit.giveUp();
    this.showOpenSample();
    // Without a mesh there is nothing to do again.
    const isStale = this.markStale();
    this.finish('Cancelled', this.shown !== null && (isStale || this.outcome === null));
    this.saving.name(isStale);
  }

  failed(source: Source, settings: Settings | null, error: Error): void {
    const isStale = this.markStale();
    const isLost = error instanceof Lost;
    if (!isLost && this.visit.failed(source, error.message)) {
      this.openFirst(null);
      return;
    }
    const details = [isLost ? error.detail : '', this.stillShown(isStale)];
    showAlert(failure(source, settings, error.message), details.filter(Boolean).join(' '));
    this.showOpenSample();
    if (settings === null) this.finish(`${titleOf(source)} was not opened`, isStale);
    else this.finish(`Not ${WORDS[settings.mode].done.toLowerCase()}`, false);
    if (isLost) this.offer(source, settings);
    this.saving.name(isStale);
  }

  /** Offers to repeat what failed through no fault of the mesh. */
  private offer(source: Source, settings: Settings | null): void {
    this.again = () => (settings ? this.session.refresh() : void this.session.open(source));
    this.run.offer('Try again');
  }

  /** `isStale`: other settings have been asked for since. */
  private stillShown(isStale: boolean): string {
    if (!this.outcome) return '';
    return `Still showing ${isStale ? this.owner() : titleOf(this.outcome.source)}.`;
  }

  private finish(text: string, canRepeat: boolean): void {
    document.body.removeAttribute('aria-busy');
    this.run.finish(text, canRepeat);
    if (this.refusal) this.refuse(this.refusal);
  }

  private refuse(reason: string): void {
    this.refusal = this.session.isBusy ? reason : '';
    showAlert(reason, this.stillShown(this.markStale()));
    this.say('Nothing was opened');
  }

  private owner(): string {
    return this.outcome ? ownerOf(this.outcome) : '';
  }

  /**
   * Marks layout and numbers if they do not belong to the mesh on screen and its settings; returns
   * whether that is so.
   */
  private markStale(settings: Settings = this.wishes.settings): boolean {
    return this.staleMark.show(this.outcome, this.shown, settings);
  }

  private showResult(outcome: Outcome, drawing: FlatDrawing): void {
    this.views?.showOutcome(outcome, drawing);
    element('layout-info', HTMLElement).textContent = layoutInfo(outcome);
  }

  /** Shows the layout of another method; null: the result again. */
  private showMethod(method: MethodResult | null, comparison: Comparison): void {
    const { outcome, drawing } = this;
    if (!method) {
      this.shownMethod.hide();
      if (outcome && drawing) this.showResult(outcome, drawing);
    } else if (outcome)
      void this.shownMethod.show(method, comparison, outcome, () => this.outcome === outcome);
  }

  private backToResult(): void {
    this.methods.leave();
    element('layout-canvas', HTMLCanvasElement).focus();
  }

  private showNotes(): void {
    const isAtlas = this.outcome?.mode === 'unwrap';
    this.details.openAt(isAtlas ? 'charts' : 'solver');
    element(isAtlas ? 'atlas-notes' : 'notes', HTMLElement).scrollIntoView({ block: 'nearest' });
  }

  /** Leaves out a sample that was chosen but could not be read, or was cancelled. */
  private showOpenSample(): void {
    showSample(this.shown?.kind === 'sample' ? this.shown.name : null);
  }

  private showTitle(source: Source): void {
    const title = titleOf(source);
    const label = element('source', HTMLElement);
    // The list already shows a sample's name.
    label.textContent = source.kind === 'file' ? title : '';
    label.title = title;
    document.title = `${title} \u2013 abflat`;
  }
}
