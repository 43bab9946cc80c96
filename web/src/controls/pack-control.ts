import { PACK_DEFAULTS, PACK_OPTIONS } from 'abflat';
import { element } from '../base/dom';
import {
  type PackChoices,
  type PackSettings,
  packSettings,
  usualPackChoices,
} from '../model/settings';
import { sentence } from '../words/format';
import { NumberField } from './number-field';
import { ResolutionControl } from './resolution-control';

/** The UVs of the file as they are, or packed and how. */
export class PackControl {
  private readonly keep = element('pack-keep', HTMLButtonElement);
  private readonly pack = element('pack-islands', HTMLButtonElement);
  private readonly how = element('pack-how', HTMLElement);
  private readonly resolution: ResolutionControl;
  private readonly rotate = element('pack-rotate', HTMLSelectElement);
  private readonly sizes = element('pack-sizes', HTMLSelectElement);
  private readonly padding: NumberField<number>;
  private readonly margin: NumberField<PackChoices['margin']>;
  private keepsPlaces = true;

  constructor(
    private readonly changed: () => void,
    say: (text: string) => void,
  ) {
    const usual = usualPackChoices();
    fill(this.rotate, PACK_OPTIONS.rotate);
    fill(this.sizes, PACK_OPTIONS.islandSizes);
    const number = <T extends number | 'auto'>(name: 'padding' | 'margin', value: T) => {
      const input = element(`pack-${name}`, HTMLInputElement);
      input.title = sentence(PACK_OPTIONS[name].text);
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
    for (const select of [this.rotate, this.sizes]) select.addEventListener('change', changed);
    this.keep.addEventListener('click', () => this.setKeeping(true));
    this.pack.addEventListener('click', () => this.setKeeping(false));
    element('pack-options', HTMLFormElement).addEventListener('submit', (event) =>
      event.preventDefault(),
    );
  }

  get settings(): PackSettings {
    return packSettings(this.keepsPlaces, this.resolution.value, {
      padding: this.padding.value,
      margin: this.margin.value,
      rotate: this.rotate.value as PackChoices['rotate'],
      islandSizes: this.sizes.value as PackChoices['islandSizes'],
    });
  }

  /** Another mesh was opened: nobody has asked to pack it. */
  reset(): void {
    this.restore({ mode: 'pack', keepPlaces: true, resolution: PACK_DEFAULTS.resolution });
  }

  /** Asks for the islands to be packed, or for the UVs as they are. */
  setKeeping(keepsPlaces: boolean): void {
    if (keepsPlaces === this.keepsPlaces) return;
    this.keepsPlaces = keepsPlaces;
    this.show();
    this.changed();
  }

  /** Shows other settings without asking for them; choices that are not there stay. */
  restore({ keepPlaces, resolution, ...choices }: PackSettings): void {
    const { padding, margin, rotate, islandSizes } = choices;
    this.keepsPlaces = keepPlaces;
    this.resolution.restore(resolution);
    if (padding !== undefined) this.padding.restore(padding);
    if (margin !== undefined) this.margin.restore(margin);
    if (rotate !== undefined) this.rotate.value = rotate;
    if (islandSizes !== undefined) this.sizes.value = islandSizes;
    this.show();
  }

  private show(): void {
    this.keep.ariaPressed = String(this.keepsPlaces);
    this.pack.ariaPressed = String(!this.keepsPlaces);
    this.how.hidden = this.keepsPlaces;
  }
}

function fill(
  select: HTMLSelectElement,
  { choices, text }: { readonly choices: readonly string[]; readonly text: string },
): void {
  select.append(...choices.map((choice) => new Option(sentence(choice), choice)));
  select.title = sentence(text);
}
