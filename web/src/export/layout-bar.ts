import { element } from '../base/dom';
import { NumberField } from '../controls/number-field';
import type { Packed, Unwrapped } from '../model/model';
import type { Mode } from '../model/settings';
import type { Workshop } from '../workshop/workshop';
import type { PictureKind, Shown } from './atlas-pictures';
import { savingParts } from './exporter';

export interface LayoutBarEvents {
  say(text: string): void;
  /** A file was saved; `what` says so. */
  saved(what: string): void;
  failed(outcome: Unwrapped | Packed, error: Error): void;
}

const KINDS: PictureKind[] = ['png', 'heat', 'svg'];

/** Millimetres per unit of the mesh. */
const SCALE = { type: 'number', above: 0, words: { auto: 0 } };

/** The bar below the layout, which saves the atlas as a picture. */
export class LayoutBar {
  private readonly bar = element('layout-tools', HTMLElement);
  private readonly scale: NumberField<number | 'auto'>;
  private readonly buttons: HTMLButtonElement[];
  private shown: Shown | null = null;

  constructor(
    private readonly workshop: Workshop,
    private readonly events: LayoutBarEvents,
  ) {
    this.scale = new NumberField<number | 'auto'>(
      element('layout-scale', HTMLInputElement),
      SCALE,
      'auto',
      () => undefined,
      events.say,
    );
    this.buttons = KINDS.map((kind) => this.bind(kind));
  }

  setMode(mode: Mode): void {
    this.bar.hidden = mode === 'flatten';
  }

  /** Null: the mesh on screen has no atlas. */
  show(shown: Shown | null): void {
    this.shown = shown;
    for (const button of this.buttons) button.disabled = shown === null;
  }

  private bind(kind: PictureKind): HTMLButtonElement {
    const button = element(`layout-${kind}`, HTMLButtonElement);
    button.addEventListener('click', () => {
      const { shown } = this;
      if (!shown) return;
      savingParts()
        .then(({ savePictureOf }) => savePictureOf(shown, kind, this.scale.value, this.workshop))
        .then(
          (what) => this.events.saved(what),
          (error: Error) => this.events.failed(shown.outcome, error),
        );
    });
    return button;
  }
}
