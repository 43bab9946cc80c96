import { DENSITY_RULE } from '../model/face-densities';
import { NUMBERS } from '../words/controls';
import { SELECTION } from '../words/selection';
import { fits, refusal } from './number-field';

/** The texel density of some charts relative to the others. */
export class DensityField {
  private shown = '';

  /** `changed`: another density is wanted. */
  constructor(
    private readonly input: HTMLInputElement,
    changed: (density: number) => void,
    say: (text: string) => void,
  ) {
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
      this.putBack();
    });
    // Takes back what was typed before it selects nothing.
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || input.value === this.shown) return;
      event.stopPropagation();
      this.putBack();
    });
  }

  /** Shows what the charts have. */
  update(densities: number[]): void {
    const texts = new Set(densities.map((density) => String(Number(density.toPrecision(3)))));
    const [text] = texts;
    this.shown = texts.size === 1 ? text : '';
    this.putBack();
  }

  /** Shows again what was there. */
  putBack(): void {
    this.input.value = this.shown;
    this.mark(true);
  }

  private mark(isValid: boolean): void {
    this.input.setAttribute('aria-invalid', String(!isValid));
  }
}
