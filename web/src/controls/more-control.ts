import { UNWRAP_OPTIONS } from 'abflat';
import { create, element, showText } from '../base/dom';
import { MORE } from '../model/more-names';
import {
  canHaveTiles,
  changedOptions,
  defaultOptions,
  MORE_LABELS,
  type MoreName,
  type MoreOptions,
  PART_TILES,
  type PartTiles,
  usedOptions,
} from '../model/more-options';
import { OPTIONS } from '../words/controls';
import { sentence } from '../words/format';
import { PACKING } from '../words/selection';
import { NumberField } from './number-field';
import { optionTexts } from './option-texts';

/**
 * Further options of an atlas. They open with a button, which names the options that differ from
 * the defaults.
 */
export class MoreControl {
  private readonly button = element('more-toggle', HTMLButtonElement);
  private readonly panel = element('more', HTMLElement);
  private readonly state = element('more-state', HTMLElement);
  private readonly switches = create('div', 'more-switches');
  private udim: HTMLButtonElement | null = null;
  private readonly tiles = create('select', 'button');
  private readonly keepUv: HTMLButtonElement;
  /** What waits for the words on an option. */
  private readonly titled: [HTMLElement, MoreName][] = [];
  private options: MoreOptions = defaultOptions();
  /** Each shows one option as it is. */
  private readonly shows: (() => void)[] = [];

  constructor(
    private readonly changed: () => void,
    private readonly say: (text: string) => void,
  ) {
    for (const name of MORE) this.add(name);
    this.addTiles();
    this.offerParts(false, false);
    this.keepUv = this.switchOf('more-keep-uv', OPTIONS.keepUvs, OPTIONS.aboutKeepUvs);
    this.keepUv.hidden = true;
    this.keepUv.addEventListener('click', () => {
      const { fixedFaces, ...others } = this.options;
      this.options = others;
      this.set(fixedFaces ? {} : { fixedFaces: 'uv' });
    });
    this.panel.append(this.switches);
    this.show();
    this.button.addEventListener('click', () => this.setOpen(this.panel.hidden));
    this.panel.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation(); // else it cancels a run
      this.setOpen(false);
      this.button.focus();
    });
  }

  async loadRest(): Promise<void> {
    const { UNWRAP_TEXTS } = await optionTexts();
    for (const [control, name] of this.titled) control.title = sentence(UNWRAP_TEXTS[name]);
    if (this.udim) this.udim.title += OPTIONS.tilesNeedDensity;
  }

  private setOpen(isOpen: boolean): void {
    this.panel.hidden = !isOpen;
    this.button.setAttribute('aria-expanded', String(isOpen));
    if (isOpen) this.panel.scrollIntoView({ block: 'nearest' });
  }

  get settings(): MoreOptions {
    return usedOptions(this.options);
  }

  /** Shows other options without asking for them. */
  restore(settings: MoreOptions): void {
    const { fixedFaces, tiles } = settings;
    this.options = { ...defaultOptions(), tiles, ...(fixedFaces && { fixedFaces }) };
    for (const name of MORE) Object.assign(this.options, { [name]: settings[name] });
    this.show();
  }

  /**
   * Another mesh was opened. Nobody has asked to keep its uv yet, unless only the texcoord set is
   * another one. `hasUv`: it has some.
   */
  open(hasUv: boolean, isReread: boolean): void {
    this.keepUv.hidden = !hasUv;
    const { fixedFaces, ...others } = this.options;
    if (!hasUv || !isReread) this.options = others;
    this.show();
  }

  /** Whether the mesh has several objects and materials, which can then have tiles of their own. */
  offerParts(hasObjects: boolean, hasMaterials: boolean): void {
    const has: Record<PartTiles, boolean> = { object: hasObjects, material: hasMaterials };
    for (const option of this.tiles.options)
      option.disabled = option.value !== 'one' && !has[option.value as PartTiles];
  }

  private set(some: Partial<MoreOptions>): void {
    this.options = { ...this.options, ...some };
    this.show();
    this.changed();
  }

  private show(): void {
    const changes = changedOptions(this.settings).join(', ');
    showText(this.state, changes);
    this.keepUv.setAttribute('aria-pressed', String(Boolean(this.options.fixedFaces)));
    for (const show of this.shows) show();
    if (this.udim) this.udim.disabled = !canHaveTiles(this.options);
  }

  private add(name: MoreName): void {
    if (name === 't' || name === 'texelDensity') this.addNumber(name);
    else if (name === 'straightSeams' || name === 'udim') this.addSwitch(name);
    else this.addChoice(name);
  }

  private addChoice(
    name: Exclude<MoreName, 't' | 'texelDensity' | 'straightSeams' | 'udim'>,
  ): void {
    const choices: readonly string[] = UNWRAP_OPTIONS[name].choices;
    const select = create('select', 'button');
    select.append(...choices.map((choice) => new Option(sentence(choice), choice)));
    this.shows.push(() => {
      select.value = this.options[name];
    });
    select.addEventListener('change', () => {
      const chosen = choices.find((choice) => choice === select.value);
      const some: Partial<MoreOptions> = {};
      if (chosen) this.set(Object.assign(some, { [name]: chosen }));
    });
    this.addRow(name, select);
  }

  private addTiles(): void {
    const { tiles } = this;
    const names = ['one', ...PART_TILES] as const;
    tiles.append(...names.map((name) => new Option(PACKING.tiles[name], name)));
    this.shows.push(() => {
      tiles.value = this.options.tiles ?? 'one';
    });
    tiles.addEventListener('change', () => {
      const chosen = PART_TILES.find((name) => name === tiles.value);
      this.set({ tiles: chosen });
    });
    this.row('more-tiles', OPTIONS.tiles, OPTIONS.aboutTiles, tiles);
  }

  private addNumber(name: 't' | 'texelDensity'): void {
    const input = create('input', 'number');
    const field = new NumberField(
      input,
      UNWRAP_OPTIONS[name],
      this.options[name],
      (value) => this.set({ [name]: value }),
      this.say,
    );
    this.shows.push(() => {
      if (field.value !== this.options[name]) field.restore(this.options[name]);
    });
    this.addRow(name, input);
  }

  private addSwitch(name: 'straightSeams' | 'udim'): void {
    const button = this.switchOf(idOf(name), MORE_LABELS[name], '');
    this.titled.push([button, name]);
    this.shows.push(() => button.setAttribute('aria-pressed', String(this.options[name])));
    button.addEventListener('click', () => this.set({ [name]: !this.options[name] }));
    if (name === 'udim') this.udim = button;
  }

  private switchOf(id: string, label: string, title: string): HTMLButtonElement {
    const button = create('button', 'tool', label);
    button.type = 'button';
    button.id = id;
    button.title = title;
    this.switches.append(button);
    return button;
  }

  private addRow(name: MoreName, control: HTMLInputElement | HTMLSelectElement): void {
    this.titled.push([this.row(idOf(name), MORE_LABELS[name], '', control), name]);
  }

  private row(
    id: string,
    name: string,
    about: string,
    control: HTMLInputElement | HTMLSelectElement,
  ): HTMLElement {
    const row = create('div', 'more-row');
    const label = create('label', '', name);
    control.id = id;
    label.htmlFor = id;
    row.title = about;
    row.append(label, control);
    this.panel.append(row);
    return row;
  }
}

/** "more-texel-density" */
function idOf(name: MoreName): string {
  return `more-${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
}
