import { create, element } from '../base/dom';
import type { FileSource } from '../model/model';

/** The most buttons below the text. */
const OFFERED = 3;

/**
 * What the user should know about the opened file. If several meshes were chosen at once, there are
 * buttons for the others.
 */
export class Notice {
  private readonly box = element('notice', HTMLElement);

  constructor(private readonly open: (source: FileSource) => void) {}

  /** `compressions`: how the file's triangles were compressed. */
  show(opened: FileSource, compressions: string[]): void {
    const others = opened.together.filter((source) => source !== opened);
    const sentences = [...compressed(opened, compressions), ...oneOfMany(opened, others)];
    this.hide();
    if (sentences.length === 0) return;
    const text = create('p', '', sentences.join(' '));
    this.box.replaceChildren(text, ...this.choices(others), this.closing());
  }

  /** Adds what was found out later. */
  add(sentence: string): void {
    const text = this.box.querySelector('p');
    if (text) text.textContent += ` ${sentence}`;
    else this.box.replaceChildren(create('p', '', sentence), this.closing());
  }

  private closing(): HTMLElement {
    const close = create('button', 'alert-close', '×');
    close.type = 'button';
    close.ariaLabel = 'Close this notice';
    close.addEventListener('click', () => this.hide());
    return close;
  }

  hide(): void {
    this.box.replaceChildren();
  }

  private choices(others: FileSource[]): HTMLElement[] {
    if (others.length === 0) return [];
    const row = create('div', 'notice-choices');
    for (const source of others.slice(0, OFFERED)) {
      const button = create('button', 'tool', `Open ${source.name}`);
      button.type = 'button';
      button.title = source.name;
      button.addEventListener('click', () => this.open(source));
      row.append(button);
    }
    return [row];
  }
}

function compressed({ name }: FileSource, compressions: string[]): string[] {
  if (compressions.length === 0) return [];
  const by = compressions.join(' and ');
  return [`${name} was compressed with ${by}. The export is uncompressed.`];
}

function oneOfMany({ name }: FileSource, others: FileSource[]): string[] {
  if (others.length === 0) return [];
  const more = others.length - OFFERED;
  const rest = more > 0 ? `, one of ${others.length + 1} meshes` : '';
  return [`Opened ${name}${rest}. Only one mesh can be open at a time.`];
}
