import { element } from '../base/dom';
import { loadPart } from '../base/load-part';
import { NumberField } from '../controls/number-field';
import type { Packed, Unwrapped } from '../model/model';
import type { Mode } from '../model/settings';
import type { Workshop } from '../workshop/workshop';
import type { LayoutKind, ShownAtlas } from './save-layout';

export interface LayoutBarEvents {
  say(text: string): void;
  /** A file was saved; `what` says so. */
  saved(what: string): void;
  failed(outcome: Unwrapped | Packed, error: Error): void;
}

/** Millimetres per unit of the mesh. */
const SCALE = { type: 'number', above: 0, words: { auto: 0 } };

/** The bar below the layout, which saves the atlas as a picture. */
export class LayoutBar {
  private readonly bar = element('layout-tools', HTMLElement);
  private readonly scale: NumberField<number | 'auto'>;
  private readonly buttons: HTMLButtonElement[];
  private shown: ShownAtlas | null = null;

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
    this.buttons = [
      this.bind('layout-png', 'png'),
      this.bind('layout-heat', 'heat'),
      this.bind('layout-svg', 'svg'),
    ];
  }

  setMode(mode: Mode): void {
    this.bar.hidden = mode === 'flatten';
  }

  /** Null: the mesh on screen has no atlas. */
  show(shown: ShownAtlas | null): void {
    this.shown = shown;
    for (const button of this.buttons) button.disabled = shown === null;
  }

  private bind(id: string, kind: LayoutKind): HTMLButtonElement {
    const button = element(id, HTMLButtonElement);
    button.addEventListener('click', () => {
      const { shown } = this;
      if (!shown) return;
      this.save(shown, kind).catch((error: Error) => this.events.failed(shown.outcome, error));
    });
    return button;
  }

  private async save(shown: ShownAtlas, kind: LayoutKind): Promise<void> {
    const { saveLayout } = await loadPart(import('./save-layout'));
    this.events.saved(await saveLayout(shown, kind, this.workshop, this.scale.value));
  }
}
