import { create, element } from '../base/dom';
import type { Step } from '../session/steps';

/** The steps since the mesh was opened; choosing one goes there. */
export class HistoryTab {
  private readonly list = element('history', HTMLOListElement);

  constructor(private readonly chosen: (step: number) => void) {}

  show(steps: readonly Step[], current: number): void {
    const hadFocus = this.list.contains(document.activeElement);
    this.list.replaceChildren(...steps.map(({ text }, i) => this.item(text, i, current)));
    const item = this.list.children[current]?.firstElementChild as HTMLButtonElement | undefined;
    if (hadFocus) item?.focus();
    item?.scrollIntoView({ block: 'nearest' });
  }

  private item(text: string, i: number, current: number): HTMLElement {
    const item = create('li', i > current ? 'undone' : '');
    const button = create('button', 'step', text);
    button.type = 'button';
    if (i === current) button.ariaCurrent = 'step';
    button.addEventListener('click', () => this.chosen(i));
    item.append(button);
    return item;
  }
}
