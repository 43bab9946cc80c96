import { element } from '../base/dom';
import type { Mode } from '../model/settings';

/** The tabs, as their ids in the page. */
export type Tab =
  | 'solver'
  | 'sweep'
  | 'methods'
  | 'charts'
  | 'objects'
  | 'islands'
  | 'verify'
  | 'history';

const TABS: Tab[] = [
  ...(['solver', 'sweep', 'methods', 'charts', 'objects', 'islands', 'verify'] as const),
  'history',
];
/** The tabs of each kind of layout. */
const TABS_OF: Record<Mode, Tab[]> = {
  flatten: ['solver', 'sweep', 'methods', 'history'],
  unwrap: ['charts', 'objects', 'verify', 'history'],
  pack: ['islands', 'objects', 'verify', 'history'],
};

/** The pane that opens beside the layout and shows one of its tabs at a time. */
export class Details {
  private readonly pane = element('details', HTMLElement);
  private readonly toggle = element('details-toggle', HTMLButtonElement);
  private mode: Mode = 'flatten';
  private hasObjects = false;
  private offered = TABS_OF.flatten;
  private readonly tabs = TABS.map((tab) => element(`tab-${tab}`, HTMLButtonElement));

  /** `left` is called when a tab is no longer visible, `chosen` when another one is. */
  constructor(
    private readonly left: (tab: Tab) => void,
    private readonly chosen: (tab: Tab) => void,
  ) {
    this.toggle.addEventListener('click', () => (this.isOpen ? this.close() : this.open()));
    element('details-close', HTMLButtonElement).addEventListener('click', () => {
      this.close();
      this.toggle.focus();
    });
    this.tabs.forEach((button, i) => {
      button.addEventListener('click', () => this.select(TABS[i]));
      button.addEventListener('keydown', (event) => this.onKey(event, i));
    });
  }

  /** Offers the tabs of a kind of layout. */
  setMode(mode: Mode): void {
    this.mode = mode;
    this.offered = TABS_OF[mode].filter((tab) => this.hasObjects || tab !== 'objects');
    TABS.forEach((tab, i) => {
      this.tabs[i].hidden = !this.offered.includes(tab);
    });
    if (!this.offered.includes(this.selected)) this.select(this.offered[0]);
  }

  /** Whether the mesh has objects that can be listed. */
  offerObjects(hasObjects: boolean): void {
    this.hasObjects = hasObjects;
    this.setMode(this.mode);
  }

  /** Opens the pane at a tab and moves the focus there. */
  openAt(tab: Tab): void {
    this.select(tab);
    this.open();
    this.tabs[TABS.indexOf(tab)].focus();
  }

  private get isOpen(): boolean {
    return !this.pane.hidden;
  }

  private get selected(): Tab {
    return TABS[this.tabs.findIndex((tab) => tab.ariaSelected === 'true')];
  }

  private open(): void {
    this.setOpen(true);
    // If the panes are stacked, scroll so that the layout and its details are both visible.
    if (this.pane.getBoundingClientRect().bottom > window.innerHeight)
      element('layout-pane', HTMLElement).scrollIntoView({ block: 'start' });
  }

  private close(): void {
    this.setOpen(false);
    this.left(this.selected);
  }

  private setOpen(isOpen: boolean): void {
    this.pane.hidden = !isOpen;
    this.toggle.ariaExpanded = String(isOpen);
    document.body.classList.toggle('with-details', isOpen);
  }

  private select(tab: Tab): void {
    const before = this.selected;
    TABS.forEach((each, i) => {
      this.tabs[i].ariaSelected = String(each === tab);
      this.tabs[i].tabIndex = each === tab ? 0 : -1;
      element(`panel-${each}`, HTMLElement).hidden = each !== tab;
    });
    if (before === tab) return;
    this.left(before);
    this.chosen(tab);
  }

  private onKey(event: KeyboardEvent, i: number): void {
    const at = this.offered.indexOf(TABS[i]);
    const last = this.offered.length - 1;
    const to = {
      ArrowLeft: at === 0 ? last : at - 1,
      ArrowRight: at === last ? 0 : at + 1,
      Home: 0,
      End: last,
    }[event.key];
    if (to === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.select(this.offered[to]);
    this.tabs[TABS.indexOf(this.offered[to])].focus();
  }
}
