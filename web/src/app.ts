import type { Abflat } from 'abflat';
import { hideAlert, showAlert } from './base/alert';
import { element } from './base/dom';
import { Lost } from './base/lost';
import { bindShortcuts } from './base/shortcuts';
import { bindTheme } from './base/theme';
import { ReadTexcoord } from './controls/read-texcoord';
import { RunPanel } from './controls/run-panel';
import { plots } from './details/late-chart';
import { methodTables } from './details/methods-tab';
import type { Remedy } from './details/remedy';
import { verdictOf } from './details/verdict';
import { HandTools } from './hand-tools';
import { HelpSheet, helpParts } from './help/help-sheet';
import { LaterParts } from './later-parts';
import { LayoutControls } from './layout-controls';
import { Meshes } from './meshes';
import type { FlatDrawing } from './model/drawing';
import {
  type AnyProgress,
  hasUvs,
  isSameFile,
  type Opened,
  type Outcome,
  type Source,
} from './model/model';
import { isByHand, type Settings } from './model/settings';
import { FIRST_SAMPLE } from './opening/open-mesh';
import { objectsTab, ResultPanels, verifyTab } from './result-panels';
import { exportParts, Saving } from './saving';
import { SeamPanel } from './seams/seam-panel';
import { stackParts } from './session/lay-out';
import { type Left, LeftMeshes } from './session/left-meshes';
import { Session, type SessionEvents, type Shown } from './session/session';
import type { Step } from './session/steps';
import { titleOf } from './session/titles';
import {
  failure,
  isOnlyPlaced,
  isPackedAgain,
  kept,
  layingOut,
  settingsText,
} from './session/words';
import { ownImages } from './shown/shown-image';
import type { Views } from './view/views';
import { LastVisit } from './visit/last-visit';
import { PageHistory } from './visit/page-history';
import { Unsaved } from './visit/unsaved';
import { duration, ended } from './words/format';
import { BADGES } from './words/result';
import { CHANGES, RUN } from './words/run';
import { MOVING } from './words/selection';
import { Workshop } from './workshop/workshop';

/** Connects the session with what is on the page. */
export class App implements SessionEvents {
  private readonly workshop = new Workshop();
  private readonly session: Session;
  private readonly say = (text: string) => this.run.say(text);
  private readonly controls: LayoutControls;
  private readonly visit = new LastVisit((settings) => this.follow(settings));
  private readonly history = new PageHistory((step, said) => this.goBack(step, said));
  /** Those open in other tabs. */
  private readonly left = new LeftMeshes();
  private readonly unsaved = new Unsaved(() => this.meshes.updateTabs());
  private readonly readTexcoord = new ReadTexcoord((source) => void this.session.open(source));
  private readonly result: ResultPanels;
  private readonly seams: SeamPanel;
  private readonly tools: HandTools | null;
  private readonly run = new RunPanel(
    () => this.meshes.stop() || this.session.cancel() || this.saving.stop() || this.result.stop(),
    () => this.again(),
  );
  private readonly meshes: Meshes;
  private readonly saving: Saving;
  private readonly help = new HelpSheet();
  private readonly later = new LaterParts([
    () => this.workshop.loadRest(),
    () => this.seams.loadRest(),
    () => this.controls.loadRest(),
    async () => this.tools?.loadRest(),
    stackParts,
    plots,
    methodTables,
    helpParts,
    exportParts,
    objectsTab,
    verifyTab,
    ownImages,
  ]);
  /** What the button beside the last run does. */
  private again: () => void = () => this.session.refresh();
  /** Why nothing was opened, if that was said during a run: the run's end hides what was said. */
  private refusal = '';
  /** What the user has done, where the result does not say it. */
  private said = '';

  constructor(abflat: () => Promise<Abflat>, views: Views | null) {
    this.seams = new SeamPanel(views?.mesh ?? null, this.workshop, {
      changed: (what) => this.controls.seamsChanged(what),
      say: this.say,
    });
    this.controls = new LayoutControls(this.seams, {
      changed: (what) => this.changed(what),
      modeChanged: () => this.modeChanged(),
      relaxIslands: () => void this.tools?.relaxIslands(),
      packSelected: (choices) => this.tools?.packIslands(choices) ?? false,
      say: this.say,
    });
    this.session = new Session(abflat, this, () => this.controls.settings, this.workshop);
    this.result = new ResultPanels(this.session, this.workshop, this.controls, views, {
      help: (remedy) => this.remedy(remedy),
      selection: () => this.tools?.selection,
      locked: (what) => this.locked(what),
      say: this.say,
    });
    this.saving = new Saving(this.session, this.workshop, views, {
      exported: (outcome) => this.unsaved.saved(outcome),
      say: this.say,
      progress: (fraction, text) => this.run.show(fraction, text),
      ended: (text) => this.ended(text),
      noted: (notes) => this.meshes.remark(notes),
    });
    this.tools =
      views &&
      new HandTools(views, this.workshop, this.session, this.controls, {
        isFree: () => this.seams.isIdle,
        seams: this.seams.editor,
        surface: () => this.seams.surface(),
        selected: (states) => {
          this.result.showStates(states);
          this.controls.showSelected(states.selected.size);
        },
        pinned: (what) => this.marked(what),
        noted: (sentences) => this.meshes.remark(sentences.map(ended)),
        notPlaced: (why) => {
          if (!this.session.isBusy) this.finish(why || MOVING.nothingMoved, false);
        },
        say: this.say,
      });
    bindTheme(element('theme', HTMLButtonElement), () => views?.updateTheme());
    this.meshes = new Meshes(abflat, this.workshop, views, {
      gathering: (fraction, text) => this.run.show(fraction, text),
      gathered: (text) => this.ended(text),
      open: (source) => {
        this.refusal = '';
        void this.session.open(source);
      },
      switchTo: (source) => void this.session.open(source, this.left.get(source)),
      closed: (source) => {
        this.left.drop(source);
        this.unsaved.drop(source);
      },
      isUnsaved: (source) => this.unsaved.has(source),
      refused: (reason) => this.refuse(reason),
      say: this.say,
    });
    bindShortcuts({
      'Ctrl+O': () => element('open', HTMLButtonElement).click(),
      'Ctrl+S': () => element('export', HTMLButtonElement).click(),
      'Ctrl+E': () => this.saving.openMenu(),
      '?': () => this.help.open(),
    });
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
      if (!this.session.isBusy && !this.meshes.shown) this.openFirst(source);
    });
  }

  private openFirst(source: Source | null): void {
    void this.session.open(source ?? { kind: 'sample', name: FIRST_SAMPLE });
  }

  /** The user wants something else. */
  private changed(what?: string): void {
    this.noteChange(what);
    this.session.refresh();
  }

  private noteChange(what?: string): void {
    const { settings } = this.controls;
    this.said = what ?? '';
    this.visit.changed();
    this.history.change(settings, what);
    this.noteWork();
    this.result.use(settings);
    this.tools?.update();
  }

  /** There may be work by hand on the mesh on screen that no file has. */
  private noteWork(): void {
    const { shown } = this.meshes;
    if (shown) this.unsaved.want(shown, this.controls.all);
  }

  /** Switches the page to the other kind of layout, as it was left unless something else is wanted of it. */
  private modeChanged(): void {
    this.leaveMode();
    this.showMode();
    const outcome = this.history.resultOf(this.controls.settings);
    this.noteChange();
    if (outcome?.source === this.meshes.shown) this.showAgain(outcome, RUN.asLeft);
    else this.session.refresh();
  }

  private leaveMode(): void {
    this.result.leaveMode();
    this.seams.hide();
    this.tools?.leaveMode();
  }

  private showMode(): void {
    const { mode } = this.controls.mode;
    this.result.setMode(mode);
    this.saving.setMode(mode);
    element('delaunay', HTMLButtonElement).hidden = mode !== 'flatten';
  }

  private remedy(remedy: Remedy): void {
    if (remedy === 'islands') this.controls.packIslands();
    else if (remedy === 'unwrap') this.controls.mode.choose('unwrap');
    else if (remedy === 'pack') this.result.packAgain();
    else this.seams.cutFurther();
  }

  private locked(what: string): void {
    this.marked(what);
    // The run in flight would move the chart that was just locked.
    if (this.session.isBusy) this.session.refresh();
  }

  /** Locking and pinning change nothing on screen. */
  private marked(what: string): void {
    const { outcome } = this.result;
    this.history.change(this.controls.settings, what);
    if (this.session.isBusy || !outcome) return;
    this.history.settle(outcome);
    this.visit.keep(outcome, this.controls.marks);
  }

  /** Returns to an earlier step, or to one that was undone. */
  private goBack({ settings, outcome }: Step, said: string): void {
    this.result.leaveMethod();
    this.ask(settings);
    this.result.use(settings);
    this.said = said;
    this.say(said);
    if (outcome) this.showAgain(outcome, said);
    else this.session.refresh();
  }

  private showAgain(outcome: Outcome, said: string): void {
    this.said = said;
    document.body.setAttribute('aria-busy', 'true');
    void this.session.restore(outcome);
  }

  /** Shows other settings. */
  private ask(settings: Settings): void {
    const isOther = settings.mode !== this.controls.mode.mode;
    if (isOther) this.leaveMode();
    this.controls.restore(settings);
    if (isOther) this.showMode();
    this.tools?.update();
    this.noteWork();
  }

  /** The address of the page got other settings. */
  private follow(settings: Settings): void {
    this.history.change(settings, CHANGES.followedLink);
    this.goBack({ text: '', settings, outcome: null }, '');
    this.meshes.remark(this.visit.takeRemarks());
  }

  started(source: Source, settings: Settings | null): void {
    this.result.leaveMethod();
    const { doing, verb } = layingOut(settings ?? this.controls.settings);
    this.run.start(
      settings ? RUN.layingOut(doing, settingsText(settings)) : RUN.reading(titleOf(source)),
      verb,
      settings?.mode ?? null,
    );
    this.again = () => this.session.refresh();
    // On a first visit, the layout comes before what its seams are edited with.
    const isFirst = source.kind === 'sample' && this.result.outcome === null;
    if (settings?.mode === 'unwrap' && !isFirst) void this.seams.prepare();
    document.body.setAttribute('aria-busy', 'true');
    this.result.markStale(settings ?? this.controls.settings);
  }

  progress(progress: AnyProgress): void {
    this.run.progress(progress);
  }

  opened(opened: Opened, before: Shown | null): void {
    const { source, mesh, summary } = opened;
    this.run.opened();
    hideAlert();
    const last = before && { ...before, history: this.history.list, settings: this.controls.all };
    const left = this.left.get(source);
    this.tools?.clear();
    this.meshes.show(opened, last?.settings.some(isByHand) ?? false);
    if (last) this.leave(last);
    const isReread = last !== null && isSameFile(last.opened.source, source);
    this.controls.open({
      mesh,
      summary,
      name: source.name,
      isReread,
      hasUvs: hasUvs(opened),
    });
    const asked = this.visit.opened(opened, left !== undefined);
    for (const settings of left?.settings ?? (asked ? [asked] : [])) this.ask(settings);
    if (left) this.history.resume(left.history);
    else this.history.begin(CHANGES.opened(titleOf(source)), this.controls.settings);
    this.left.drop(source);
    this.said = left ? RUN.shownAgain(titleOf(source)) : '';
    this.noteWork();
    this.saving.open(source);
    this.readTexcoord.open(opened);
    this.meshes.remark(this.visit.takeRemarks());
    this.result.open(source);
  }

  /** Another mesh is shown. One that is still open can be shown again as it was. */
  private leave(last: Left & Shown): void {
    const { source } = last.opened;
    if (this.meshes.has(source)) this.left.leave(last);
    else this.unsaved.drop(source);
  }

  laidOut(outcome: Outcome, drawing: FlatDrawing): void {
    const { report } = outcome.result;
    this.show(outcome, drawing);
    this.later.load();
    const { badge } = verdictOf(outcome, drawing.areas);
    const but = badge === BADGES.valid ? '' : RUN.but(badge);
    const time = duration(report.timings.total);
    const done = (isPackedAgain(outcome) && this.said) || layingOut(outcome.settings).done;
    const what = isOnlyPlaced(outcome)
      ? RUN.checked(this.said, time) + but
      : RUN.laidOut(done, time) + but + kept(outcome);
    this.finish(this.visit.takeSaid() || what, false);
  }

  restored(outcome: Outcome, drawing: FlatDrawing): void {
    if (outcome.mode === 'unwrap') void this.seams.prepare();
    this.show(outcome, drawing);
    this.finish(this.said, false);
  }

  private show(outcome: Outcome, drawing: FlatDrawing): void {
    hideAlert();
    if (this.result.outcome) this.meshes.overtake();
    this.history.settle(outcome);
    this.result.show(outcome, drawing);
    this.tools?.show(outcome);
    if (outcome.mode === 'unwrap') this.seams.show(outcome);
    this.saving.show(outcome, drawing);
    this.visit.keep(outcome, this.controls.marks);
  }

  cancelled(): void {
    this.visit.giveUp();
    this.meshes.showOpenSample();
    const isStale = this.result.markStale();
    this.finish(RUN.cancelled, this.isUnfinished(isStale));
    this.saving.name(isStale);
  }

  /** Whether the mesh on screen has no layout, or one of other settings. */
  private isUnfinished(isStale: boolean): boolean {
    return this.meshes.shown !== null && (isStale || this.result.outcome === null);
  }

  failed(source: Source, settings: Settings | null, error: Error): void {
    const isStale = this.result.markStale();
    const isLost = error instanceof Lost;
    if (!isLost && this.visit.failed(source, error.message)) {
      this.openFirst(null);
      return;
    }
    const details = [isLost ? error.detail : '', this.result.stillShown(isStale)];
    showAlert(failure(source, settings, error.message), details.filter(Boolean).join(' '));
    this.meshes.showOpenSample();
    if (settings === null) this.finish(RUN.notOpened(titleOf(source)), this.isUnfinished(isStale));
    else this.finish(RUN.notLaidOut(layingOut(settings).done), false);
    if (isLost) this.offer(source, settings);
    this.saving.name(isStale);
  }

  /** Offers to repeat what failed through no fault of the mesh. */
  private offer(source: Source, settings: Settings | null): void {
    this.again = () => (settings ? this.session.refresh() : void this.session.open(source));
    this.run.offer(RUN.tryAgain);
  }

  /** Work other than a run has ended. */
  private ended(text: string): void {
    if (this.session.isBusy) this.say(text);
    else this.finish(text, false);
  }

  private finish(text: string, canRepeat: boolean): void {
    document.body.removeAttribute('aria-busy');
    this.run.finish(text, canRepeat);
    if (this.refusal) this.refuse(this.refusal);
  }

  private refuse(reason: string): void {
    this.refusal = this.session.isBusy ? reason : '';
    showAlert(reason, this.result.stillShown(this.result.markStale()));
    this.say(RUN.nothingOpened);
  }
}
