import { element } from '../base/dom';
import type { AnyProgress } from '../model/model';

const STAGES: Record<AnyProgress['stage'], string> = {
  read: 'Reading',
  connectivity: 'Analysing the surface',
  surface: 'Analysing the surface',
  seams: 'Finding seams',
  solve: 'Solving',
  layout: 'Laying out',
  refine: 'Refining',
  pack: 'Packing charts',
  check: 'Checking',
  write: 'Writing',
};

/** Faster than this, showing progress would only flicker. Milliseconds. */
const QUIET = 120;

/** What the worker is doing, with progress and Cancel. Nothing in it moves when it changes. */
export class RunPanel {
  private readonly text = element('run-text', HTMLElement);
  private readonly bar = element('progress', HTMLProgressElement);
  private readonly cancelButton = element('cancel', HTMLButtonElement);
  private readonly againButton = element('again', HTMLButtonElement);
  private readonly live = element('live', HTMLElement);
  private delay: number | undefined;
  private what = '';

  constructor(cancel: () => unknown, again: () => void) {
    this.cancelButton.addEventListener('click', cancel);
    this.againButton.addEventListener('click', again);
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') cancel();
    });
  }

  /** `verb` is what would do it again. */
  start(what: string, verb: string): void {
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
    this.bar.value = fraction;
    if (!this.bar.classList.contains('active')) return;
    const step =
      newtonStep > 0 ? `, step ${newtonStep}, residual ${constraintResidual.toExponential(0)}` : '';
    this.text.textContent = `${STAGES[stage]}${step}`;
  }

  /** Says something that is no run's end; a run in flight keeps its line. */
  say(text: string): void {
    this.live.textContent = text;
    if (!this.cancelButton.disabled) return;
    this.text.textContent = text;
    this.text.title = text;
  }

  /** Shows the button that does it again under another name. */
  offer(verb: string): void {
    this.againButton.textContent = verb;
    this.againButton.hidden = false;
  }

  /** `text` is also read out by screen readers. */
  finish(text: string, canRepeat: boolean): void {
    clearTimeout(this.delay);
    this.delay = undefined;
    const hadFocus = document.activeElement === this.cancelButton;
    this.bar.classList.remove('active');
    this.bar.value = 0;
    this.text.textContent = text;
    this.text.title = text;
    this.live.textContent = text;
    this.cancelButton.disabled = true;
    this.againButton.hidden = !canRepeat;
    // A disabled button loses the focus, and the reader's place in the page with it.
    if (hadFocus) (canRepeat ? this.againButton : shownSlider()).focus();
  }
}

/** That of the kind of layout that is asked for. */
function shownSlider(): HTMLInputElement {
  const sliders = [element('t', HTMLInputElement), element('stretch', HTMLInputElement)];
  return sliders.find((slider) => slider.checkVisibility()) ?? sliders[0];
}
