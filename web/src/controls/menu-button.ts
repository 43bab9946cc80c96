import { element } from '../base/dom';

/** A button that opens a menu of choices, of which one holds, and of actions. Both work by keyboard, as menus of programs do. */
export class MenuButton {
  private readonly button: HTMLButtonElement;
  private readonly menu: HTMLElement;

  /** The menu has an item with a `data-value` for each choice. */
  constructor(buttonId: string, menuId: string, chosen: (value: string) => void) {
    this.button = element(buttonId, HTMLButtonElement);
    this.menu = element(menuId, HTMLElement);
    for (const item of this.all)
      item.addEventListener('click', () => {
        this.close();
        chosen(item.dataset.value ?? '');
      });
    this.button.addEventListener('click', () => (this.menu.hidden ? this.open() : this.close()));
    this.button.addEventListener('keydown', (event) => {
      if (event.key !== 'ArrowDown') return;
      event.preventDefault();
      this.open();
    });
    this.menu.addEventListener('keydown', (event) => this.onKey(event));
    this.menu.addEventListener('focusout', ({ relatedTarget }) => {
      // The button closes it by its own click.
      if (relatedTarget !== this.button && !this.menu.contains(relatedTarget as Node | null))
        this.hide();
    });
  }

  set isDisabled(isDisabled: boolean) {
    this.button.disabled = isDisabled;
    if (isDisabled) this.hide();
  }

  /** Others may come later, which act by themselves. */
  private get all(): HTMLButtonElement[] {
    return [...this.menu.querySelectorAll('button')];
  }

  /** Those of an open menu that can be chosen now. */
  private get items(): HTMLButtonElement[] {
    return this.all.filter((item) => !item.disabled && item.checkVisibility());
  }

  check(value: string): void {
    for (const item of this.all)
      if (item.role === 'menuitemradio' && item.parentElement === this.menu)
        item.ariaChecked = String(item.dataset.value === value);
  }

  open(): void {
    if (this.button.disabled) return;
    this.menu.hidden = false;
    this.button.setAttribute('aria-expanded', 'true');
    const checked = this.items.find((item) => item.getAttribute('aria-checked') === 'true');
    (checked ?? this.items[0]).focus();
  }

  private close(): void {
    this.hide();
    this.button.focus();
  }

  private hide(): void {
    this.menu.hidden = true;
    this.button.setAttribute('aria-expanded', 'false');
  }

  /** Items side by side. */
  private get columns(): number {
    return this.items.filter(({ offsetTop }) => offsetTop === this.items[0].offsetTop).length;
  }

  private onKey(event: KeyboardEvent): void {
    const at = this.items.indexOf(event.target as HTMLButtonElement);
    const count = this.items.length;
    const { columns } = this;
    const actions: Record<string, () => void> = {
      ArrowDown: () => this.items[at + columns < count ? at + columns : at % columns].focus(),
      ArrowUp: () =>
        this.items[at < columns ? lastBelow(at, columns, count) : at - columns].focus(),
      ArrowRight: () => this.items[(at + 1) % count].focus(),
      ArrowLeft: () => this.items[(at + count - 1) % count].focus(),
      Home: () => this.items[0].focus(),
      End: () => this.items[count - 1].focus(),
      Escape: () => this.close(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    // Escape would cancel the run in flight as well.
    event.stopPropagation();
    action();
  }
}

/** The last item of the column that begins with the item `at`. */
const lastBelow = (at: number, columns: number, count: number) =>
  at + columns * Math.floor((count - 1 - at) / columns);
