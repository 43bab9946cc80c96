import { create, element } from '../base/dom';
import { messageHidden, messageShown } from '../base/messages';
import { type FileSource, isGltf } from '../model/model';
import { OPENED_NOTICE } from '../words/opening';

/** What may be done with meshes that were chosen at once. */
export interface TogetherEvents {
  tabs(sources: FileSource[]): void;
  oneAtlas(sources: FileSource[]): void;
}

/** In milliseconds: how long a notice stays, and what each letter of it adds. */
const STAYS = { least: 12_000, perLetter: 80 };

/**
 * What the user should know about the opened file. It goes away once there was time to read it; not
 * while the pointer or the focus is on it, or the page is out of sight. If several meshes were
 * chosen at once, there are buttons for all of them, which wait for an answer, or until the user works
 * on with the one that is open.
 */
export class Notice {
  private readonly box = element('notice', HTMLElement);
  private sentences: string[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly events: TogetherEvents) {
    for (const type of ['pointerenter', 'pointerleave', 'focusin', 'focusout'])
      this.box.addEventListener(type, () => this.wait());
    document.addEventListener('visibilitychange', () => this.wait());
  }

  /** Stays for a while from now on. */
  private wait(): void {
    clearTimeout(this.timer);
    const isRead = this.box.matches(':hover, :focus-within') || document.hidden;
    if (isRead || this.asks) return;
    const letters = this.box.textContent?.length ?? 0;
    this.timer = setTimeout(() => this.hide(), STAYS.least + letters * STAYS.perLetter);
  }

  /** `remarks`: on how it was read. `isTab`: those that were chosen with it are open, too. */
  show(opened: FileSource, remarks: string[], isTab: boolean): void {
    const together = isTab ? [] : opened.together;
    this.hide();
    this.sentences = [...remarks, ...oneOfMany(opened, together)];
    if (this.sentences.length === 0) return;
    const text = create('p', '', this.sentences.join(' '));
    this.fill(text, ...this.choices(together));
  }

  /** Adds what was found out later, unless it says so already. */
  add(sentence: string): void {
    if (this.sentences.includes(sentence)) return;
    this.sentences.push(sentence);
    const text = this.box.querySelector('p');
    if (text) text.textContent = this.sentences.join(' ');
    else this.fill(create('p', '', sentence));
    this.wait();
  }

  /** The user works on: a question without an answer goes. */
  overtake(): void {
    if (this.asks) this.hide();
  }

  private get asks(): boolean {
    return this.box.querySelector('.notice-choices') !== null;
  }

  private fill(...content: HTMLElement[]): void {
    this.box.replaceChildren(...content, this.closing());
    messageShown(this.box, () => this.hide());
    this.wait();
  }

  private closing(): HTMLElement {
    const close = create('button', 'alert-close', '×');
    close.type = 'button';
    close.ariaLabel = OPENED_NOTICE.close;
    close.addEventListener('click', () => this.hide());
    return close;
  }

  hide(): void {
    clearTimeout(this.timer);
    messageHidden(this.box);
    this.sentences = [];
    this.box.replaceChildren();
  }

  private choices(together: FileSource[]): HTMLElement[] {
    if (together.length < 2) return [];
    const row = create('div', 'notice-choices');
    const { oneAtlas, aboutOneGlb, aboutOneObj } = OPENED_NOTICE;
    row.append(
      this.choice(OPENED_NOTICE.tabs, OPENED_NOTICE.aboutTabs, () => this.events.tabs(together)),
      this.choice(oneAtlas, together.some(isGltf) ? aboutOneGlb : aboutOneObj, () =>
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

function oneOfMany({ name }: FileSource, together: FileSource[]): string[] {
  if (together.length < 2) return [];
  const shapes = together.some(isGltf) ? together.filter((each) => !isGltf(each)) : [];
  return [
    OPENED_NOTICE.oneOfMany(name, together.length),
    ...(shapes.length > 0 ? [OPENED_NOTICE.shapesOnly(shapes.map((each) => each.name))] : []),
  ];
}
