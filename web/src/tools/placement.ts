import type { UnwrapResult } from 'abflat';
import { STILL } from '../arrange/motion';
import { type Arrangeable, cornerUv } from '../model/arrangeable';
import type { FlatDrawing } from '../model/drawing';
import type { Outcome } from '../model/model';
import type { Views } from '../view/views';
import type { Workshop } from '../workshop/workshop';

/** The coordinates of an atlas whose charts are in other places, or bent. */
export interface Changed extends Partial<Pick<UnwrapResult, 'uv' | 'unpacked'>> {
  /** What was done, if that is only known now. */
  what?: string;
  /** Where charts do not fit in their new places, all are packed. */
  mayRepack?: boolean;
}

/** Changes an atlas; a text says why nothing is changed. */
export type Change = (outcome: Arrangeable) => Promise<Changed | string>;

export interface PlacementEvents {
  /** Charts are about to be in other places. */
  placing(): void;
  /** Charts are in other places; `what` was done. `mayRepack`: see Changed. */
  placed(outcome: Arrangeable, what: string, mayRepack: boolean): void;
  /** Nothing was moved: it went wrong, another atlas has come in between, or `why`. */
  notPlaced(error: Error | null, why?: string): void;
}

/** What a layout was asked for with, if it was changed by hand before. */
const askedOf = (outcome: Arrangeable): object | undefined =>
  outcome.mode === 'pack' ? outcome.packed.settings.uv : outcome.settings.placed;

/** What the next layout is asked for with. */
const lastOf = (outcome: Arrangeable): object | undefined =>
  outcome.mode === 'pack' ? outcome.given : outcome.result;

/** Changes charts of the atlas on screen. They appear in their new places before abflat has checked them. */
export class Placement {
  private outcome: Arrangeable | null = null;
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
  get current(): Arrangeable | null {
    return this.outcome;
  }

  /** The atlas on screen; null if there is none. `wanted`: the layout that the user has asked for by hand. */
  show(outcome: Arrangeable | null, wanted?: object): void {
    const last = this.outcome ? lastOf(this.outcome) : undefined;
    const isChecked = outcome !== null && last !== undefined && askedOf(outcome) === last;
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
      const { what: done = what, mayRepack = false, ...coordinates } = changed;
      const { made, drawn } = await this.changed(outcome, coordinates);
      const drawing = await this.workshop.outcome(drawn);
      if (generation !== this.generation) {
        this.giveUp(null);
        return;
      }
      this.outcome = made;
      this.draw(drawing);
      this.events.placed(made, done, mayRepack);
    } catch (error) {
      this.giveUp(error as Error);
    }
  }

  /** The layout with these coordinates, and what is drawn of it. */
  private async changed(
    outcome: Arrangeable,
    coordinates: Partial<Pick<UnwrapResult, 'uv' | 'unpacked'>>,
  ): Promise<{ made: Arrangeable; drawn: Outcome }> {
    if (outcome.mode === 'pack') {
      const result = { ...outcome.result, ...coordinates };
      const { uv, indices, vertexMap, positions } = result;
      const { packed } = outcome;
      const settings = { ...packed.settings, keepPlaces: false };
      const drawn = { ...packed.result, uv, indices, vertexMap, positions };
      return {
        made: { ...outcome, result, given: cornerUv(result) },
        drawn: { ...packed, settings, result: drawn },
      };
    }
    const result = { ...outcome.result, ...coordinates };
    const faceDensities = await this.workshop.keptDensities(outcome, result.uv);
    const settings = { ...outcome.settings, faceDensities };
    return { made: { ...outcome, settings, result }, drawn: { ...outcome, result } };
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
