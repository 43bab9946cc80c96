import type { UnwrapResult } from 'abflat';
import { STILL } from './arrange/motion';
import type { FlatDrawing } from './model/drawing';
import type { Unwrapped } from './model/model';
import type { Views } from './view/views';
import type { Workshop } from './workshop/workshop';

/** The coordinates of an atlas whose charts are in other places, or bent. */
export type Change = (
  outcome: Unwrapped,
) => Promise<Partial<Pick<UnwrapResult, 'uv' | 'unpacked'>>>;

export interface PlacementEvents {
  /** Charts are about to be in other places. */
  placing(): void;
  /** Charts are in other places; `what` was done. */
  placed(layout: UnwrapResult, what: string): void;
  /** Nothing was moved: it went wrong, or another atlas has come in between. */
  notPlaced(error: Error | null): void;
}

/** Changes charts of the atlas on screen. They appear in their new places before abflat has checked them. */
export class Placement {
  private outcome: Unwrapped | null = null;
  /** Grows when there is an atlas whose charts are not those of the one before. */
  private generation = 0;

  constructor(
    private readonly workshop: Workshop,
    private readonly views: Views,
    private readonly events: PlacementEvents,
  ) {}

  /** The atlas on screen with charts where they are now, whether they have been checked there or not. */
  get current(): Unwrapped | null {
    return this.outcome;
  }

  /** The atlas on screen; null if there is none. */
  show(outcome: Unwrapped | null): void {
    const isChecked = outcome !== null && outcome.settings.placed === this.outcome?.result;
    if (!isChecked) this.generation += 1;
    this.outcome = outcome;
  }

  /** Changes charts; `what` is done to them. */
  async place(change: Change, what: string): Promise<void> {
    const { outcome, generation } = this;
    if (!outcome) return;
    this.events.placing();
    try {
      const changed = await change(outcome);
      const placed: Unwrapped = { ...outcome, result: { ...outcome.result, ...changed } };
      const drawing = await this.workshop.outcome(placed);
      if (generation !== this.generation) {
        this.giveUp(null);
        return;
      }
      this.outcome = placed;
      this.draw(drawing);
      this.events.placed(placed.result, what);
    } catch (error) {
      this.giveUp(error as Error);
    }
  }

  private giveUp(error: Error | null): void {
    this.views.moveCharts(new Set(), STILL);
    this.events.notPlaced(error);
  }

  private draw(drawing: FlatDrawing): void {
    this.views.placeCharts();
    this.views.showFlat(drawing, null);
  }
}
