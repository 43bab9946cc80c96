import { PACK_DEFAULTS, PACK_OPTIONS } from 'abflat';
import { element } from '../base/dom';
import {
  isAsInFile,
  type PackChoices,
  type PackSettings,
  packSettings,
  TILES,
  type Tiles,
  usualPackChoices,
} from '../model/settings';
import { sentence } from '../words/format';
import { PACKING } from '../words/selection';
import { NumberField } from './number-field';
import { optionTexts } from './option-texts';
import { ResolutionControl } from './resolution-control';

export interface PackEvents {
  changed(): void;
  /** Islands are to be relaxed: the selected ones, or all. */
  relaxIslands(): void;
  /** Those that are selected are to be packed; returns whether any are. */
  packSelected(choices: PackChoices): boolean;
  say(text: string): void;
}

/** The UVs of the file as they are, or packed and how. */
export class PackControl {
  private readonly keep = element('pack-keep', HTMLButtonElement);
  private readonly pack = element('pack-islands', HTMLButtonElement);
  private readonly how = element('pack-how', HTMLElement);
  private readonly resolution: ResolutionControl;
  private readonly rotate = element('pack-rotate', HTMLSelectElement);
  private readonly sizes = element('pack-sizes', HTMLSelectElement);
  private readonly tiles = element('pack-tiles', HTMLSelectElement);
  private readonly padding: NumberField<number>;
  private readonly margin: NumberField<PackChoices['margin']>;
  private readonly scope = element('pack-scope', HTMLElement);
  private keepsPlaces = true;
  private uv: PackSettings['uv'];
  private selected = 0;

  constructor(private readonly events: PackEvents) {
    const { changed, say } = events;
    const usual = usualPackChoices();
    fill(this.rotate, PACK_OPTIONS.rotate.choices);
    fill(this.sizes, PACK_OPTIONS.islandSizes.choices);
    this.tiles.append(...TILES.map((tiles) => new Option(PACKING.tiles[tiles], tiles)));
    this.tiles.title = PACKING.aboutTiles;
    const number = <T extends number | 'auto'>(name: 'padding' | 'margin', value: T) => {
      const input = element(`pack-${name}`, HTMLInputElement);
      return new NumberField<T>(input, PACK_OPTIONS[name], value, changed, say);
    };
    this.padding = number<number>('padding', usual.padding);
    this.margin = number<PackChoices['margin']>('margin', usual.margin);
    this.resolution = new ResolutionControl(
      element('pack-resolution', HTMLSelectElement),
      this.padding,
      changed,
    );
    this.reset();
    this.offerParts(false, false);
    for (const select of [this.rotate, this.sizes, this.tiles])
      select.addEventListener('change', changed);
    this.keep.addEventListener('click', () => this.setKeeping(true));
    this.pack.addEventListener('click', () => {
      if (!events.packSelected(this.choices)) this.setKeeping(false);
    });
    element('pack-relax', HTMLButtonElement).addEventListener('click', () => events.relaxIslands());
    element('pack-options', HTMLFormElement).addEventListener('submit', (event) =>
      event.preventDefault(),
    );
  }

  async loadRest(): Promise<void> {
    const { PACK_TEXTS } = await optionTexts();
    for (const name of ['padding', 'margin'] as const)
      element(`pack-${name}`, HTMLInputElement).title = sentence(PACK_TEXTS[name]);
    this.rotate.title = sentence(PACK_TEXTS.rotate);
    this.sizes.title = sentence(PACK_TEXTS.islandSizes);
  }

  get settings(): PackSettings {
    return packSettings(this.keepsPlaces, this.resolution.value, this.choices, this.uv);
  }

  private get choices(): PackChoices {
    return {
      padding: this.padding.value,
      margin: this.margin.value,
      rotate: this.rotate.value as PackChoices['rotate'],
      islandSizes: this.sizes.value as PackChoices['islandSizes'],
      tiles: this.tiles.value as PackChoices['tiles'],
    };
  }

  /** Another mesh was opened: nobody has asked to pack it. */
  reset(): void {
    const { resolution } = PACK_DEFAULTS;
    this.restore({ mode: 'pack', keepPlaces: true, resolution, tiles: 'one' });
    this.offerParts(false, false);
  }

  /** Whether the mesh has several objects and materials, which can then have tiles of their own. */
  offerParts(hasObjects: boolean, hasMaterials: boolean): void {
    const has = { one: true, file: true, object: hasObjects, material: hasMaterials };
    for (const option of this.tiles.options) option.disabled = !has[option.value as Tiles];
  }

  /** Asks for the islands to be packed, or for the UVs as they are. */
  setKeeping(keepsPlaces: boolean): void {
    const isSame = keepsPlaces === this.keepsPlaces;
    if (isSame && !(keepsPlaces && this.uv)) return;
    this.keepsPlaces = keepsPlaces;
    if (keepsPlaces) this.uv = undefined;
    this.show();
    this.events.changed();
  }

  /** Islands were changed by hand. Shows that without asking for it. */
  give(uv: PackSettings['uv']): void {
    this.keepsPlaces = true;
    this.uv = uv;
    this.show();
  }

  /** How many islands are selected, which are then meant. */
  showSelected(count: number): void {
    this.selected = count;
    this.show();
  }

  /** Shows other settings without asking for them; choices that are not there stay. */
  restore({ keepPlaces, resolution, uv, ...choices }: PackSettings): void {
    this.uv = uv;
    const { padding, margin, rotate, islandSizes, tiles } = choices;
    this.keepsPlaces = keepPlaces;
    this.resolution.restore(resolution);
    if (padding !== undefined) this.padding.restore(padding);
    if (margin !== undefined) this.margin.restore(margin);
    if (rotate !== undefined) this.rotate.value = rotate;
    if (islandSizes !== undefined) this.sizes.value = islandSizes;
    if (tiles !== undefined) this.tiles.value = tiles;
    this.show();
  }

  private show(): void {
    const { selected } = this;
    this.keep.ariaPressed = String(isAsInFile(this.settings));
    this.pack.ariaPressed = String(!this.keepsPlaces);
    this.how.hidden = this.keepsPlaces && selected === 0;
    this.scope.textContent = PACKING.scope(selected);
  }
}

function fill(select: HTMLSelectElement, choices: readonly string[]): void {
  select.append(...choices.map((choice) => new Option(sentence(choice), choice)));
}
