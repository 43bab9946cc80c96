import { element } from '../base/dom';
import { fits, refusal } from '../controls/number-field';
import { DENSITY_RULE } from '../model/face-densities';
import { NUMBERS } from '../words/controls';
import { SELECTION } from '../words/selection';

/** The texel density of the selected charts relative to the others. */
export class DensityField {
  private readonly label = element('selection-density-label', HTMLElement);
  private readonly input = element('selection-density', HTMLInputElement);
  private shown = '';

  /** `changed`: another density is wanted. */
  constructor(changed: (density: number) => void, say: (text: string) => void) {
    const { input } = this;
    input.addEventListener('input', () => this.mark(fits(input.valueAsNumber, DENSITY_RULE)));
    input.addEventListener('change', () => {
      const density = input.valueAsNumber;
      if (fits(density, DENSITY_RULE)) {
        if (input.value !== this.shown) changed(density);
        return;
      }
      say(
        refusal(
          SELECTION.density,
          input.value,
          NUMBERS.range(DENSITY_RULE),
          this.shown || SELECTION.mixedDensity,
        ),
      );
      this.show(this.shown);
    });
    // Takes back what was typed before it selects nothing.
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || input.value === this.shown) return;
      event.stopPropagation();
      this.show(this.shown);
    });
  }

  /** Shows what the selected charts have. */
  update(densities: number[]): void {
    this.label.hidden = densities.length === 0;
    const texts = new Set(densities.map((density) => String(Number(density.toPrecision(3)))));
    const [text] = texts;
    this.show(texts.size === 1 ? text : '');
  }

  private show(text: string): void {
    this.shown = text;
    this.input.value = text;
    this.mark(true);
  }

  private mark(isValid: boolean): void {
    this.input.setAttribute('aria-invalid', String(!isValid));
  }
}
