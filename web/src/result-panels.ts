import type { Comparison, MethodResult } from 'abflat';
import { element, showText } from './base/dom';
import { loadPart, reasonOf } from './base/load-part';
import { ChartsTab, type ChartsTabEvents } from './details/charts-tab';
import { CopyReport } from './details/copy-report';
import { Details, type Tab } from './details/details';
import { IslandsTab } from './details/islands-tab';
import { MethodsTab } from './details/methods-tab';
import { type MetricsEvents, MetricsPanel } from './details/metrics';
import type { ObjectsTab } from './details/objects-tab';
import { SolverTab } from './details/solver-tab';
import { SweepTab } from './details/sweep-tab';
import type { VerifyTab } from './details/verify-tab';
import type { LayoutControls } from './layout-controls';
import type { FlatDrawing } from './model/drawing';
import { foundChart } from './model/found-chart';
import type { Outcome, Source } from './model/model';
import type { Mode, Settings } from './model/settings';
import type { SelectionPanel } from './selection/selection-panel';
import type { Session } from './session/session';
import { flattenIfPossible } from './session/sweep';
import { titleOf } from './session/titles';
import { layoutInfo } from './session/words';
import { ShownMethod } from './shown/shown-method';
import { ownerOf, StaleMark } from './shown/stale-mark';
import type { ChartStates } from './view/chart-flags';
import type { Views } from './view/views';
import { SHOWN } from './words/view';
import type { Workshop } from './workshop/workshop';

export interface ResultEvents extends Pick<MetricsEvents, 'help'>, Pick<ChartsTabEvents, 'locked'> {
  /** What selects charts; undefined if nothing is drawn. */
  selection(): SelectionPanel | undefined;
  say(text: string): void;
}

/** Where the notes of each kind of layout are. */
const NOTES: Record<Mode, { tab: Tab; notes: string }> = {
  flatten: { tab: 'solver', notes: 'notes' },
  unwrap: { tab: 'charts', notes: 'atlas-notes' },
  pack: { tab: 'islands', notes: 'islands-notes' },
};

export const objectsTab = () => loadPart(import('./details/objects-tab'));
export const verifyTab = () => loadPart(import('./details/verify-tab'));

/** The last result: its layout, its numbers and its details. */
export class ResultPanels {
  private readonly details = new Details(
    (tab) => {
      if (tab === 'methods') this.leaveMethod();
    },
    (tab) => {
      if (tab === 'verify') void this.offerVerify();
    },
  );
  private readonly metrics: MetricsPanel;
  private readonly staleMark: StaleMark;
  private readonly copyReport: CopyReport;
  private readonly solver = new SolverTab();
  private readonly charts: ChartsTab;
  private readonly islands: IslandsTab;
  /** Loaded with the first mesh that has objects. */
  private objects: ObjectsTab | null = null;
  /** Loaded when its tab is first chosen. */
  private verify: VerifyTab | null = null;
  private readonly sweep: SweepTab;
  private readonly methods: MethodsTab;
  private readonly shownMethod: ShownMethod;
  /** The mesh in the 3D view. */
  private shown: Source | null = null;
  private last: { outcome: Outcome; drawing: FlatDrawing } | null = null;

  constructor(
    private readonly session: Session,
    private readonly workshop: Workshop,
    private readonly controls: LayoutControls,
    private readonly views: Views | null,
    private readonly events: ResultEvents,
  ) {
    this.metrics = new MetricsPanel({
      showNotes: () => this.showNotes(),
      help: (remedy) => events.help(remedy),
      showWorst: views ? (measure) => views.showWorst(measure) : undefined,
    });
    this.staleMark = new StaleMark(this.metrics);
    this.copyReport = new CopyReport((text) => events.say(text));
    this.charts = new ChartsTab(views, controls.locks, {
      chosen: (chart) => events.selection()?.pick(chart),
      locked: (what) => events.locked(what),
      packAgain: () => this.packAgain(),
      say: (text) => events.say(text),
    });
    this.islands = new IslandsTab({
      pointed: (island) => views?.lightChart(island),
      chosen: (island) => {
        views?.goToCharts([island]);
        events.selection()?.pick(island);
      },
      say: (text) => events.say(text),
    });
    this.sweep = new SweepTab(
      (t, signal) =>
        session.aside(
          (abflat, input, signal) =>
            flattenIfPossible(abflat, input, { ...controls.disk, t }, signal),
          signal,
        ),
      (t) => controls.bound.choose(t),
    );
    this.methods = new MethodsTab(
      (signal, onProgress) =>
        session.aside(
          (abflat, input, signal) => abflat.compare(input, { signal, onProgress }),
          signal,
        ),
      (method, comparison) => this.showMethod(method, comparison),
    );
    this.shownMethod = new ShownMethod(workshop, this.metrics, views);
    element('method-back', HTMLButtonElement).addEventListener('click', () => {
      this.leaveMethod();
      element('layout-canvas', HTMLCanvasElement).focus();
    });
  }

  /** The last result of the mesh on screen; null if there is none yet. */
  get outcome(): Outcome | null {
    return this.last?.outcome ?? null;
  }

  setMode(mode: Mode): void {
    this.details.setMode(mode);
    if (mode === 'flatten') this.sweep.offer();
  }

  /** The other kind of layout is wanted. */
  leaveMode(): void {
    this.leaveMethod();
    this.methods.stop();
    this.sweep.stop();
    this.verify?.show(null);
  }

  /** Shows the result again, if another method is shown; returns whether one was. */
  leaveMethod(): boolean {
    return this.methods.leave();
  }

  /** Returns whether there was anything to stop or leave. */
  stop(): boolean {
    return (
      this.sweep.stop() || this.methods.stop() || Boolean(this.verify?.stop()) || this.leaveMethod()
    );
  }

  /** Another mesh is on screen; it has no result yet. */
  open(source: Source): void {
    this.shown = source;
    this.clear();
    this.sweep.clear();
    this.use(this.controls.disk);
    this.methods.clear();
    this.controls.bound.setBoundaryVertices(null);
    this.markStale();
  }

  /** Nothing of the mesh before stays beside the one on screen. */
  private clear(): void {
    this.last = null;
    this.views?.clearLayout();
    showText(element('layout-info', HTMLElement), '');
    this.metrics.clear();
    this.copyReport.clear();
    this.charts.clear();
    this.islands.clear();
    void this.objects?.show(null);
    this.verify?.show(null);
    this.solver.clear();
  }

  /** Other settings are wanted. With another t alone, the plot against t stays as it is. */
  use(settings: Settings): void {
    if (settings.mode === 'flatten') this.sweep.use(settings);
  }

  show(outcome: Outcome, drawing: FlatDrawing): void {
    this.last = { outcome, drawing };
    this.showLayout(outcome, drawing);
    this.metrics.show(outcome, drawing);
    this.copyReport.show(outcome);
    this.showDetails(outcome, drawing);
    this.markStale(outcome.settings);
  }

  packAgain(): void {
    const { outcome } = this;
    if (outcome?.mode === 'unwrap') this.controls.packAgain(outcome);
  }

  showStates(states: ChartStates): void {
    this.charts.showSelected(states.selected);
    this.islands.showSelected(states.selected);
    this.objects?.showStates(states);
    this.verify?.showSelected(states.selected);
  }

  /**
   * Marks layout and numbers if they do not belong to the mesh on screen and its settings; returns
   * whether that is so.
   */
  markStale(settings: Settings = this.controls.settings): boolean {
    return this.staleMark.show(this.outcome, this.shown, settings);
  }

  /** Whose layout is on screen, for display. `isStale`: other settings have been asked for since. */
  stillShown(isStale: boolean): string {
    const { outcome } = this;
    if (!outcome) return '';
    return SHOWN.stillShown(isStale ? ownerOf(outcome) : titleOf(outcome.source));
  }

  private showLayout(outcome: Outcome, drawing: FlatDrawing): void {
    this.views?.showOutcome(outcome, drawing);
    showText(element('layout-info', HTMLElement), layoutInfo(outcome));
  }

  private showDetails(outcome: Outcome, { areas, chartColors }: FlatDrawing): void {
    const { bound, locks } = this.controls;
    if (this.verify && outcome.mode !== 'flatten') void this.offerVerify();
    if (outcome.mode === 'unwrap') {
      locks.show(outcome);
      this.charts.show(outcome, chartColors);
      void this.showObjects(outcome);
      return;
    }
    if (outcome.mode === 'pack') {
      this.islands.show(outcome, areas);
      void this.showObjects(outcome);
      return;
    }
    const chart = foundChart(outcome);
    this.solver.show(chart);
    this.sweep.setCurrent(chart.t);
    bound.setBoundaryVertices(chart.boundaryVertices);
    if (outcome.settings.t === 'auto') bound.showFound(chart);
  }

  /** What the page has made has no objects. */
  private async showObjects({ source }: Outcome): Promise<void> {
    const { say, selection } = this.events;
    const selecting = selection();
    if (!selecting || (source.kind === 'sample' && !this.objects)) return;
    try {
      const { ObjectsTab } = await objectsTab();
      this.objects ??= new ObjectsTab(selecting, this.workshop, {
        offered: (objects, materials) => {
          this.details.offerObjects(objects + materials > 1);
          this.controls.offerParts(objects > 1, materials > 1);
        },
        say,
      });
      await this.objects.show(this.outcome);
    } catch (error) {
      say(reasonOf(error as Error));
    }
  }

  private async offerVerify(): Promise<void> {
    try {
      const { VerifyTab } = await verifyTab();
      this.verify ??= new VerifyTab(this.session, this.views, this.events);
      this.verify.show(this.last);
    } catch (error) {
      this.events.say(reasonOf(error as Error));
    }
  }

  /** Shows the layout of another method; null: the result again. */
  private showMethod(method: MethodResult | null, comparison: Comparison): void {
    const { last } = this;
    if (!method) {
      this.shownMethod.hide();
      if (last) this.showLayout(last.outcome, last.drawing);
    } else if (last)
      void this.shownMethod.show(
        method,
        comparison,
        last.outcome,
        () => this.outcome === last.outcome,
      );
  }

  private showNotes(): void {
    const { tab, notes } = NOTES[this.outcome?.mode ?? 'flatten'];
    this.details.openAt(tab);
    element(notes, HTMLElement).scrollIntoView({ block: 'nearest' });
  }
}
