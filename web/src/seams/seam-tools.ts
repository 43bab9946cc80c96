import { element, isTyping } from '../base/dom';

export type Tool = 'cut' | 'join';

export interface ToolEvents {
  toolChanged(): void;
  undo(): void;
  redo(): void;
}

/** Selecting is what clicks do without a tool. */
const TOOLS = ['select', 'cut', 'join'] as const;

/** The bar below the 3D view: what a click does, undo and redo. */
export class SeamTools {
  private readonly bar = element('seam-tools', HTMLElement);
  private readonly buttons = TOOLS.map((tool) => element(`seam-${tool}`, HTMLButtonElement));
  private readonly undo = element('seam-undo', HTMLButtonElement);
  private readonly redo = element('seam-redo', HTMLButtonElement);
  private readonly hint = element('seam-hint', HTMLElement);
  private chosen: (typeof TOOLS)[number] = 'cut';

  constructor(events: ToolEvents) {
    this.buttons.forEach((button, i) => {
      button.addEventListener('click', () => {
        this.chosen = this.chosen === TOOLS[i] ? 'select' : TOOLS[i];
        this.showTool();
        events.toolChanged();
      });
    });
    this.undo.addEventListener('click', () => events.undo());
    this.redo.addEventListener('click', () => events.redo());
    document.addEventListener('keydown', (event) => {
      if (this.bar.hidden || !(event.ctrlKey || event.metaKey) || isTyping(event.target)) return;
      const action = { Z: events.undo, 'Shift+Z': events.redo, Y: events.redo }[keyOf(event)];
      if (!action) return;
      event.preventDefault();
      action();
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

  setHistory(canUndo: boolean, canRedo: boolean): void {
    this.undo.disabled = !canUndo;
    this.redo.disabled = !canRedo;
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

const keyOf = ({ key, shiftKey }: KeyboardEvent) =>
  `${shiftKey ? 'Shift+' : ''}${key.toUpperCase()}`;
