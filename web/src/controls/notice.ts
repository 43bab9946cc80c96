import { create, element } from '../base/dom';
import { OPENED_NOTICE } from '../base/english';
import type { FileSource } from '../model/model';

/** What may be done with meshes that were chosen at once. */
export interface TogetherEvents {
  tabs(sources: FileSource[]): void;
  oneAtlas(sources: FileSource[]): void;
}

/**
 * What the user should know about the opened file. If several meshes were chosen at once, there are
 * buttons for all of them.
 */
export class Notice {
  private readonly box = element('notice', HTMLElement);

  constructor(private readonly events: TogetherEvents) {}

  /** `compressions`: how the file's triangles were compressed. `isTab`: those that were chosen with it are open, too. */
  show(opened: FileSource, compressions: string[], isTab: boolean): void {
    const together = isTab ? [] : opened.together;
    const sentences = [...compressed(opened, compressions), ...oneOfMany(opened, together)];
    this.hide();
    if (sentences.length === 0) return;
    const text = create('p', '', sentences.join(' '));
    this.box.replaceChildren(text, ...this.choices(together), this.closing());
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
    close.ariaLabel = OPENED_NOTICE.close;
    close.addEventListener('click', () => this.hide());
    return close;
  }

  hide(): void {
    this.box.replaceChildren();
  }

  private choices(together: FileSource[]): HTMLElement[] {
    if (together.length < 2) return [];
    const row = create('div', 'notice-choices');
    row.append(
      this.choice(OPENED_NOTICE.tabs, OPENED_NOTICE.aboutTabs, () => this.events.tabs(together)),
      this.choice(OPENED_NOTICE.oneAtlas, OPENED_NOTICE.aboutOneAtlas, () =>
        this.events.oneAtlas(together),
      ),
    );
    return [row];
  }

  private choice(text: string, title: string, chosen: () => void): HTMLElement {
    const button = create('button', 'tool', text);
    button.type = 'button';
    button.title = title;
    button.addEventListener('click', () => {
      this.hide();
      chosen();
    });
    return button;
  }
}

function compressed({ name }: FileSource, compressions: string[]): string[] {
  if (compressions.length === 0) return [];
  return [OPENED_NOTICE.compressed(name, compressions)];
}

function oneOfMany({ name }: FileSource, together: FileSource[]): string[] {
  if (together.length < 2) return [];
  return [OPENED_NOTICE.oneOfMany(name, together.length)];
}
