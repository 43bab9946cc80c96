import { showAlert } from './base/alert';
import { loadPart, reasonOf } from './base/load-part';
import { startOnce } from './base/start-once';
import type { LayoutControls } from './layout-controls';
import type { Outcome, Packed } from './model/model';
import type { PackChoices } from './model/settings';
import type { Surface } from './seams/seam-model';
import type { SelectionPanel } from './selection/selection-panel';
import type { Session } from './session/session';
import { Arranging, type ArrangingEvents } from './tools/arranging';
import type { BoundPainting } from './tools/bound-painting';
import type { DensityPainting } from './tools/density-painting';
import type { Views } from './view/views';
import { MOVING } from './words/selection';
import type { Workshop } from './workshop/workshop';

export interface HandEvents
  extends Pick<ArrangingEvents, 'isFree' | 'seams' | 'selected' | 'say' | 'noted'> {
  /** The surface of the open mesh, as soon as it is there; null if it cannot be. */
  surface(): Promise<Surface | null>;
  /** Other vertices are pinned; `what` was done. */
  pinned(what: string): void;
  /** What was about to move stays in place; '' if there is no other reason than that it went wrong. */
  notPlaced(why: string): void;
}

/** What changes a layout by hand: charts are arranged, the bounds of a disk are painted. */
export class HandTools {
  private readonly arranging: Arranging;
  /** Null until they are loaded. */
  private bounds: BoundPainting | null = null;
  private densities: DensityPainting | null = null;
  /** The last outcome of the mesh on screen. */
  private shown: Outcome | null = null;

  constructor(
    private readonly views: Views,
    private readonly workshop: Workshop,
    private readonly session: Session,
    private readonly controls: LayoutControls,
    private readonly events: HandEvents,
  ) {
    this.arranging = new Arranging(views, workshop, {
      ...events,
      staying: () => controls.locks.staying,
      keptUvs: () => controls.locks.keptUvs,
      aside: (work) =>
        this.session.aside(
          (abflat, _, signal) => work(abflat, signal),
          new AbortController().signal,
        ),
      onMesh: (work) => this.session.aside(work, new AbortController().signal),
      pinned: (pins, what) => {
        controls.pin(pins);
        events.pinned(what);
      },
      placing: () => document.body.setAttribute('aria-busy', 'true'),
      placed: (outcome, what, mayRepack) => controls.place(outcome, what, mayRepack),
      notPlaced: (error, why = '') => {
        if (error) showAlert(MOVING.failed(error.message));
        events.notPlaced(why);
      },
    });
  }

  /** What a first look does not need. */
  async loadRest(): Promise<void> {
    await Promise.all([this.arranging.loadRest(), this.loadBounds(), this.loadDensities()]);
  }

  private readonly loadBounds = startOnce(async () => {
    const { BoundPainting } = await loadPart(import('./tools/bound-painting'));
    const { controls, events } = this;
    this.bounds = new BoundPainting(this.views, this.workshop, {
      bounds: () => controls.disk.bounds ?? [],
      changed: (bounds, what) => controls.paint(bounds, what),
      say: events.say,
    });
    this.bounds.show(this.shown);
  });

  private readonly loadDensities = startOnce(async () => {
    const { DensityPainting } = await loadPart(import('./tools/density-painting'));
    const { controls, events } = this;
    this.densities = new DensityPainting(this.views, {
      densities: () => controls.densities,
      changed: (shown, densities, what) => controls.setDensities(shown, densities, what),
      surface: () => events.surface(),
      states: () => this.selection.states,
      isFree: () => events.isFree(),
      free: () => events.seams?.rest(),
      say: events.say,
    });
    this.densities.show(this.shown);
  });

  /** Another mesh was opened; it has no layout yet. */
  clear(): void {
    this.shown = null;
    this.arranging.show(null);
    this.leaveMode();
  }

  /** The other kind of layout is wanted. */
  leaveMode(): void {
    this.bounds?.show(null);
    this.densities?.show(null);
  }

  show(outcome: Outcome): void {
    const { settings } = this.controls;
    this.shown = outcome;
    if (outcome.mode === 'flatten')
      this.loadBounds().catch((error: Error) => this.events.say(reasonOf(error)));
    this.bounds?.show(outcome);
    this.densities?.show(outcome);
    if (outcome.mode === 'pack') {
      void this.showFile(outcome);
      return;
    }
    const wanted = settings.mode === 'unwrap' ? settings : {};
    this.arranging.show(outcome.mode === 'unwrap' ? outcome : null, wanted);
  }

  /** To tell the islands of a file takes a moment. */
  private async showFile(packed: Packed): Promise<void> {
    const { current } = this.arranging;
    if (current?.mode !== 'pack' || current.source !== packed.source) this.arranging.show(null);
    try {
      const layout = await this.workshop.fileLayout(packed);
      const { settings } = this.controls;
      const placed = settings.mode === 'pack' ? settings.uv : undefined;
      if (this.shown === packed) this.arranging.show(layout, { placed });
    } catch (error) {
      this.events.say(reasonOf(error as Error));
    }
  }

  /** Relaxes the selected islands of a file, or all. */
  async relaxIslands(): Promise<void> {
    (await this.arranging.loadRest()).relaxIslands();
  }

  /** Packs the selected islands of a file; returns whether there are any. */
  packIslands(choices: PackChoices): boolean {
    const isSome = this.selection.states.selected.size > 0;
    if (isSome) void this.arranging.loadRest().then((tools) => tools.packIslands(choices));
    return isSome;
  }

  /** Other settings are wanted. */
  update(): void {
    this.bounds?.update();
    this.densities?.update();
  }

  get selection(): SelectionPanel {
    return this.arranging.selection;
  }
}
