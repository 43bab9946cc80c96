// Settings as text, in the words of the command line: "unwrap&max-stretch=1.05&seams=auto,sharp=60". Only what
// differs from the defaults is named.

import {
  FLATTEN_DEFAULTS,
  FLATTEN_OPTIONS,
  PACK_DEFAULTS,
  PACK_OPTIONS,
  UNWRAP_DEFAULTS,
  UNWRAP_OPTIONS,
} from 'abflat';
import { STRETCHES } from '../controls/atlas-control';
import { BALANCE_STEP } from '../controls/balance-control';
import { BOUND_RULE } from '../controls/bound-control';
import { fits, type NumberRule } from '../controls/number-field';
import { MORE } from '../model/more-names';
import { defaultOptions, PART_TILES } from '../model/more-options';
import {
  type Mode,
  packSettings,
  RESOLUTIONS,
  type Settings,
  TILES,
  usualPackChoices,
} from '../model/settings';
import { choiceOf, seamWords } from '../seams/seam-choice';

type Values = Record<string, unknown>;
interface Rule extends NumberRule {
  readonly choices?: readonly string[];
}

const RULES: Record<Mode, Readonly<Record<string, Rule>>> = {
  flatten: FLATTEN_OPTIONS,
  unwrap: { ...UNWRAP_OPTIONS, tiles: { type: 'choice', choices: PART_TILES } },
  pack: { ...PACK_OPTIONS, tiles: { type: 'choice', choices: TILES } },
};

const MODES: readonly Mode[] = ['flatten', 'unwrap', 'pack'];

/** The options that the page has of each kind of layout, in the order of the text. */
const NAMES: Record<Mode, readonly string[]> = {
  flatten: ['t', 'balance', 'delaunay'],
  unwrap: ['maxStretch', 'balance', 'resolution', 'padding', ...MORE, 'tiles'],
  pack: ['keepPlaces', 'resolution', 'padding', 'margin', 'rotate', 'islandSizes', 'tiles'],
};

/** What the controls of the page can show is less than abflat takes. */
const isOnStep = (value: number) => Number.isInteger(Number((value / BALANCE_STEP).toFixed(9)));
const SHOWN: Record<string, (value: unknown, mode: Mode) => boolean> = {
  maxStretch: (value) => STRETCHES.includes(value as number),
  resolution: (value) => RESOLUTIONS.includes(value as number),
  balance: (value) => isOnStep(value as number),
  t: (value, mode) => mode === 'unwrap' || value === 'auto' || fits(value as number, BOUND_RULE),
};

export function usualSettings(mode: Mode): Settings {
  if (mode === 'flatten') {
    const { t, balance, delaunay } = FLATTEN_DEFAULTS;
    return { mode, t, balance, delaunay };
  }
  if (mode === 'pack') return packSettings(false, PACK_DEFAULTS.resolution, usualPackChoices());
  const { maxStretch, balance, resolution, padding } = UNWRAP_DEFAULTS;
  return { mode, maxStretch, balance, resolution, padding, ...defaultOptions(), seams: 'auto' };
}

/** "max-stretch" */
const flagOf = (name: string) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

function wordOf(name: string, value: unknown): string {
  if (typeof value === 'boolean') return value ? flagOf(name) : `no-${flagOf(name)}`;
  return `${flagOf(name)}=${value}`;
}

/** '' for those of a first visit. Seams that were edited, locks and moved charts are not in it. */
export function textOf(settings: Settings): string {
  const { mode } = settings;
  const values: Values = { ...settings };
  const usual: Values = { ...usualSettings(mode) };
  const words = NAMES[mode]
    // How islands are packed is not there while they stay where they are.
    .filter((name) => name in values && values[name] !== usual[name])
    .map((name) => wordOf(name, values[name]));
  if (mode === 'unwrap') {
    if (settings.seams !== 'auto' && !settings.seamEdges) words.push(`seams=${settings.seams}`);
    if (settings.fixedFaces) words.push('keep=uv');
  }
  return words.length > 0 || mode !== 'unwrap' ? [mode, ...words].join('&') : '';
}

export interface SettingsRead {
  settings: Settings;
  /** The words that mean nothing here. */
  ignored: string[];
}

/** Any text is settings: what is not there has its default. */
export function settingsOf(text: string): SettingsRead {
  const words = text.split('&').filter(Boolean).map(decoded);
  const mode = MODES.find((mode) => words.includes(mode)) ?? 'unwrap';
  const values: Values = {};
  const ignored: string[] = [];
  for (const word of words) {
    const read = word === mode ? {} : optionOf(word, mode);
    if (read) Object.assign(values, read);
    else ignored.push(word);
  }
  return { settings: withoutIdle({ ...usualSettings(mode), ...values } as Settings), ignored };
}

/** Without what does not matter while the UVs of the file stay as they are. */
function withoutIdle(settings: Settings): Settings {
  if (settings.mode !== 'pack') return settings;
  const { mode, keepPlaces, resolution, uv, ...choices } = settings;
  return packSettings(keepPlaces, resolution, { ...usualPackChoices(), ...choices });
}

/** The option that a word sets; null if there is none, or not with this value. */
function optionOf(word: string, mode: Mode): Values | null {
  const [, flag, text] = /^([^=]*)=?(.*)$/s.exec(word) as RegExpExecArray;
  if (mode === 'unwrap' && flag === 'seams') return areSeams(text) ? { seams: text } : null;
  if (mode === 'unwrap' && word === 'keep=uv') return { fixedFaces: 'uv' };
  const name = NAMES[mode].find((name) => [flagOf(name), `no-${flagOf(name)}`].includes(flag));
  if (!name) return null;
  const rule = RULES[mode][name];
  if (rule.type === 'boolean') return word === flag ? { [name]: !flag.startsWith('no-') } : null;
  if (flag !== flagOf(name)) return null;
  const value = rule.choices || Object.hasOwn(rule.words ?? {}, text) ? text : numberOf(text);
  const isKnown = typeof value === 'number' ? fits(value, rule) : isWord(value, rule);
  return isKnown && (SHOWN[name]?.(value, mode) ?? true) ? { [name]: value } : null;
}

const isWord = (text: string, { choices, words = {} }: Rule) =>
  choices ? choices.includes(text) : Object.hasOwn(words, text);

const numberOf = (text: string) => (text.trim() === '' ? Number.NaN : Number(text));

function areSeams(text: string): boolean {
  const { sources } = choiceOf({ seams: text });
  const { sharp } = sources;
  return seamWords(sources) === text && (sharp === null || (sharp > 0 && sharp <= 180));
}

function decoded(word: string): string {
  try {
    return decodeURIComponent(word);
  } catch {
    return word;
  }
}
