import { element } from '../base/dom';
import { isTouch } from '../base/touch';
import { inTouchWords } from '../words/format';
import { PINS } from '../words/selection';

export interface PinBarActions {
  toggle(): void;
  removeAll(): void;
}

/** The button of the pin tool, and what can be done while it is pressed. */
export class PinBar {
  private readonly button = element('pin', HTMLButtonElement);
  private readonly bar = element('pins', HTMLElement);
  private readonly text = element('pins-text', HTMLElement);
  private readonly removeAll = element('pins-remove', HTMLButtonElement);

  constructor(actions: PinBarActions) {
    this.button.addEventListener('click', () => actions.toggle());
    element('pins-done', HTMLButtonElement).addEventListener('click', () => actions.toggle());
    this.removeAll.addEventListener('click', () => actions.removeAll());
  }

  /** `gesture`: what a drag does so far. */
  show(isOn: boolean, isAtlas: boolean, count: number, gesture: string | null): void {
    this.button.hidden = !isAtlas;
    this.button.ariaPressed = String(isOn);
    this.bar.hidden = !isOn || !isAtlas;
    this.bar.classList.toggle('busy', gesture !== null);
    this.removeAll.hidden = count === 0;
    const hint = count === 0 ? PINS.invitation : PINS.some(count);
    this.text.textContent = gesture ?? (isTouch() ? inTouchWords(hint) : hint);
  }
}
