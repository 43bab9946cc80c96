import { element, showText } from '../base/dom';
import type { AnyProgress } from '../model/model';
import type { Mode } from '../model/settings';
import { SOLVER_PROGRESS, STAGES } from '../words/run';
import { type Pace, RunClock } from './run-clock';

/** In milliseconds: showing the progress of faster runs would only flicker. */
const QUIET = 120;

/**
 * What the worker is doing, with progress and a Cancel button. Its layout does not move when it
 * changes.
 */
export class RunPanel {
  private readonly text = element('run-text', HTMLElement);
  private readonly bar = element('progress', HTMLProgressElement);
  private readonly cancelButton = element('cancel', HTMLButtonElement);
  private readonly againButton = element('again', HTMLButtonElement);
  private readonly live = element('live', HTMLElement);
  private delay: number | undefined;
  private what = '';
  private clock = new RunClock();
  private mode: Mode | null = null;
  /** How the last runs on this mesh went. */
  private readonly paces = new Map<Mode, Pace>();

  constructor(cancel: () => unknown, again: () => void) {
    this.cancelButton.addEventListener('click', cancel);
    this.againButton.addEventListener('click', again);
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') cancel();
    });
  }

  /** A mesh was read, and is going to be laid out. */
  opened(): void {
    this.paces.clear();
  }

  /** `verb`: the label of the button that repeats the run; `mode`: what is made, null: a mesh is read. */
  start(what: string, verb: string, mode: Mode | null): void {
    this.mode = mode;
    this.clock = new RunClock(mode ? this.paces.get(mode) : undefined);
    this.againButton.textContent = verb;
    this.cancelButton.disabled = false;
    this.againButton.hidden = true;
    this.what = what;
    this.bar.value = 0;
    if (this.bar.classList.contains('active')) this.text.textContent = what;
    else this.delay ??= window.setTimeout(() => this.showWhat(), QUIET);
  }

  private showWhat(): void {
    this.bar.classList.add('active');
    this.text.textContent = this.what;
    this.live.textContent = this.what;
  }

  progress({ stage, newtonStep, constraintResidual, fraction }: AnyProgress): void {
    const { passed, left } = this.clock.at(fraction);
    this.bar.value = passed;
    if (!this.bar.classList.contains('active')) return;
    const name = STAGES[stage];
    const doing =
      newtonStep > 0 ? SOLVER_PROGRESS.atStep(name, newtonStep, constraintResidual) : name;
    this.text.textContent = left === null ? doing : SOLVER_PROGRESS.left(doing, left);
  }

  /** Work other than a run, which can be cancelled too. */
  show(fraction: number, text: string): void {
    this.cancelButton.disabled = false;
    this.againButton.hidden = true;
    this.bar.classList.add('active');
    this.bar.value = fraction;
    this.text.textContent = text;
  }

  /** Shows a message that does not end a run; a run in flight keeps its line. */
  say(text: string): void {
    this.live.textContent = text;
    if (!this.cancelButton.disabled) return;
    showText(this.text, text);
  }

  /** Shows the repeat button under another label. */
  offer(verb: string): void {
    this.againButton.textContent = verb;
    this.againButton.hidden = false;
  }

  /** Screen readers also read out `text`. */
  finish(text: string, canRepeat: boolean): void {
    const pace = this.mode && this.clock.pace();
    if (this.mode && pace) this.paces.set(this.mode, pace);
    this.mode = null;
    clearTimeout(this.delay);
    this.delay = undefined;
    const hadFocus = document.activeElement === this.cancelButton;
    this.bar.classList.remove('active');
    this.bar.value = 0;
    showText(this.text, text);
    this.live.textContent = text;
    this.cancelButton.disabled = true;
    this.againButton.hidden = !canRepeat;
    // A disabled button loses the focus, and with it the reader's place in the page.
    if (hadFocus) (canRepeat ? this.againButton : shownSlider()).focus();
  }
}

/** The slider of the kind of layout that is chosen. */
function shownSlider(): HTMLInputElement {
  const sliders = [element('t', HTMLInputElement), element('stretch', HTMLInputElement)];
  return sliders.find((slider) => slider.checkVisibility()) ?? sliders[0];
}
