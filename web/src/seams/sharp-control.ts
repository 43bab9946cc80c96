import { element } from '../base/dom';
import { NumberField } from '../controls/number-field';

export interface SharpEvents {
  /** The user is about to mark edges that bend by more than this; null: no longer. */
  aimed(degrees: number | null): void;
  marked(degrees: number): void;
  say(text: string): void;
}

const USUAL = 60;
/** Degrees. */
const RULE = { type: 'number', above: 0, atMost: 180 };

/** The button that cuts along sharp edges, and the angle from which an edge is sharp. */
export class SharpControl {
  private readonly field: NumberField<number>;

  constructor(events: SharpEvents) {
    const box = element('sharp-marks', HTMLElement);
    const aim = () => events.aimed(this.field.value);
    this.field = new NumberField<number>(
      element('sharp-marks-degrees', HTMLInputElement),
      RULE,
      USUAL,
      aim,
      events.say,
    );
    for (const type of ['pointerenter', 'focusin'] as const) box.addEventListener(type, aim);
    box.addEventListener('pointerleave', () => {
      if (!box.contains(document.activeElement)) events.aimed(null);
    });
    box.addEventListener('focusout', () => events.aimed(null));
    element('sharp-mark', HTMLButtonElement).addEventListener('click', () =>
      events.marked(this.field.value),
    );
  }

  /** Takes over an angle that was chosen elsewhere. */
  use(degrees: number): void {
    this.field.restore(degrees);
  }
}
