import { loadPart, reasonOf } from '../base/load-part';
import type { ImageSide } from '../model/baking';
import type { Outcome } from '../model/model';
import type { ExportFormat } from '../words/generated-formats';
import type { BakeChoice } from './bake-choice';

/** Loaded before it is needed, too, so that it is there without a connection. */
export const bakeChoices = () => loadPart(import('./bake-choice'));

export interface BakeOfferEvents {
  /** Something else is wanted of textures. */
  changed(): void;
  say(text: string): void;
}

/** Offers to bake where there are textures or colours; what tells is loaded with the first file. */
export class BakeOffer {
  private choice: BakeChoice | null = null;
  private outcome: Outcome | null = null;

  constructor(private readonly events: BakeOfferEvents) {}

  /** Takes the result that would be exported, or null. */
  show(outcome: Outcome | null): void {
    this.outcome = outcome;
    if (this.choice) this.choice.show(outcome);
    else if (outcome?.source.kind === 'file') void this.load();
  }

  /** Nothing is wanted any more: another mesh is open. */
  reset(): void {
    this.choice?.reset();
  }

  /** Of the new images; null: textures stay as they are. */
  get imageSide(): ImageSide | null {
    return this.choice?.imageSide ?? null;
  }

  /** What gets new images. */
  get formats(): ExportFormat[] {
    return this.choice?.formats ?? [];
  }

  private async load(): Promise<void> {
    try {
      const { BakeChoice } = await bakeChoices();
      this.choice ??= new BakeChoice(() => this.events.changed());
      this.choice.show(this.outcome);
    } catch (error) {
      this.events.say(reasonOf(error as Error));
    }
  }
}
