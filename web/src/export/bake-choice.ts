import '../css/baking.css';
import { create, element } from '../base/dom';
import { hasColors } from '../files/has-look';
import { isOneTile } from '../model/bake-settings';
import { type Bakeable, bakedFormats, type ImageSide, isBakeable } from '../model/baking';
import type { Outcome } from '../model/model';
import { BAKE_CHOICE } from '../words/baking';
import type { ExportFormat } from '../words/generated-formats';

const SIDES: ImageSide[] = ['auto', 1024, 2048, 4096, 8192];

/** Whether textures follow the new layout: a button, and in the menu of exports with the size of their images. */
export class BakeChoice {
  private readonly item = itemOf('menuitemcheckbox', BAKE_CHOICE.title);
  private readonly button = element('bake-too', HTMLButtonElement);
  private readonly what = create('small', 'bake-what');
  private readonly sizes = create('div', 'bake-sizes');
  private side: ImageSide = 'auto';
  private outcome: Outcome | null = null;
  /** The outcome, if it has anything to bake. */
  private offered: Bakeable | null = null;
  /** Of files that were looked at, whether their vertices have colours. */
  private readonly colored = new WeakMap<File, boolean>();

  constructor(private readonly changed: () => void) {
    this.item.id = 'bake';
    this.item.append(' ', this.what);
    for (const each of [this.item, this.button])
      each.addEventListener('click', () => this.choose(!this.isOn, this.side));
    this.sizes.role = 'group';
    this.sizes.ariaLabel = BAKE_CHOICE.sides;
    this.sizes.append(...SIDES.map((side) => this.sizeOf(side)));
    element('export-menu', HTMLElement)
      .querySelector('.menu-action')
      ?.before(this.item, this.sizes);
    this.reset();
  }

  show(outcome: Outcome | null): void {
    this.outcome = outcome;
    const file = outcome?.source.kind === 'file' ? outcome.source.file : null;
    if (file && !this.colored.has(file)) void this.look(file);
    const isColored = file !== null && Boolean(this.colored.get(file));
    this.offered = isBakeable(outcome, isColored) ? outcome : null;
    this.item.hidden = this.offered === null;
    this.item.disabled = this.offered === null || !isOneTile(this.offered);
    this.button.disabled = this.item.disabled;
    this.what.textContent =
      this.offered && this.item.disabled ? BAKE_CHOICE.oneTile : BAKE_CHOICE.what;
    this.update();
  }

  reset(): void {
    this.side = 'auto';
    this.item.ariaChecked = 'false';
    this.update();
  }

  get imageSide(): ImageSide | null {
    return this.isOn && !this.item.disabled ? this.side : null;
  }

  /** What gets new images. */
  get formats(): ExportFormat[] {
    return this.offered && this.imageSide !== null ? bakedFormats(this.offered) : [];
  }

  private async look(file: File): Promise<void> {
    this.colored.set(file, false);
    // What cannot be read any more has no colours.
    this.colored.set(file, await hasColors(file).catch(() => false));
    this.show(this.outcome);
  }

  private get isOn(): boolean {
    return this.item.ariaChecked === 'true';
  }

  private choose(isOn: boolean, side: ImageSide): void {
    this.item.ariaChecked = String(isOn);
    this.side = side;
    this.update();
    this.changed();
  }

  private update(): void {
    this.sizes.hidden = this.imageSide === null;
    this.button.ariaPressed = String(this.imageSide !== null);
    for (const size of this.sizes.querySelectorAll('button'))
      size.ariaChecked = String(size.dataset.value === String(this.side));
  }

  private sizeOf(side: ImageSide): HTMLButtonElement {
    const size = itemOf('menuitemradio', BAKE_CHOICE.side(side));
    size.dataset.value = String(side);
    if (side === 'auto') size.title = BAKE_CHOICE.auto;
    size.addEventListener('click', () => this.choose(true, side));
    return size;
  }
}

/** An item of the menu, which stays open. */
function itemOf(role: string, text: string): HTMLButtonElement {
  const item = create('button', '', text);
  item.type = 'button';
  item.role = role;
  item.tabIndex = -1;
  return item;
}
