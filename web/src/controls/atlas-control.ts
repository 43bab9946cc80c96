import { type MeshSummary, UNWRAP_DEFAULTS, UNWRAP_OPTIONS } from 'abflat';
import { create, element } from '../base/dom';
import type { UnwrapSettings } from '../model/settings';
import { STRETCH_LIMIT } from '../words/controls';
import { BalanceControl } from './balance-control';
import { MoreControl } from './more-control';
import { NumberField } from './number-field';
import { ResolutionControl } from './resolution-control';

/** Stops of the slider, from nearly no stretch to hardly any seams. */
export const STRETCHES = [
  1.005, 1.01, 1.015, 1.02, 1.03, 1.04, 1.05, 1.06, 1.08, 1.1, 1.15, 1.2, 1.3, 1.5, 2,
];
/** Labels below the slider; at its ends they say what that end is good for. */
const TICKS = [
  { stretch: 1.005, name: STRETCH_LIMIT.more },
  { stretch: UNWRAP_DEFAULTS.maxStretch, name: '' },
  { stretch: 1.1, name: '' },
  { stretch: 2, name: STRETCH_LIMIT.fewer },
];

/** Stretch, resolution, padding and the less common options of an atlas. */
export class AtlasControl {
  private readonly slider = element('stretch', HTMLInputElement);
  private readonly value = element('stretch-value', HTMLOutputElement);
  private readonly hint = element('stretch-hint', HTMLElement);
  private readonly resolution: ResolutionControl;
  private readonly padding: NumberField<number>;
  private readonly balance: BalanceControl;
  private readonly more: MoreControl;

  /** Whether charts are cut until they keep within the stretch limit. */
  private isCutting = true;

  constructor(
    private readonly changed: () => void,
    say: (text: string) => void,
  ) {
    this.slider.max = String(STRETCHES.length - 1);
    this.slider.valueAsNumber = STRETCHES.indexOf(UNWRAP_DEFAULTS.maxStretch);
    this.padding = new NumberField<number>(
      element('padding', HTMLInputElement),
      UNWRAP_OPTIONS.padding,
      UNWRAP_DEFAULTS.padding,
      changed,
      say,
    );
    this.resolution = new ResolutionControl(
      element('resolution', HTMLSelectElement),
      this.padding,
      changed,
    );
    this.balance = new BalanceControl('unwrap', changed);
    this.more = new MoreControl(changed, say);
    this.addTicks();
    this.showStretch();
    this.slider.addEventListener('input', () => {
      this.showStretch();
      this.changed();
    });
    element('unwrap-options', HTMLFormElement).addEventListener('submit', (event) =>
      event.preventDefault(),
    );
  }

  loadRest(): Promise<void> {
    return this.more.loadRest();
  }

  /** Another mesh was opened. */
  open({ summary, isReread }: { summary: MeshSummary; isReread: boolean }): void {
    this.more.open(summary.texcoords > 0, isReread);
  }

  /** What the mesh has several of. */
  offerParts(hasObjects: boolean, hasMaterials: boolean): void {
    this.more.offerParts(hasObjects, hasMaterials);
  }

  get settings(): Omit<UnwrapSettings, 'seams' | 'seamEdges'> {
    return {
      mode: 'unwrap',
      maxStretch: STRETCHES[this.slider.valueAsNumber],
      balance: this.balance.balance,
      resolution: this.resolution.value,
      padding: this.padding.value,
      ...this.more.settings,
    };
  }

  /** Shows other settings without asking for them. */
  restore({ maxStretch, balance, resolution, padding, ...others }: UnwrapSettings): void {
    this.slider.valueAsNumber = STRETCHES.indexOf(maxStretch);
    this.resolution.restore(resolution);
    this.padding.restore(padding);
    this.balance.restore(balance);
    this.more.restore(others);
    this.showStretch();
  }

  /** Without automatic seams the limit is only checked. */
  setCutting(isCutting: boolean): void {
    this.isCutting = isCutting;
    this.showStretch();
  }

  private showStretch(): void {
    const { maxStretch } = this.settings;
    const lengths = STRETCH_LIMIT.lengths(lengthChange(maxStretch));
    const hint = this.isCutting ? lengths : STRETCH_LIMIT.notEnforced;
    this.value.value = String(maxStretch);
    this.hint.textContent = hint;
    this.hint.title = this.isCutting ? STRETCH_LIMIT.about : STRETCH_LIMIT.aboutNotEnforced;
    this.slider.setAttribute('aria-valuetext', STRETCH_LIMIT.readOut(maxStretch, hint));
    this.slider.style.setProperty('--value', String(share(maxStretch)));
  }

  private addTicks(): void {
    const ticks = element('stretch-ticks', HTMLElement);
    for (const { stretch, name } of TICKS) {
      const tick = create('span', 'tick');
      tick.style.setProperty('--at', String(share(stretch)));
      tick.append(create('span', 'tick-value', String(stretch)), create('span', 'tick-name', name));
      ticks.append(tick);
    }
  }
}

const share = (stretch: number) => STRETCHES.indexOf(stretch) / (STRETCHES.length - 1);

/**
 * The change in length, in percent: stretching by s in one direction and by 1/s across it has the
 * energy (s^2 + 1/s^2) / 2 = cosh(2 log s).
 */
function lengthChange(energy: number): number {
  return Math.round(100 * (Math.exp(Math.acosh(energy) / 2) - 1));
}
