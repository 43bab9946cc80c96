import { create, element } from '../base/dom';

/** An entry of the menu that arranges charts. */
export interface ArrangeItem {
  text: string;
  about: string;
  /** Does the same. */
  key?: string;
  /** It is for islands of a file alone. */
  isForFiles?: true;
  act(): void;
}

/** Adds entries below the one that aligns charts. */
export function addToArrange(items: ArrangeItem[]): void {
  const menu = element('arrange-menu', HTMLElement);
  const made = items.map(({ text, about, key, isForFiles, act }) => {
    const item = create('button', isForFiles ? 'for-files' : '', text);
    item.type = 'button';
    item.role = 'menuitem';
    item.tabIndex = -1;
    item.title = about;
    if (key) item.append(create('kbd', '', key));
    item.addEventListener('click', () => {
      // The menu closes when the focus leaves it.
      element('layout-canvas', HTMLElement).focus();
      act();
    });
    return item;
  });
  menu.querySelector('[data-value="straightened"]')?.after(...made);
}
