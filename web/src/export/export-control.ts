import { element } from '../base/dom';
import { exportedFile, exportFormatOf } from '../base/mesh-files';
import { MenuButton } from '../controls/menu-button';
import type { Source } from '../model/model';
import { EXPORT } from '../words/export';
import { EXPORT_FORMATS, type ExportFormat } from '../words/generated-formats';

export interface ExportEvents {
  export(): void;
  /** Another format holds from now on. */
  formatChanged(): void;
  /** Saves a picture of both views. */
  picture(): void;
}

/** The button that exports, and the menu beside it with all formats. A format that was chosen holds as long as the mesh is open. */
export class ExportControl {
  private readonly button = element('export', HTMLButtonElement);
  private readonly text = element('export-text', HTMLSpanElement);
  private readonly menu: MenuButton;
  private chosen: ExportFormat = EXPORT_FORMATS[0];
  private earlier: string | null = null;
  private baked: ExportFormat[] = [];

  constructor(events: ExportEvents) {
    this.button.addEventListener('click', () => events.export());
    element('export-menu', HTMLElement).prepend(...EXPORT_FORMATS.map(choiceOf));
    this.menu = new MenuButton('export-formats', 'export-menu', (value) => {
      if (value === 'picture') return events.picture();
      this.choose(value as ExportFormat);
      events.formatChanged();
      events.export();
    });
    this.menu.isDisabled = true;
  }

  get format(): ExportFormat {
    return this.chosen;
  }

  /** What the button does beside exporting; '' where its text says it all. */
  get title(): string {
    return this.button.title;
  }

  open(source: Source): void {
    this.choose(exportFormatOf(source.name));
  }

  chooseGlb(): void {
    this.choose('glb');
  }

  /** The formats that get new textures. */
  showBaked(formats: ExportFormat[]): void {
    this.baked = formats;
    this.show();
  }

  openMenu(): void {
    this.menu.open();
  }

  set isDisabled(isDisabled: boolean) {
    this.button.disabled = isDisabled;
    this.menu.isDisabled = isDisabled;
  }

  /** `earlier`: whose layout would be exported, where that is not what the settings say. */
  name(earlier: string | null): void {
    this.earlier = this.button.disabled ? null : earlier;
    this.show();
  }

  private choose(format: ExportFormat): void {
    this.chosen = format;
    this.menu.check(format);
    this.show();
  }

  private show(): void {
    const { earlier } = this;
    const { title } = exportedFile(this.chosen);
    const isBaked = this.baked.includes(this.chosen);
    const name = this.chosen === 'obj' ? EXPORT.zip : title;
    const format = isBaked ? EXPORT.baked(name) : title;
    this.text.textContent = earlier ? EXPORT.exportLast : EXPORT.export(format);
    this.button.title = earlier ? EXPORT.previous(earlier) : '';
  }
}

/** An item of the menu. */
function choiceOf(format: ExportFormat): HTMLButtonElement {
  const item = document.createElement('button');
  item.type = 'button';
  item.role = 'menuitemradio';
  item.ariaChecked = 'false';
  item.tabIndex = -1;
  item.dataset.value = format;
  item.textContent = exportedFile(format).title;
  return item;
}
