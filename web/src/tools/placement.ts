import type { UnwrapResult } from 'abflat';
import { STILL } from '../arrange/motion';
import type { FlatDrawing } from '../model/drawing';
import type { FaceDensities } from '../model/face-densities';
import type { Unwrapped } from '../model/model';
import type { KnownAtlas } from '../model/settings';
import type { Views } from '../view/views';
import type { Workshop } from '../workshop/workshop';

/** The coordinates of an atlas whose charts are in other places, or bent. */
export interface Changed extends Partial<Pick<UnwrapResult, 'uv' | 'unpacked'>> {
  /** What was done, if that is only known now. */
  what?: string;
}

/** Changes an atlas; a text says why nothing is changed. */
export type Change = (outcome: Unwrapped) => Promise<Changed | string>;

export interface PlacementEvents {
  /** Charts are about to be in other places. */
  placing(): void;
  /** Charts are in other places; `what` was done. They keep these densities when they are packed anew. */
  placed(layout: UnwrapResult, densities: FaceDensities, what: string): void;
  /** Nothing was moved: it went wrong, another atlas has come in between, or `why`. */
  notPlaced(error: Error | null, why?: string): void;
}

/** Changes charts of the atlas on screen. They appear in their new places before abflat has checked them. */
export class Placement {
  private outcome: Unwrapped | null = null;
  /** Grows when there is an atlas whose charts are not those of the one before. */
  private generation = 0;
  /** Changes follow one another: each begins with what the one before has made. */
  private last: Promise<void> = Promise.resolve();

  constructor(
    private readonly workshop: Workshop,
    private readonly views: Views,
    private readonly events: PlacementEvents,
  ) {}

  /** The atlas on screen with charts where they are now, whether they have been checked there or not. */
  get current(): Unwrapped | null {
    return this.outcome;
  }

  /** The atlas on screen; null if there is none. `wanted`: the layout that the user has asked for by hand. */
  show(outcome: Unwrapped | null, wanted?: KnownAtlas): void {
    const last = this.outcome?.result;
    const isChecked = outcome !== null && outcome.settings.placed === last;
    // Charts were moved again during the check, and the next one is still to come.
    if (outcome && !isChecked && wanted !== undefined && wanted === last) return;
    if (!isChecked) this.generation += 1;
    this.outcome = outcome;
  }

  /** Changes charts; `what` is done to them. */
  place(change: Change, what: string): Promise<void> {
    const { generation } = this;
    this.last = this.last.then(() => this.placeNow(change, what, generation));
    return this.last;
  }

  /** `generation`: that of the charts that the user has changed. */
  private async placeNow(change: Change, what: string, generation: number): Promise<void> {
    const { outcome } = this;
    if (!outcome) return;
    if (generation !== this.generation) {
      this.giveUp(null);
      return;
    }
    this.events.placing();
    try {
      const changed = await change(outcome);
      if (typeof changed === 'string') {
        this.giveUp(null, changed);
        return;
      }
      const { what: done = what, ...coordinates } = changed;
      const result = { ...outcome.result, ...coordinates };
      const asked = this.workshop.keptDensities(outcome, result.uv);
      const drawn = this.workshop.outcome({ ...outcome, result });
      const [faceDensities, drawing] = await Promise.all([asked, drawn]);
      const settings = { ...outcome.settings, faceDensities };
      if (generation !== this.generation) {
        this.giveUp(null);
        return;
      }
      this.outcome = { ...outcome, settings, result };
      this.draw(drawing);
      this.events.placed(result, faceDensities, done);
    } catch (error) {
      this.giveUp(error as Error);
    }
  }

  private giveUp(error: Error | null, why?: string): void {
    this.views.moveCharts(new Set(), STILL);
    this.events.notPlaced(error, why);
  }

  private draw(drawing: FlatDrawing): void {
    this.views.placeCharts();
    this.views.showFlat(drawing, null);
  }
}
