import type { VerifyOptions } from 'abflat';
import { create } from '../base/dom';
import { NumberField } from '../controls/number-field';
import { RESOLUTIONS } from '../model/settings';
import { STRETCH_LIMIT } from '../words/controls';
import { VERIFY_OPTIONS } from '../words/generated-option-texts';
import { VERIFY_RULES } from '../words/verify';

const ALLOWED = ['allowStacked', 'allowMirrored', 'allowOutsideTiles'] as const;

/** An empty field stands for no limit. */
const STRETCH = { ...VERIFY_OPTIONS.maxStretch, words: { auto: 0 } };

/** What the user asks of a layout. */
export class VerifyRules {
  readonly element = create('div', 'verify-rules');
  private readonly resolution = create('select', 'button');
  private readonly padding: NumberField<number>;
  private readonly stretch: NumberField<number | 'auto'>;
  private readonly allowed = new Map<string, HTMLButtonElement>();
  /** Whether the user has chosen a resolution, which then stays. */
  private isChosen = false;

  constructor(changed: () => void, say: (text: string) => void) {
    this.resolution.append(
      ...RESOLUTIONS.map((n) => new Option(STRETCH_LIMIT.pixels(n), String(n))),
    );
    this.resolution.value = String(VERIFY_OPTIONS.resolution.default);
    this.row('resolution', this.resolution);
    const { padding: rule } = VERIFY_OPTIONS;
    const padding = this.number('padding');
    this.padding = new NumberField<number>(padding, rule, rule.default, changed, say);
    const stretch = this.number('maxStretch');
    this.stretch = new NumberField<number | 'auto'>(stretch, STRETCH, 'auto', changed, say);
    stretch.placeholder = VERIFY_RULES.maxStretch.any;
    this.resolution.addEventListener('change', () => {
      this.isChosen = true;
      changed();
    });
    this.element.append(this.switches(changed));
  }

  get options(): VerifyOptions {
    const { value } = this.stretch;
    return {
      resolution: Number(this.resolution.value),
      padding: this.padding.value,
      maxStretch: value === 'auto' ? 'none' : value,
      ...Object.fromEntries(
        [...this.allowed].map(([name, button]) => [name, button.ariaPressed === 'true']),
      ),
    };
  }

  /** Another layout is on screen, of a texture with so many texels. */
  offer(texels: number): void {
    if (!this.isChosen) this.resolution.value = String(texels);
  }

  private number(name: 'padding' | 'maxStretch'): HTMLInputElement {
    const input = create('input', 'number');
    this.row(name, input);
    return input;
  }

  private row(
    name: 'resolution' | 'padding' | 'maxStretch',
    control: HTMLInputElement | HTMLSelectElement,
  ): void {
    const { name: text, title } = VERIFY_RULES[name];
    const row = create('div', 'more-row');
    const label = create('label', '', text);
    control.id = `verify-${name}`;
    label.htmlFor = control.id;
    row.title = title;
    row.append(label, control);
    this.element.append(row);
  }

  private switches(changed: () => void): HTMLElement {
    const group = create('div', 'verify-allow');
    group.role = 'group';
    group.ariaLabel = VERIFY_RULES.allow;
    group.append(create('span', 'panel-text', VERIFY_RULES.allow));
    for (const name of ALLOWED) {
      const button = create('button', 'tool', VERIFY_RULES[name].name);
      button.type = 'button';
      button.title = VERIFY_RULES[name].title;
      button.ariaPressed = String(VERIFY_OPTIONS[name].default);
      button.addEventListener('click', () => {
        button.ariaPressed = String(button.ariaPressed !== 'true');
        changed();
      });
      this.allowed.set(name, button);
      group.append(button);
    }
    return group;
  }
}
