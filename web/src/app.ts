import type { Abflat, Comparison, MethodResult } from 'abflat';
import { hideAlert, showAlert } from './base/alert';
import { bindToggle, element } from './base/dom';
import { duration } from './base/format';
import { Lost } from './base/lost';
import { bindShortcuts } from './base/shortcuts';
import { bindTheme } from './base/theme';
import { AtlasControl } from './controls/atlas-control';
import { BalanceControl } from './controls/balance-control';
import { BoundControl } from './controls/bound-control';
import { ModeSwitch } from './controls/mode-switch';
import { Notice } from './controls/notice';
import { RunPanel } from './controls/run-panel';
import { TexcoordChoice } from './controls/texcoord-choice';
import { ChartsTab } from './details/charts-tab';
import { CopyReport } from './details/copy-report';
import { Details } from './details/details';
import { Locks } from './details/locks';
import { MethodsTab } from './details/methods-tab';
import { MetricsPanel } from './details/metrics';
import { SolverTab } from './details/solver-tab';
import { SweepTab } from './details/sweep-tab';
import { isAutomatic, type Remedy, verdictOf } from './details/verdict';
import { ExportControl } from './export/export-control';
import { Exporter } from './export/exporter';
import { LayoutBar } from './export/layout-bar';
import { HelpSheet } from './help/help-sheet';
import { Welcome } from './help/welcome';
import type { FlatDrawing } from './model/drawing';
import type { AnyProgress, Opened, Outcome, Source } from './model/model';
import { type FlattenSettings, type Settings, sameSettings } from './model/settings';
import { SeamPanel } from './seams/seam-panel';
import { SelectionPanel } from './selection/selection-panel';
import { bindOpen, FIRST_SAMPLE, showSample, titleOf } from './session/open-mesh';
import { Session, type SessionEvents } from './session/session';
import { flattenIfPossible } from './session/sweep';
import { facesText, failure, kept, layoutInfo, settingsText, WORDS } from './session/words';
import { ShownLook } from './shown-look';
import type { Views } from './view/views';
import { Workshop } from './workshop/workshop';

/** Connects the session with what is on the page. */
export class App implements SessionEvents {
  private readonly workshop = new Workshop();
  private readonly session: Session;
  private readonly say = (text: string) => this.run.say(text);
  private readonly bound = new BoundControl(() => this.session.refresh(), this.say);
  private readonly balance = new BalanceControl('flatten', () => {
    this.sweep.clear();
    this.session.refresh();
  });
  private readonly atlas = new AtlasControl(() => this.session.refresh(), this.say);
  private readonly mode = new ModeSwitch(() => this.modeChanged());
  private readonly details = new Details((tab) => {
    if (tab === 'methods') this.methods.leave();
  });
  private readonly metrics: MetricsPanel;
  private readonly solver = new SolverTab();
  private readonly charts: ChartsTab;
  private readonly locks = new Locks();
  private readonly seams: SeamPanel;
  private readonly selection: SelectionPanel | null;
  private readonly sweep = new SweepTab(
    (t, signal) =>
      this.session.aside(
        (abflat, input, signal) =>
          flattenIfPossible(abflat, input, { ...this.diskSettings, t }, signal),
        signal,
      ),
    (t) => this.bound.choose(t),
  );
  private readonly methods = new MethodsTab(
    (signal, onProgress) =>
      this.session.aside(
        (abflat, input, signal) => abflat.compare(input, { signal, onProgress }),
        signal,
      ),
    (method, comparison) => void this.showMethod(method, comparison),
  );
  private readonly run = new RunPanel(
    () =>
      this.session.cancel() ||
      this.exporter.stop() ||
      this.sweep.stop() ||
      this.methods.stop() ||
      this.methods.leave(),
    () => this.again(),
  );
  private readonly layoutBar = new LayoutBar(this.workshop, {
    say: this.say,
    failed: (outcome, error) => this.notSaved(outcome, error),
  });
  private readonly notice = new Notice((source) => void this.session.open(source));
  private readonly look = new ShownLook(this.workshop, this.notice);
  private readonly texcoordChoice = new TexcoordChoice();
  private readonly exporter: Exporter;
  private readonly exportControl = new ExportControl({
    export: () => this.export(),
    formatChanged: () => this.showTexcoordChoice(false),
  });
  private readonly copyReport = new CopyReport(this.say);
  private readonly help = new HelpSheet();
  private readonly welcome = new Welcome();
  private readonly layoutNote = element('layout-note', HTMLElement);
  /** The mesh in the 3D view. */
  private shown: Source | null = null;
  private delaunay = false;
  /** The method whose layout is shown. */
  private method: MethodResult | null = null;
  /** The last result. */
  private outcome: Outcome | null = null;
  /** What the button beside the last run does. */
  private again: () => void = () => this.session.refresh();
  /** The drawing of the last result. */
  private drawing: FlatDrawing | null = null;

  constructor(
    abflat: () => Promise<Abflat>,
    private readonly views: Views | null,
  ) {
    this.session = new Session(abflat, this, () => this.settings, this.workshop);
    this.metrics = new MetricsPanel({
      showNotes: () => this.showNotes(),
      help: (remedy) => this.remedy(remedy),
      showWorst: views ? (measure) => views.showWorst(measure) : undefined,
    });
    this.exporter = new Exporter(this.session, this.workshop, {
      say: this.say,
      failed: ({ outcome }, error) => this.notSaved(outcome, error),
    });
    this.charts = new ChartsTab(views, this.locks, {
      chosen: (chart) => this.selection?.pick(chart),
      // The run in flight would move the chart that was just locked.
      locked: () => this.session.isBusy && this.session.refresh(),
      packAgain: () => this.session.refresh(),
    });
    this.seams = new SeamPanel(views?.mesh ?? null, this.workshop, {
      changed: () => {
        this.showCutting();
        this.session.refresh();
      },
      say: this.say,
    });
    this.selection =
      views &&
      new SelectionPanel(views, {
        isFree: () => this.seams.isIdle,
        changed: (selected) => this.charts.showSelected(selected),
      });
    bindTheme(element('theme', HTMLButtonElement), () => this.views?.updateTheme());
    bindOpen({
      open: (source) => void this.session.open(source),
      refused: (reason) => {
        showAlert(reason, this.stillShown(this.markStale()));
        this.say('Nothing was opened');
      },
    });
    bindShortcuts({
      'Ctrl+O': () => element('open', HTMLButtonElement).click(),
      'Ctrl+S': () => element('export', HTMLButtonElement).click(),
      'Ctrl+E': () => this.exportControl.openMenu(),
      '?': () => this.help.open(),
    });
    element('method-back', HTMLButtonElement).addEventListener('click', () => this.backToResult());
    bindToggle('delaunay', (isOn) => {
      this.delaunay = isOn;
      this.sweep.clear();
      this.session.refresh();
    });
    this.showMode();
    void this.session.open({ kind: 'sample', name: FIRST_SAMPLE });
  }

  private get settings(): Settings {
    if (this.mode.mode === 'flatten') return this.diskSettings;
    return { ...this.atlas.settings, ...this.seams.options, kept: this.locks.kept };
  }

  private get diskSettings(): FlattenSettings {
    return {
      mode: 'flatten',
      t: this.bound.t,
      balance: this.balance.balance,
      delaunay: this.delaunay,
    };
  }

  /** Switches the page to the other kind of layout. */
  private modeChanged(): void {
    this.methods.leave();
    this.methods.stop();
    this.sweep.stop();
    this.seams.hide();
    this.showMode();
    this.session.refresh();
  }

  private showMode(): void {
    const { mode } = this.mode;
    this.details.setMode(mode);
    this.layoutBar.setMode(mode);
    element('delaunay', HTMLButtonElement).hidden = mode === 'unwrap';
  }

  private showCutting(): void {
    this.atlas.setCutting(isAutomatic(this.seams.options.seams));
  }

  private remedy(remedy: Remedy): void {
    if (remedy === 'unwrap') this.mode.choose('unwrap');
    else this.seams.cutFurther();
  }

  started(source: Source, settings: Settings | null): void {
    this.methods.leave();
    const { doing, verb } = WORDS[this.mode.mode];
    this.run.start(
      settings ? `${doing} with ${settingsText(settings)}` : `Reading ${titleOf(source)}`,
      verb,
    );
    this.again = () => this.session.refresh();
    if (settings?.mode === 'unwrap') this.prepareSeams();
    document.body.setAttribute('aria-busy', 'true');
    this.markStale(settings ?? this.settings);
  }

  private prepareSeams(): void {
    this.seams
      .prepare()
      .catch(({ message }: Error) => this.say(`Seams cannot be edited: ${message}`));
  }

  progress(progress: AnyProgress): void {
    this.run.progress(progress);
  }

  opened(opened: Opened): void {
    const { source, mesh, summary, drawing, gltf } = opened;
    hideAlert();
    this.atlas.open(summary);
    this.mode.setDisk(summary.disk);
    this.seams.open({ mesh, summary, name: source.name });
    this.showCutting();
    this.locks.clear();
    this.exporter.stop();
    this.exportControl.open(source);
    this.shown = source;
    if (source.kind === 'file') {
      this.notice.show(source, gltf?.compressions ?? []);
      this.welcome.done();
    } else this.notice.hide();
    if (this.views) void this.look.open(opened, this.views);
    this.views?.showMesh(drawing);
    this.sweep.clear();
    this.methods.clear();
    this.bound.setBoundaryVertices(null);
    this.showOpenSample();
    this.showTitle(source);
    element('mesh-info', HTMLElement).textContent = facesText(mesh, summary);
    this.updateExport(true);
    this.markStale();
  }

  laidOut(outcome: Outcome, drawing: FlatDrawing): void {
    const { report } = outcome.result;
    hideAlert();
    this.outcome = outcome;
    this.drawing = drawing;
    this.showResult(outcome, drawing);
    this.metrics.show(outcome);
    this.copyReport.show(outcome);
    this.showDetails(outcome);
    this.updateExport();
    this.markStale(outcome.settings);
    const { badge } = verdictOf(outcome);
    const but = badge === 'Valid' ? '' : `, ${badge.toLowerCase()}`;
    const { done } = WORDS[outcome.mode];
    this.finish(`${done} in ${duration(report.timings.total)}${but}${kept(outcome)}`, false);
  }

  private showDetails(outcome: Outcome): void {
    this.selection?.open(outcome.mode === 'unwrap' ? outcome.result.report : null);
    if (outcome.mode === 'unwrap') {
      this.locks.show(outcome);
      this.charts.show(outcome.result.report, this.drawing?.chartColors ?? null);
      this.seams.show(outcome);
      return;
    }
    const [chart] = outcome.result.report.charts;
    this.solver.show(chart);
    this.sweep.setCurrent(chart.t);
    this.bound.setBoundaryVertices(chart.boundaryVertices);
    if (outcome.settings.t === 'auto') this.bound.showFound(chart);
  }

  cancelled(): void {
    this.showOpenSample();
    // Without a mesh there is nothing to do again.
    const isStale = this.markStale();
    this.finish('Cancelled', this.shown !== null && (isStale || this.outcome === null));
    this.nameExport(isStale);
  }

  failed(source: Source, settings: Settings | null, error: Error): void {
    const isStale = this.markStale();
    const isLost = error instanceof Lost;
    const details = [isLost ? error.detail : '', this.stillShown(isStale)];
    showAlert(failure(source, settings, error.message), details.filter(Boolean).join(' '));
    this.showOpenSample();
    if (settings === null) this.finish(`${titleOf(source)} was not opened`, isStale);
    else this.finish(`Not ${WORDS[settings.mode].done.toLowerCase()}`, false);
    if (isLost) this.offer(source, settings);
    this.nameExport(isStale);
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
  }

  /** Names the mesh and settings that the last result belongs to, for display. */
  private owner(): string {
    if (!this.outcome) return '';
    return `${titleOf(this.outcome.source)}, ${settingsText(this.outcome.settings)}`;
  }

  /**
   * Marks layout and numbers if they do not belong to the mesh on screen and its settings; returns
   * whether that is so.
   */
  private markStale(settings: Settings = this.settings): boolean {
    const isStale =
      this.outcome !== null &&
      (this.outcome.source !== this.shown || !sameSettings(this.outcome.settings, settings));
    if (isStale) this.layoutNote.textContent = `Still showing ${this.owner()}`;
    this.layoutNote.hidden = !isStale;
    element('layout-stage', HTMLElement).classList.toggle('stale', isStale);
    this.metrics.markStale(isStale ? this.owner() : null);
    return isStale;
  }

  private showResult(outcome: Outcome, drawing: FlatDrawing): void {
    this.views?.showOutcome(outcome, drawing);
    element('layout-info', HTMLElement).textContent = layoutInfo(outcome);
  }

  /**
   * Shows the layout of another method in place of the result, which is still what gets exported;
   * null: the result again.
   */
  private async showMethod(method: MethodResult | null, comparison: Comparison): Promise<void> {
    this.method = method;
    const { outcome, drawing } = this;
    if (!method) {
      element('method-note', HTMLElement).hidden = true;
      this.metrics.markStale(null);
      if (outcome && drawing) this.showResult(outcome, drawing);
      return;
    }
    if (!outcome) return;
    const layout = { ...comparison, uv: method.uv };
    const other = await this.workshop.layout(layout, outcome.mesh, null);
    if (this.method !== method || this.outcome !== outcome) return;
    element('method-note', HTMLElement).hidden = false;
    this.metrics.markStale(this.owner());
    this.views?.showFlat(other, { ...method, bounds: [], delaunay: null });
    element('layout-info', HTMLElement).textContent = method.title;
    element('method-note-text', HTMLElement).textContent =
      `Comparison, not exported: ${method.title}`;
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

  /** The last result, where it is of the mesh on screen. */
  private get current(): Outcome | null {
    return this.outcome?.source === this.shown ? this.outcome : null;
  }

  private showTexcoordChoice(isNew: boolean): void {
    this.texcoordChoice.show(this.exportControl.format === 'glb' ? this.current : null, isNew);
  }

  /** Only what belongs to the mesh on screen is exported. */
  private updateExport(isNew = false): void {
    const { current, drawing } = this;
    const chartColors = drawing?.chartColors;
    this.exportControl.isDisabled = current === null;
    this.showTexcoordChoice(isNew);
    this.nameExport(false);
    const isAtlas = current?.mode === 'unwrap' && chartColors;
    this.layoutBar.show(isAtlas ? { outcome: current, chartColors } : null);
  }

  /**
   * `isStale`: the exported layout would be of earlier settings, and no run is about to replace it.
   */
  private nameExport(isStale: boolean): void {
    this.exportControl.name(isStale ? this.owner() : null);
  }

  private export(): void {
    const { outcome } = this;
    if (!outcome) return;
    const { format, title } = this.exportControl;
    // The button's title says if the layout is an earlier one.
    this.exporter.export({ outcome, format, texcoord: this.texcoordChoice.texcoord }, title);
  }

  private notSaved({ source, settings }: Outcome, { message }: Error): void {
    const text = `${titleOf(source)} was not saved: ${message.replace(/\.$/, '')}.`;
    showAlert(text, settingsText(settings));
  }
}
