import { measure } from '../words/format';

/** Where values lie on an axis, 0..1, and which of them have ticks. */
export interface Scale {
  /** Not finite if the value cannot be shown. */
  at(value: number): number;
  ticks: { value: number; text: string }[];
}

/** An axis from 0 to at least `most`, with at most about `count` steps. */
export function linearScale(most: number, count: number): Scale {
  const step = niceStep((most > 0 ? most : 1) / count);
  const steps = Math.max(1, Math.ceil(most / step - 1e-9));
  const values = Array.from({ length: steps + 1 }, (_, i) => i * step);
  return {
    at: (value) => value / (steps * step),
    ticks: values.map((value) => ({ value, text: value === 0 ? '0' : short(value) })),
  };
}

/** An axis with these ends and ticks. */
export function fixedScale(low: number, high: number, ticks: Scale['ticks']): Scale {
  return { at: (value) => (value - low) / (high - low || 1), ticks };
}

/**
 * An axis of whole powers of ten around all positive values; values of 0 and below lie at its lower
 * end.
 */
export function logScale(values: number[], count: number): Scale {
  const logs = values.filter((value) => value > 0 && value < Infinity).map(Math.log10);
  const low = logs.length > 0 ? Math.floor(Math.min(...logs)) : -1;
  const high = logs.length > 0 ? Math.max(low + 1, Math.ceil(Math.max(...logs))) : 0;
  const stride = Math.ceil((high - low) / count);
  const ticks: Scale['ticks'] = [];
  for (let n = high; n >= low; n -= stride) ticks.unshift({ value: 10 ** n, text: power(n) });
  return {
    at: (value) => (value > 0 ? (Math.log10(value) - low) / (high - low) : value <= 0 ? 0 : NaN),
    ticks,
  };
}

/** 1, 2 or 5 times a power of ten, at least `step`. */
function niceStep(step: number): number {
  const power = 10 ** Math.floor(Math.log10(step));
  const factor = [1, 2, 5, 10].find((each) => each * power >= step * (1 - 1e-9)) ?? 10;
  return factor * power;
}

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** 10⁻³ */
export function power(n: number): string {
  const digits = [...String(Math.abs(n))].map((digit) => SUPERSCRIPTS[Number(digit)]);
  return `10${n < 0 ? '⁻' : ''}${digits.join('')}`;
}

/** Without trailing zeros: 0.5, not 0.500. */
function short(value: number): string {
  const text = measure(value);
  return text.includes('e') || !text.includes('.') ? text : String(Number(text));
}
