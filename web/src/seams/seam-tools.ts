import { element } from '../base/dom';

export type Tool = 'cut' | 'join';

/** Selecting is what clicks do without a tool. */
const TOOLS = ['select', 'cut', 'join'] as const;

/** The bar below the 3D view: what a click does. */
export class SeamTools {
  private readonly bar = element('seam-tools', HTMLElement);
  private readonly buttons = TOOLS.map((tool) => element(`seam-${tool}`, HTMLButtonElement));
  private readonly cancel = element('seam-cancel', HTMLButtonElement);
  private readonly sharpMarks = element('sharp-marks', HTMLElement);
  private readonly hint = element('seam-hint', HTMLElement);
  private chosen: (typeof TOOLS)[number] = 'cut';

  constructor(toolChanged: () => void, cancelled: () => void) {
    this.cancel.addEventListener('click', cancelled);
    this.buttons.forEach((button, i) => {
      button.addEventListener('click', () => {
        this.chosen = this.chosen === TOOLS[i] ? 'select' : TOOLS[i];
        this.showTool();
        toolChanged();
      });
    });
    this.showTool();
  }

  /** What a click does; null if nothing. */
  get tool(): Tool | null {
    return this.bar.hidden || this.chosen === 'select' ? null : this.chosen;
  }

  setVisible(isVisible: boolean): void {
    this.bar.hidden = !isVisible;
  }

  /** While a cut is begun, it can be cancelled, which takes the place of what begins others. */
  setCutting(isCutting: boolean): void {
    this.cancel.hidden = !isCutting;
    this.sharpMarks.hidden = isCutting;
  }

  setHint(text: string): void {
    this.hint.textContent = text;
    this.hint.hidden = text === '';
  }

  private showTool(): void {
    this.buttons.forEach((button, i) => {
      button.setAttribute('aria-pressed', String(this.chosen === TOOLS[i]));
    });
  }
}
