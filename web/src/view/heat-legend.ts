import { create, element } from '../base/dom';
import { BARS, type Measure, SCALES, type Spread } from '../model/measures';
import { HEAT_LEGEND } from '../words/view';
import { BEYOND, type Chosen } from './heat-uniforms';

/** The height of a bar grows with the root of its share, so that the few bad triangles are seen beside the many good ones. */
const heightOf = (share: number) => `${(100 * Math.sqrt(share)).toFixed(1)}%`;

/** `share` as "12 %", and as "under 0.1 %" where it is that small. */
function shareText(share: number): string {
  if (share > 0 && share < 0.001) return HEAT_LEGEND.underPercent('0.1');
  return HEAT_LEGEND.percent((100 * share).toFixed(share < 0.1 ? 1 : 0));
}

/** The range of a bar in words, such as "Area ×0.50 to ×0.54". */
function rangeText(measure: Measure, bar: number, mean: number): string {
  const { title, value, text, isTwoSided } = SCALES[measure];
  const [from, to] = [bar, bar + 1].map((end) => text(value(end / BARS), mean));
  if (bar === BARS - 1) return HEAT_LEGEND.andMore(`${title} ${from}`);
  if (bar === 0 && isTwoSided) return HEAT_LEGEND.andLess(`${title} ${to}`);
  return HEAT_LEGEND.fromTo(title, from, to);
}

/** The ends of the ramp are open: what lies beyond them is in the last bars. */
function rangeOf(bar: number): Chosen {
  return {
    low: bar === 0 ? -BEYOND : bar / BARS,
    high: bar === BARS - 1 ? BEYOND : (bar + 1) / BARS,
    isDistance: false,
  };
}

/** Scale and histogram of a heat map. A bar lights its triangles in both views, and so does the button for the worst. */
export class HeatLegend {
  private readonly box = element('legend', HTMLElement);
  private readonly title = element('legend-title', HTMLElement);
  private readonly bars = element('legend-bars', HTMLElement);
  private readonly ramp = element('legend-bar', HTMLElement);
  private readonly low = element('legend-low', HTMLElement);
  private readonly high = element('legend-most', HTMLElement);
  private readonly said = element('legend-said', HTMLElement);
  private readonly worst = element('legend-worst', HTMLButtonElement);
  private measure: Measure = 'angle';
  private spread: Spread | null = null;
  /** The bar, or all of the worst. */
  private chosen: number | 'worst' | null = null;

  constructor(private readonly choose: (chosen: Chosen | null) => void) {
    for (let bar = 0; bar < BARS; ++bar) {
      const button = create('button', 'legend-column');
      button.type = 'button';
      button.tabIndex = bar === 0 ? 0 : -1;
      button.append(create('span', 'legend-fill'));
      button.addEventListener('click', () => this.toggle(bar));
      button.addEventListener('pointerenter', () => this.say(bar));
      button.addEventListener('focus', () => this.say(bar));
      this.bars.append(button);
    }
    this.bars.addEventListener('pointerleave', () => this.say(this.chosen));
    this.bars.addEventListener('keydown', (event) => this.onKey(event));
    this.worst.addEventListener('click', () => this.toggle('worst'));
  }

  show(measure: Measure, spread: Spread): void {
    if (measure !== this.measure || spread !== this.spread) this.select(null);
    this.measure = measure;
    this.spread = spread;
    const { title, explanation, value, text, isTwoSided } = SCALES[measure];
    this.title.textContent = title;
    this.title.title = explanation;
    const low = text(value(0), spread.mean);
    this.low.textContent = isTwoSided ? HEAT_LEGEND.andLess(low) : low;
    this.high.textContent = HEAT_LEGEND.andMore(text(value(1), spread.mean));
    this.ramp.classList.toggle('two-sided', isTwoSided);
    this.columns.forEach((column, bar) => {
      (column.firstElementChild as HTMLElement).style.height = heightOf(spread.shares[bar]);
      column.setAttribute('aria-label', this.lineOf(bar));
    });
    this.box.hidden = false;
    this.say(this.chosen);
  }

  /** Lights the worst of the surface. */
  showWorst(): void {
    this.select('worst');
    this.say('worst');
  }

  hide(): void {
    this.select(null);
    this.box.hidden = true;
  }

  private get columns(): HTMLButtonElement[] {
    return [...this.bars.children] as HTMLButtonElement[];
  }

  private toggle(bar: number | 'worst'): void {
    this.select(this.chosen === bar ? null : bar);
    this.say(this.chosen);
  }

  private select(chosen: number | 'worst' | null): void {
    this.chosen = chosen;
    this.columns.forEach((column, bar) => {
      column.setAttribute('aria-pressed', String(bar === chosen));
    });
    this.worst.setAttribute('aria-pressed', String(chosen === 'worst'));
    if (chosen === 'worst')
      this.choose({ low: this.spread?.worst ?? 0, high: BEYOND, isDistance: true });
    else this.choose(chosen === null ? null : rangeOf(chosen));
  }

  private say(bar: number | 'worst' | null): void {
    if (bar === null) this.said.textContent = HEAT_LEGEND.selectBar;
    else if (bar === 'worst') this.said.textContent = HEAT_LEGEND.worst;
    else this.said.textContent = this.lineOf(bar);
  }

  private lineOf(bar: number): string {
    if (!this.spread) return '';
    const { shares, mean } = this.spread;
    return HEAT_LEGEND.ofSurface(rangeText(this.measure, bar, mean), shareText(shares[bar]));
  }

  /** The bars are one stop of the Tab key; arrows move between them. */
  private onKey(event: KeyboardEvent): void {
    const { columns } = this;
    const at = columns.indexOf(document.activeElement as HTMLButtonElement);
    const steps: Record<string, number> = {
      ArrowLeft: at - 1,
      ArrowRight: at + 1,
      Home: 0,
      End: BARS - 1,
    };
    const next = columns[steps[event.key] ?? -1];
    if (!next) return;
    event.preventDefault();
    columns.forEach((column) => {
      column.tabIndex = column === next ? 0 : -1;
    });
    next.focus();
  }
}
