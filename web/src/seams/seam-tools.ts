import { element } from '../base/dom';
import { isTouch } from '../base/touch';
import { inTouchWords } from '../words/format';

export type Tool = 'cut' | 'join';

/** Selecting is what clicks do without a tool. */
const TOOLS = ['select', 'cut', 'join'] as const;

/** The bar below the 3D view: what a click does. */
export class SeamTools {
  private readonly bar = element('seam-tools', HTMLElement);
  private readonly buttons = TOOLS.map((tool) => element(`seam-${tool}`, HTMLButtonElement));
  private readonly paint = element('seam-paint', HTMLButtonElement);
  private readonly cancel = element('seam-cancel', HTMLButtonElement);
  private readonly sharp = element('sharp-mark', HTMLButtonElement);
  private readonly sharpMarks = element('sharp-marks', HTMLElement);
  private readonly hint = element('seam-hint', HTMLElement);
  private chosen: (typeof TOOLS)[number] = 'cut';
  private paints = false;
  private isEnabled = false;

  constructor(
    private readonly toolChanged: () => void,
    cancelled: () => void,
  ) {
    this.paint.addEventListener('click', () => this.togglePainting());
    this.cancel.addEventListener('click', cancelled);
    this.buttons.forEach((button, i) => {
      button.addEventListener('click', () => this.press(TOOLS[i]));
    });
    this.showTool();
  }

  /** What a click does; null if nothing. */
  get tool(): Tool | null {
    return !this.isEnabled || this.chosen === 'select' ? null : this.chosen;
  }

  /** Whether drags over the mesh use the tool. */
  get isPainting(): boolean {
    return this.paints;
  }

  /** Pressing the tool that is chosen goes back to selecting, as with the page's other tools. */
  private press(tool: (typeof TOOLS)[number]): void {
    this.choose(tool === this.chosen ? 'select' : tool, this.paints);
  }

  togglePainting(): void {
    this.choose(this.chosen === 'select' ? 'cut' : this.chosen, !this.paints);
  }

  /** Goes back to selecting; returns whether there was another tool. */
  leave(): boolean {
    if (this.tool === null) return false;
    this.choose('select', false);
    return true;
  }

  /** Whether the focus is on a button. */
  has(target: EventTarget | null): boolean {
    return target instanceof Node && this.bar.contains(target);
  }

  /** The bar keeps its place, and the view above it its size. */
  setEnabled(isEnabled: boolean): void {
    this.isEnabled = isEnabled;
    for (const button of [...this.buttons, this.paint, this.sharp]) button.disabled = !isEnabled;
  }

  /** While a cut is begun, it can be cancelled, which takes the place of what begins others. */
  setCutting(isCutting: boolean): void {
    this.cancel.hidden = !isCutting;
    this.sharpMarks.hidden = isCutting;
  }

  setHint(text: string): void {
    const hint = isTouch() ? inTouchWords(text) : text;
    this.hint.textContent = hint;
    this.hint.title = hint;
    this.hint.hidden = hint === '';
  }

  /** There is nothing to paint with what selects. */
  private choose(chosen: (typeof TOOLS)[number], paints: boolean): void {
    this.chosen = chosen;
    this.paints = paints && chosen !== 'select';
    this.showTool();
    this.toolChanged();
  }

  private showTool(): void {
    this.paint.setAttribute('aria-pressed', String(this.paints));
    this.buttons.forEach((button, i) => {
      button.setAttribute('aria-pressed', String(this.chosen === TOOLS[i]));
    });
  }
}
