import { UNWRAP_OPTIONS } from 'abflat';
import { create, element } from './dom';
import { sentence } from './format';
import {
  canHaveTiles,
  changedOptions,
  defaultOptions,
  MORE,
  MORE_LABELS,
  type MoreName,
  type MoreOptions,
  usedOptions,
} from './more-options';
import { NumberField } from './number-field';

/** The options of an atlas that open with a button, which says what of them is not as usual. */
export class MoreControl {
  private readonly button = element('more-toggle', HTMLButtonElement);
  private readonly panel = element('more', HTMLElement);
  private readonly state = element('more-state', HTMLElement);
  private readonly switches = create('div', 'more-switches');
  private udim: HTMLButtonElement | null = null;
  private options = defaultOptions();

  constructor(private readonly changed: () => void) {
    for (const name of MORE) this.add(name);
    this.panel.append(this.switches);
    this.show();
    this.button.addEventListener('click', () => {
      const isOpen = this.panel.hidden;
      this.panel.hidden = !isOpen;
      this.button.setAttribute('aria-expanded', String(isOpen));
    });
  }

  get settings(): MoreOptions {
    return usedOptions(this.options);
  }

  private set(some: Partial<MoreOptions>): void {
    this.options = { ...this.options, ...some };
    this.show();
    this.changed();
  }

  private show(): void {
    const changes = changedOptions(this.settings).join(', ');
    this.state.textContent = changes;
    this.state.title = changes;
    if (this.udim) this.udim.disabled = !canHaveTiles(this.options);
  }

  private add(name: MoreName): void {
    if (name === 'fillHoles') this.addChoice(name);
    else if (name === 't' || name === 'texelDensity') this.addNumber(name);
    else this.addSwitch(name);
  }

  private addChoice(name: 'fillHoles'): void {
    const { choices } = UNWRAP_OPTIONS[name];
    const select = create('select', 'button');
    select.append(...choices.map((choice) => new Option(sentence(choice), choice)));
    select.value = this.options[name];
    select.addEventListener('change', () => {
      const chosen = choices.find((choice) => choice === select.value);
      if (chosen) this.set({ [name]: chosen });
    });
    this.addRow(name, select);
  }

  private addNumber(name: 't' | 'texelDensity'): void {
    const input = create('input', 'number');
    new NumberField(input, UNWRAP_OPTIONS[name], this.options[name], (value) =>
      this.set({ [name]: value }),
    );
    this.addRow(name, input);
  }

  private addSwitch(name: 'straightSeams' | 'rotate' | 'udim'): void {
    const button = create('button', 'tool', MORE_LABELS[name]);
    button.type = 'button';
    button.id = idOf(name);
    button.title = sentence(UNWRAP_OPTIONS[name].text);
    button.setAttribute('aria-pressed', String(this.options[name]));
    button.addEventListener('click', () => {
      button.setAttribute('aria-pressed', String(!this.options[name]));
      this.set({ [name]: !this.options[name] });
    });
    this.switches.append(button);
    if (name !== 'udim') return;
    button.title += '. Needs a texel density';
    this.udim = button;
  }

  private addRow(name: MoreName, control: HTMLInputElement | HTMLSelectElement): void {
    const row = create('div', 'more-row');
    const label = create('label', '', MORE_LABELS[name]);
    control.id = idOf(name);
    label.htmlFor = control.id;
    row.title = sentence(UNWRAP_OPTIONS[name].text);
    row.append(label, control);
    this.panel.append(row);
  }
}

/** "more-texel-density" */
function idOf(name: MoreName): string {
  return `more-${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
}
