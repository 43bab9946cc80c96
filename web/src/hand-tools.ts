import { showAlert } from './base/alert';
import type { LayoutControls } from './layout-controls';
import type { Outcome } from './model/model';
import type { SelectionPanel } from './selection/selection-panel';
import type { Session } from './session/session';
import { Arranging, type ArrangingEvents } from './tools/arranging';
import { BoundPainting } from './tools/bound-painting';
import type { Views } from './view/views';
import { MOVING } from './words/selection';
import type { Workshop } from './workshop/workshop';

export interface HandEvents extends Pick<ArrangingEvents, 'isFree' | 'seams' | 'selected' | 'say'> {
  /** Other vertices are pinned; `what` was done. */
  pinned(what: string): void;
  /** What was about to move stays in place; '' if there is no other reason than that it went wrong. */
  notPlaced(why: string): void;
}

/** What changes a layout by hand: charts are arranged, the bounds of a disk are painted. */
export class HandTools {
  private readonly arranging: Arranging;
  private readonly painting: BoundPainting;

  constructor(
    views: Views,
    workshop: Workshop,
    private readonly session: Session,
    private readonly controls: LayoutControls,
    events: HandEvents,
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
      pinned: (pins, what) => {
        controls.pin(pins);
        events.pinned(what);
      },
      placing: () => document.body.setAttribute('aria-busy', 'true'),
      placed: (layout, densities, what) => controls.place(layout, densities, what),
      notPlaced: (error, why = '') => {
        if (error) showAlert(MOVING.failed(error.message));
        events.notPlaced(why);
      },
    });
    this.painting = new BoundPainting(views, workshop, {
      bounds: () => controls.disk.bounds ?? [],
      changed: (bounds, what) => controls.paint(bounds, what),
      say: events.say,
    });
  }

  /** What a first look does not need. */
  loadRest(): Promise<unknown> {
    return this.arranging.loadRest();
  }

  /** Another mesh was opened; it has no layout yet. */
  clear(): void {
    this.arranging.show(null);
    this.leaveMode();
  }

  /** The other kind of layout is wanted. */
  leaveMode(): void {
    this.painting.show(null);
  }

  show(outcome: Outcome): void {
    const { settings } = this.controls;
    const wanted = settings.mode === 'unwrap' ? settings : {};
    this.arranging.show(outcome.mode === 'unwrap' ? outcome : null, wanted);
    this.painting.show(outcome);
  }

  /** Other settings are wanted. */
  update(): void {
    this.painting.update();
  }

  get selection(): SelectionPanel {
    return this.arranging.selection;
  }
}
