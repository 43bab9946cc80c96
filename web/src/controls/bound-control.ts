import { type ChartReport, FLATTEN_DEFAULTS } from 'abflat';
import { create, element } from '../base/dom';
import { BOUND, NUMBERS } from '../words/controls';
import { type Bound, bound } from '../words/format';

export const LEAST = 0.9;
export const MOST = 2;
/** The bounds of one piece that the slider offers. */
export const BOUND_RULE = { type: 'number', atLeast: LEAST, atMost: MOST };
export const STEP = 0.01;
const TICKS = [
  { t: 0.9, name: '' },
  { t: 1, name: BOUND.convex },
  { t: 1.25, name: '' },
  { t: 1.5, name: '' },
  { t: 1.75, name: '' },
  { t: 2, name: BOUND.free },
];

/** Slider and number field for t. */
export class BoundControl {
  private readonly slider = element('t', HTMLInputElement);
  private readonly field = element('t-number', HTMLInputElement);
  private readonly hint = element('t-hint', HTMLElement);
  private readonly auto = element('t-auto', HTMLButtonElement);
  /** The current t; with auto the one that was found, and free until then. */
  private current = MOST;
  private isAuto = FLATTEN_DEFAULTS.t === 'auto';

  constructor(
    private readonly changed: (t: Bound) => void,
    private readonly say: (text: string) => void,
  ) {
    for (const input of [this.slider, this.field]) {
      input.min = String(LEAST);
      input.max = String(MOST);
    }
    this.slider.step = String(STEP);
    // The paper's examples need three decimals, while arrow keys step by one hundredth.
    this.field.step = 'any';
    this.addTicks();
    this.setAuto(this.isAuto);
    this.show();
    this.slider.addEventListener('input', () => this.set(this.slider.valueAsNumber));
    this.field.addEventListener('input', () => this.readField());
    this.field.addEventListener('change', () => {
      if (this.field.ariaInvalid === 'true') this.refuse();
      this.show();
    });
    this.field.addEventListener('keydown', (event) => this.onKey(event));
    this.auto.addEventListener('click', () => {
      if (this.isAuto) return this.set(this.current);
      this.setAuto(true);
      this.showSlider();
      this.changed('auto');
    });
    element('flatten-options', HTMLFormElement).addEventListener('submit', (event) =>
      event.preventDefault(),
    );
  }

  get t(): Bound {
    return this.isAuto ? 'auto' : this.current;
  }

  /** Asks for t, as if the user had moved the slider there. */
  choose(t: Bound): void {
    if (t !== 'auto') this.set(t);
    else if (!this.isAuto) this.auto.click();
  }

  /** Shows another t without asking for it. */
  restore(t: Bound): void {
    this.setAuto(t === 'auto');
    if (t !== 'auto') this.current = t;
    this.show();
  }

  /** Shows the t that the automatic choice found. */
  showFound(chart: ChartReport): void {
    if (!this.isAuto) return;
    this.current = Math.min(MOST, Math.max(LEAST, chart.t));
    this.show();
  }

  /** Hatches the infeasible part of the slider: t is at least 1 - 2/n for n boundary vertices. */
  setBoundaryVertices(n: number | null): void {
    const least = n === null ? 0 : 1 - 2 / n;
    const share = Math.min(1, Math.max(0, (least - LEAST) / (MOST - LEAST)));
    this.slider.style.setProperty('--impossible', String(share));
  }

  private set(t: number): void {
    if (t === this.current && !this.isAuto) return;
    this.setAuto(false);
    this.current = t;
    this.show();
    this.changed(t);
  }

  private setAuto(isOn: boolean): void {
    this.isAuto = isOn;
    this.auto.setAttribute('aria-pressed', String(isOn));
  }

  private readField(): void {
    const t = this.field.valueAsNumber;
    const isUsable = t >= LEAST && t <= MOST;
    this.field.setAttribute('aria-invalid', String(!isUsable));
    if (!isUsable) {
      this.hint.textContent = NUMBERS.range(BOUND_RULE);
      return;
    }
    if (t === this.current && !this.isAuto) return;
    this.setAuto(false);
    this.current = t;
    this.showSlider();
    this.changed(t);
  }

  private refuse(): void {
    this.say(NUMBERS.refused('t', this.field.value, NUMBERS.range(BOUND_RULE), bound(this.t)));
  }

  private onKey(event: KeyboardEvent): void {
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const t = Math.round((this.current + direction * STEP) * 1000) / 1000;
    this.set(Math.min(MOST, Math.max(LEAST, t)));
  }

  private show(): void {
    this.field.value = bound(this.current);
    this.field.setAttribute('aria-invalid', 'false');
    this.showSlider();
  }

  private showSlider(): void {
    this.slider.valueAsNumber = this.current;
    const angles = meaning(this.current);
    const hint = this.isAuto ? BOUND.found(angles) : angles;
    this.slider.setAttribute('aria-valuetext', BOUND.readOut(this.current, hint));
    this.slider.style.setProperty('--value', String((this.current - LEAST) / (MOST - LEAST)));
    this.hint.textContent = hint;
  }

  private addTicks(): void {
    const ticks = element('ticks', HTMLElement);
    for (const { t, name } of TICKS) {
      const tick = name ? create('button', 'tick') : create('span', 'tick');
      tick.style.setProperty('--at', String((t - LEAST) / (MOST - LEAST)));
      tick.append(create('span', 'tick-value', bound(t)));
      if (tick instanceof HTMLButtonElement) {
        tick.type = 'button';
        tick.prepend(create('span', 'visually-hidden', BOUND.beforeTick));
        tick.append(' ', create('span', 'tick-name', name));
        tick.addEventListener('click', () => this.set(t));
      }
      ticks.append(tick);
    }
  }
}

/** What t means for the boundary's interior angles. */
export function meaning(t: number): string {
  if (t >= MOST) return BOUND.free;
  if (t === 1) return BOUND.convex;
  return BOUND.upTo(Math.round(180 * t * 10) / 10);
}
