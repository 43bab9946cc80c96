// Words within numbers and lists, and how numbers are written.

const INTEGER = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

export function count(n: number): string {
  return INTEGER.format(n);
}

/** "1 triangle", "2 triangles". */
export function counted(n: number, singular: string, plural = `${singular}s`): string {
  return `${count(n)} ${n === 1 ? singular : plural}`;
}

/** The most names in a sentence. */
const NAMED = 3;

/** "a", "a and b", "a, b and c", "a, b, c and 4 more". */
export function listed(names: string[]): string {
  const shown = names.length > NAMED + 1 ? names.slice(0, NAMED) : names;
  const rest = names.length - shown.length;
  const all = rest > 0 ? [...shown, `${rest} more`] : shown;
  return all.length < 2 ? all.join('') : `${all.slice(0, -1).join(', ')} and ${all.at(-1)}`;
}

/** abflat says texcoords and charts where the page says UVs and islands. */
export function inPageWords(message: string): string {
  return message
    .replace(/\btexcoord(s?)\b(?!\.\w)/g, 'UV$1')
    .replace(/(?<![-\w./\\])a chart\b(?!-|\.\w)/g, 'an island')
    .replace(/(?<![-\w./\\])chart(s?)\b(?!-|\.\w)/g, 'island$1');
}

/** What is said of clicks and keys, for fingers: a second one cancels a stroke. */
export function inTouchWords(text: string): string {
  return text
    .replace(/\bClick\b/g, 'Tap')
    .replace(/\bclick\b/g, 'tap')
    .replace('Esc cancels', 'a second finger cancels');
}

/** In the page's words and with a capital at the beginning. */
export function sentence(text: string): string {
  const words = inPageWords(text);
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** With a full stop, unless it ends like a sentence. */
export function ended(text: string): string {
  return /[.!?\u2026]$/.test(text) ? text : `${text}.`;
}

/** Three significant digits, without an exponent if that stays short. */
export function measure(x: number): string {
  if (!Number.isFinite(x)) return 'not finite';
  if (x === 0) return '0';
  if (Math.abs(x) < 1e-4 || Math.abs(x) >= 1e6) return x.toExponential(2);
  return Number(x.toPrecision(3)) >= 100 ? count(x) : x.toPrecision(3);
}

/** Values within rounding error count as no distortion. */
export function distortion(x: number, text = measure): string {
  return text(x < 1e-12 ? 0 : x);
}

/** Two significant digits, for narrow tables. */
export function brief(x: number): string {
  if (x === 0 || !Number.isFinite(x)) return measure(x);
  if (Math.abs(x) < 9.5e-5 || Math.abs(x) >= 9.95e3) return x.toExponential(1);
  return Math.abs(x) < 99.5 ? x.toPrecision(2) : count(x);
}

export function duration(seconds: number): string {
  if (seconds < 0.0995) return `${Math.max(1, Math.round(1000 * seconds))}\u202fms`;
  return `${seconds < 9.95 ? seconds.toFixed(2) : seconds.toFixed(1)}\u202fs`;
}

/** The bound that the user asks for. */
export type Bound = number | 'auto';

/** At most three decimals: 1, 1.05, 0.968. */
export function bound(t: Bound): string {
  return t === 'auto' ? t : String(Math.round(t * 1000) / 1000);
}

/** "12 vertices have their own bound" */
export const ownBoundsText = (n: number): string =>
  n === 1 ? '1 vertex has its own bound' : `${count(n)} vertices have their own bound`;
