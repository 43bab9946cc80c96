import { create, element } from '../base/dom';
import type { FileSource } from '../model/model';

/** Buttons that fit beside the text. */
const OFFERED = 3;

/** Of several meshes that were chosen at once, which one was opened, with buttons for the others. */
export class Notice {
  private readonly box = element('notice', HTMLElement);

  constructor(private readonly open: (source: FileSource) => void) {}

  show(opened: FileSource): void {
    const others = opened.together.filter((source) => source !== opened);
    this.hide();
    if (others.length === 0) return;
    const text = create('p', '', sentence(opened, others));
    text.title = opened.name;
    const buttons = others.slice(0, OFFERED).map((source) => {
      const button = create('button', 'tool', `Open ${source.name}`);
      button.type = 'button';
      button.title = source.name;
      button.addEventListener('click', () => this.open(source));
      return button;
    });
    const close = create('button', 'alert-close', '×');
    close.type = 'button';
    close.ariaLabel = 'Close this notice';
    close.addEventListener('click', () => this.hide());
    this.box.replaceChildren(text, ...buttons, close);
  }

  hide(): void {
    this.box.replaceChildren();
  }
}

function sentence({ name }: FileSource, others: FileSource[]): string {
  const more = others.length - OFFERED;
  const rest = more > 0 ? `, one of ${others.length + 1} meshes` : '';
  return `Opened ${name}${rest}. Only one mesh can be open at a time.`;
}
