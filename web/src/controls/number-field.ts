import { NUMBERS } from '../words/controls';

/** The values that an option of abflat allows. */
export interface NumberRule {
  readonly type: string;
  readonly above?: number;
  readonly atLeast?: number;
  readonly atMost?: number;
  readonly words?: Readonly<Record<string, number>>;
}

/**
 * A field for a number within its bounds. If the option has the word `auto`, an empty field stands
 * for it.
 */
export class NumberField<T extends number | 'auto'> {
  constructor(
    private readonly input: HTMLInputElement,
    private readonly rule: NumberRule,
    public value: T,
    private readonly changed: (value: T) => void,
    say: (text: string) => void,
  ) {
    input.type = 'number';
    input.step = rule.type === 'integer' ? '1' : 'any';
    input.inputMode = rule.type === 'integer' ? 'numeric' : 'decimal';
    if (rule.atLeast !== undefined) input.min = String(rule.atLeast);
    if (rule.atMost !== undefined) input.max = String(rule.atMost);
    if (this.takesAuto) input.placeholder = NUMBERS.auto;
    this.show();
    input.addEventListener('input', () => this.read());
    input.addEventListener('change', () => {
      if (input.ariaInvalid === 'true') say(this.refusal);
      this.show();
    });
  }

  /** Shows another value without asking for it. */
  restore(value: T): void {
    this.value = value;
    this.show();
  }

  private get takesAuto(): boolean {
    return this.rule.words?.auto !== undefined;
  }

  private get refusal(): string {
    const name = this.input.labels?.[0]?.textContent ?? NUMBERS.unnamed;
    return refusal(name, this.input.value, NUMBERS.range(this.rule), String(this.value));
  }

  private show(): void {
    this.input.value = this.value === 'auto' ? '' : String(this.value);
    this.input.setAttribute('aria-invalid', 'false');
  }

  private read(): void {
    const isEmpty = this.input.value === '' && !this.input.validity.badInput;
    const value = isEmpty && this.takesAuto ? 'auto' : this.input.valueAsNumber;
    const isUsable = value === 'auto' || fits(value, this.rule);
    this.input.setAttribute('aria-invalid', String(!isUsable));
    if (!isUsable || value === this.value) return;
    this.value = value as T;
    this.changed(this.value);
  }
}

export function fits(value: number, rule: NumberRule): boolean {
  const { above = -Infinity, atLeast = -Infinity, atMost = Infinity } = rule;
  return (
    Number.isFinite(value) &&
    value > above &&
    value >= atLeast &&
    value <= atMost &&
    (rule.type !== 'integer' || Number.isInteger(value))
  );
}

/** Why the typed value was not taken. */
export const refusal = NUMBERS.refused;
