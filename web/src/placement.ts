import type { UnwrapResult } from 'abflat';
import type { FlatDrawing } from './model/drawing';
import type { Unwrapped } from './model/model';
import type { Views } from './view/views';
import type { Arranged, Workshop } from './workshop/workshop';

export interface PlacementEvents {
  /** Charts are in other places; `what` was done. */
  placed(layout: UnwrapResult, what: string): void;
  failed(error: Error): void;
}

/** Moves charts of the atlas on screen. They appear in their new places before abflat has checked them. */
export class Placement {
  private outcome: Unwrapped | null = null;

  constructor(
    private readonly workshop: Workshop,
    private readonly views: Views,
    private readonly events: PlacementEvents,
  ) {}

  /** The atlas on screen; null if there is none. */
  show(outcome: Unwrapped | null): void {
    this.outcome = outcome;
  }

  /** Moves charts; `what` is done to them. */
  async place(arranged: Arranged, what: string): Promise<void> {
    const { outcome } = this;
    if (!outcome) return;
    try {
      const motions = await this.workshop.motions(outcome, arranged);
      const uv = await this.workshop.moved(outcome.result, motions);
      const placed: Unwrapped = { ...outcome, result: { ...outcome.result, uv } };
      const drawing = await this.workshop.outcome(placed);
      if (outcome !== this.outcome) return;
      this.outcome = placed;
      this.draw(drawing);
      this.events.placed(placed.result, what);
    } catch (error) {
      this.events.failed(error as Error);
    }
  }

  private draw(drawing: FlatDrawing): void {
    this.views.placeCharts();
    this.views.showFlat(drawing, null);
  }
}
