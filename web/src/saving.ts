import { hideAlert, showAlert } from './base/alert';
import { loadPart, reasonOf } from './base/load-part';
import { TexcoordChoice } from './controls/texcoord-choice';
import { BakeOffer, bakeChoices } from './export/bake-offer';
import { ExportControl } from './export/export-control';
import { Exporter, savingParts } from './export/exporter';
import { LayoutBar } from './export/layout-bar';
import type { FlatDrawing } from './model/drawing';
import type { Outcome, Source } from './model/model';
import type { Mode } from './model/settings';
import type { Session } from './session/session';
import { titleOf } from './session/titles';
import { settingsText } from './session/words';
import { ownerOf } from './shown/stale-mark';
import type { Views } from './view/views';
import { SAVING } from './words/export';
import type { Workshop } from './workshop/workshop';

/** What saving needs beyond the first load. */
export const exportParts = () => Promise.all([savingParts(), bakeChoices()]);

export interface SavingEvents {
  /** A mesh with this layout is in a file. */
  exported(outcome: Outcome): void;
  say(text: string): void;
  progress(fraction: number, what: string): void;
  /** The work whose progress was shown has ended. */
  ended(text: string): void;
  /** What to know about a file that was written. */
  noted(notes: string[]): void;
}

/** Everything that saves a file of a result. */
export class Saving {
  private readonly exporter: Exporter;
  private readonly control = new ExportControl({
    export: () => this.export(),
    formatChanged: () => this.showTexcoordChoice(false),
    picture: () => this.savePicture(),
  });
  private readonly bar: LayoutBar;
  private readonly texcoordChoice = new TexcoordChoice();
  private readonly baking: BakeOffer;
  /** The menu says what formats lose. */
  private isLimited = false;
  /** The last result. */
  private outcome: Outcome | null = null;
  /** The mesh on screen. */
  private shown: Source | null = null;

  constructor(
    session: Session,
    workshop: Workshop,
    private readonly views: Views | null,
    private readonly events: SavingEvents,
  ) {
    const { say } = events;
    this.baking = new BakeOffer({ changed: () => this.bakingChanged(), say });
    this.exporter = new Exporter(session, workshop, {
      say,
      progress: (fraction, what) => events.progress(fraction, what),
      ended: (text) => events.ended(text),
      noted: (notes) => events.noted(notes),
      exported: ({ outcome }) => {
        hideAlert();
        events.exported(outcome);
      },
      failed: ({ outcome }, error) => this.notSaved(outcome, error),
    });
    this.bar = new LayoutBar(workshop, {
      say,
      saved: (what) => this.saved(what),
      failed: (outcome, error) => this.notSaved(outcome, error),
    });
  }

  /** Another mesh is on screen; it has no result yet. */
  open(source: Source): void {
    this.exporter.stop();
    this.control.open(source);
    this.shown = source;
    this.baking.reset();
    this.update(null, true);
  }

  /** There is a result of the mesh on screen. */
  show(outcome: Outcome, drawing: FlatDrawing): void {
    this.outcome = outcome;
    this.update(drawing.chartColors, false);
  }

  setMode(mode: Mode): void {
    this.bar.setMode(mode);
  }

  openMenu(): void {
    this.control.openMenu();
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    return this.exporter.stop();
  }

  /**
   * `isStale`: the exported layout would be of earlier settings, and no run is about to replace it.
   */
  name(isStale: boolean): void {
    this.control.name(isStale && this.outcome ? ownerOf(this.outcome) : null);
  }

  /** The last result, where it is of the mesh on screen: only that is exported. */
  private get current(): Outcome | null {
    return this.outcome?.source === this.shown ? this.outcome : null;
  }

  private update(chartColors: Float32Array | null, isNew: boolean): void {
    const { current } = this;
    this.control.isDisabled = current === null;
    this.baking.show(current);
    this.control.showBaked(this.baking.formats);
    this.showTexcoordChoice(isNew);
    this.name(false);
    const isAtlas = current && current.mode !== 'flatten' && chartColors;
    this.bar.show(isAtlas ? { outcome: current, chartColors } : null);
    // What the page has made has nothing that a format could lose.
    if (current?.source.kind === 'file' || this.isLimited) void this.showLimits();
  }

  private async showLimits(): Promise<void> {
    this.isLimited = true;
    try {
      const { showLimits } = await savingParts();
      showLimits(this.current, this.baking.formats);
    } catch (error) {
      this.events.say(reasonOf(error as Error));
    }
  }

  private showTexcoordChoice(isNew: boolean): void {
    const isChosen = this.control.format === 'glb' && this.baking.imageSide === null;
    this.texcoordChoice.show(isChosen ? this.current : null, isNew);
  }

  private bakingChanged(): void {
    const { formats } = this.baking;
    if (formats.length > 0 && !formats.includes(this.control.format)) this.control.chooseGlb();
    this.control.showBaked(formats);
    this.showTexcoordChoice(false);
    if (this.isLimited) void this.showLimits();
  }

  private export(): void {
    const { outcome } = this;
    if (!outcome) return;
    const { format, title } = this.control;
    const { imageSide } = this.baking;
    const { texcoord } = this.texcoordChoice;
    // The button's title says if the layout is an earlier one.
    this.exporter.export({ outcome, format, texcoord, imageSide }, title);
  }

  private savePicture(): void {
    const { views, shown, outcome } = this;
    if (!views || !shown || !outcome) this.events.say(SAVING.notDrawn);
    else
      loadPart(import('./export/views-picture'))
        .then(({ savePicture }) => savePicture(views, shown.name))
        .then(
          (what) => this.saved(what),
          (error: Error) => this.notSaved(outcome, error),
        );
  }

  private saved(what: string): void {
    hideAlert();
    this.events.say(what);
  }

  private notSaved({ source, settings }: Outcome, { message }: Error): void {
    showAlert(SAVING.failed(titleOf(source), message), settingsText(settings));
  }
}
