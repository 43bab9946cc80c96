import { UNWRAP_DEFAULTS } from 'abflat';
import { RESOLUTIONS } from '../model/settings';
import { STRETCH_LIMIT } from '../words/controls';
import type { NumberField } from './number-field';

/** The padding that goes with a resolution: always the same share of it, as textures get smaller evenly. */
export const usualPadding = (texels: number): number =>
  Math.max(1, Math.round((UNWRAP_DEFAULTS.padding * texels) / UNWRAP_DEFAULTS.resolution));

/** Texels along a side. Until the padding is set by hand, it follows. */
export class ResolutionControl {
  private last: number = UNWRAP_DEFAULTS.resolution;

  constructor(
    private readonly select: HTMLSelectElement,
    padding: NumberField<number>,
    changed: () => void,
  ) {
    select.append(
      ...RESOLUTIONS.map((texels) => new Option(STRETCH_LIMIT.pixels(texels), String(texels))),
    );
    this.restore(this.last);
    select.addEventListener('change', () => {
      const isUsual = padding.value === usualPadding(this.last);
      this.last = this.value;
      if (isUsual) padding.restore(usualPadding(this.last));
      changed();
    });
  }

  get value(): number {
    return Number(this.select.value);
  }

  /** Shows another one without asking for it. */
  restore(texels: number): void {
    this.last = texels;
    this.select.value = String(texels);
  }
}
