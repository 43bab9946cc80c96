import { FLATTEN_DEFAULTS, UNWRAP_DEFAULTS } from 'abflat';
import { element } from '../base/dom';
import { BALANCE } from '../words/controls';

export const BALANCE_STEP = 0.05;
const DEFAULTS = { flatten: FLATTEN_DEFAULTS.balance, unwrap: UNWRAP_DEFAULTS.balance };

/** The slider between angles and lengths; each kind of layout has its own. */
export class BalanceControl {
  private readonly slider: HTMLInputElement;
  private readonly output: HTMLOutputElement;

  constructor(mode: 'flatten' | 'unwrap', changed: () => void) {
    this.slider = element(`${mode}-balance`, HTMLInputElement);
    this.output = element(`${mode}-balance-value`, HTMLOutputElement);
    this.slider.step = String(BALANCE_STEP);
    this.slider.valueAsNumber = DEFAULTS[mode];
    this.show();
    this.slider.addEventListener('input', () => {
      this.show();
      changed();
    });
  }

  get balance(): number {
    return this.slider.valueAsNumber;
  }

  /** Shows another value without asking for it. */
  restore(balance: number): void {
    this.slider.valueAsNumber = balance;
    this.show();
  }

  private show(): void {
    const { balance } = this;
    this.output.value = String(balance);
    this.slider.setAttribute('aria-valuetext', BALANCE.readOut(balance, meaning(balance)));
    this.slider.style.setProperty('--value', String(balance));
  }
}

function meaning(balance: number): string {
  if (balance === 0) return BALANCE.angles;
  if (balance === 1) return BALANCE.lengths;
  return BALANCE.between;
}
