import { element, isTyping } from '../base/dom';
import { STEP_BUTTONS } from '../words/run';

export interface StepButtonEvents {
  undo(): void;
  redo(): void;
}

/** Undo and redo, by buttons and by the usual keys. */
export class StepButtons {
  private readonly undo = element('undo', HTMLButtonElement);
  private readonly redo = element('redo', HTMLButtonElement);

  constructor(events: StepButtonEvents) {
    this.undo.addEventListener('click', () => events.undo());
    this.redo.addEventListener('click', () => events.redo());
    document.addEventListener('keydown', (event) => {
      // A field being typed in has an undo of its own.
      if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping(event.target)) return;
      const action = { Z: events.undo, 'Shift+Z': events.redo, Y: events.redo }[keyOf(event)];
      if (!action) return;
      event.preventDefault();
      action();
    });
  }

  /** `undoes`, `redoes`: what would be taken back and done again; null if nothing. */
  show(undoes: string | null, redoes: string | null): void {
    this.undo.disabled = undoes === null;
    this.undo.title = STEP_BUTTONS.undo(undoes);
    this.redo.disabled = redoes === null;
    this.redo.title = STEP_BUTTONS.redo(redoes);
  }
}

const keyOf = ({ key, shiftKey }: KeyboardEvent) =>
  `${shiftKey ? 'Shift+' : ''}${key.toUpperCase()}`;
