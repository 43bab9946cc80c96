import { create, element } from '../base/dom';
import type { Source } from '../model/model';
import { titleOf } from '../session/titles';
import { MESH_TABS } from '../words/opening';

export interface MeshTabEvents {
  open(source: Source): void;
  /** Whether a mesh may be closed: it may have work that is in no file. */
  mayClose(source: Source): Promise<boolean>;
  closed(source: Source): void;
  isUnsaved(source: Source): boolean;
}

/** Meshes that are open side by side, as tabs above the mesh. */
export class MeshTabs {
  private readonly list = element('mesh-tabs', HTMLElement);
  private readonly panel = element('mesh-stage', HTMLElement);
  private sources: Source[] = [];
  private shown: Source | null = null;

  constructor(private readonly events: MeshTabEvents) {
    this.list.addEventListener('keydown', (event) => this.onKey(event));
  }

  has(source: Source): boolean {
    return this.sources.includes(source);
  }

  /** Makes tabs of meshes that were chosen together. */
  add(sources: Source[]): void {
    this.sources.push(...sources.filter((source) => !this.has(source)));
    this.draw();
    this.tabOf(this.shown)?.focus();
  }

  /** A mesh was opened. Where there are tabs it gets one; `keepsLast`: the mesh before stays open, too. */
  show(source: Source, keepsLast: boolean): void {
    const { shown } = this;
    if (keepsLast && shown && !this.has(shown)) this.sources.push(shown);
    if (this.sources.length > 0 && !this.has(source)) this.sources.push(source);
    this.shown = source;
    this.draw();
  }

  /** Another mesh may have work that is in no file. */
  update(): void {
    this.draw();
  }

  private async close(source: Source): Promise<void> {
    if (!(await this.events.mayClose(source)) || !this.has(source)) return;
    this.remove(source);
    this.events.closed(source);
  }

  /** The last tab is none. */
  private remove(source: Source): void {
    const at = this.sources.indexOf(source);
    const left = this.sources.filter((each) => each !== source);
    const isShown = source === this.shown;
    const next = left[Math.min(at, left.length - 1)];
    this.sources = left.length > 1 ? left : [];
    // It stays on screen until the next one is read, but is not open any more.
    if (isShown) this.shown = null;
    this.draw();
    if (isShown) this.events.open(next);
    const focused = this.tabOf(isShown ? next : this.shown);
    (focused ?? element('mesh-canvas', HTMLElement)).focus();
  }

  private tabOf(source: Source | null): HTMLElement | undefined {
    if (!source) return undefined;
    return this.tabs[this.sources.indexOf(source)];
  }

  private get tabs(): HTMLElement[] {
    return [...this.list.children] as HTMLElement[];
  }

  private draw(): void {
    const focused = this.tabs.indexOf(document.activeElement as HTMLElement);
    this.list.hidden = this.sources.length === 0;
    this.list.replaceChildren(...this.sources.map((source) => this.tab(source)));
    // One that can be reached by Tab, even if none of them is shown.
    const reached = this.tabOf(this.shown) ?? this.tabs[0];
    if (reached) reached.tabIndex = 0;
    this.tabs[focused]?.focus();
    if (this.list.hidden) {
      this.panel.removeAttribute('role');
      this.panel.removeAttribute('aria-label');
    } else {
      this.panel.role = 'tabpanel';
      this.panel.ariaLabel = this.shown && titleOf(this.shown);
    }
    this.tabOf(this.shown)?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }

  private tab(source: Source): HTMLElement {
    const isShown = source === this.shown;
    const title = titleOf(source);
    const tab = create('button', 'tab mesh-tab');
    tab.type = 'button';
    tab.role = 'tab';
    const isUnsaved = this.events.isUnsaved(source);
    tab.title = MESH_TABS.tab(title, isUnsaved);
    tab.ariaSelected = String(isShown);
    tab.tabIndex = -1;
    tab.setAttribute('aria-controls', this.panel.id);
    tab.setAttribute('aria-keyshortcuts', 'Delete');
    // A tab has no buttons inside; the keyboard has its own way.
    const close = create('span', 'mesh-tab-close', '×');
    close.ariaHidden = 'true';
    close.addEventListener('click', (event) => {
      event.stopPropagation();
      void this.close(source);
    });
    tab.append(create('span', 'mesh-tab-name', title));
    if (isUnsaved) tab.append(create('span', 'visually-hidden', MESH_TABS.unsaved), dot());
    tab.append(close);
    tab.addEventListener('click', () => {
      if (source !== this.shown) this.events.open(source);
    });
    return tab;
  }

  private onKey(event: KeyboardEvent): void {
    const at = this.tabs.indexOf(event.target as HTMLElement);
    const { tabs } = this;
    const actions: Record<string, () => void> = {
      ArrowRight: () => tabs[(at + 1) % tabs.length].focus(),
      ArrowLeft: () => tabs[(at + tabs.length - 1) % tabs.length].focus(),
      Home: () => tabs[0].focus(),
      End: () => tabs[tabs.length - 1].focus(),
      Delete: () => void this.close(this.sources[at]),
    };
    const action = actions[event.key];
    if (!action || at < 0) return;
    event.preventDefault();
    action();
  }
}

function dot(): HTMLElement {
  const dot = create('span', 'mesh-tab-dot');
  dot.ariaHidden = 'true';
  return dot;
}
