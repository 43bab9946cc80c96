// Checks what callers pass as options.

import type { Build } from '../base/builds.js';
import { AbflatError } from '../base/errors.js';
import {
  FLATTEN_DEFAULTS,
  FLATTEN_OPTIONS,
  type FlattenOptionValues,
  PACK_DEFAULTS,
  PACK_OPTIONS,
  type PackOptionValues,
  UNWRAP_ARRAYS,
  UNWRAP_DEFAULTS,
  UNWRAP_OPTIONS,
  type UnwrapArrays,
  type UnwrapOptionValues,
  WRITTEN_FORMATS,
} from '../base/generated.js';
import { MAX_MEMORY, MIN_MEMORY } from '../base/memory.js';
import type { PackArrays } from '../types/pack.js';
import { fieldOf, fieldsOf, ownFields } from './fields.js';
import type { KnownArrays, OwnPackArrays, PinNumbers } from './protocol.js';

const OF_CALL = ['signal', 'transfer'];
const OF_LAYOUT = ['onProgress', ...WRITTEN_FORMATS, 'roundsForGltf', ...OF_CALL];
export const OF_CREATE = ['build', 'maxMemory', 'baseUrl', 'wasmUrl', 'packUrl', 'bakeUrl'];
export const KEYS = {
  create: [...OF_CREATE, 'workerUrl', 'workers', 'queue'],
  flatten: [
    ...Object.keys(FLATTEN_OPTIONS),
    'bounds',
    'straight',
    'normalize',
    'pins',
    ...OF_LAYOUT,
  ],
  unwrap: [
    ...Object.keys(UNWRAP_OPTIONS),
    ...Object.keys(UNWRAP_ARRAYS),
    'seams',
    'keepsValidOnly',
    'keepsPlaces',
    'known',
    'pins',
    ...OF_LAYOUT,
  ],
  pack: [...Object.keys(PACK_OPTIONS), 'uv', 'islands', 'tileOfIsland', ...OF_LAYOUT],
  compare: ['onProgress', ...OF_CALL],
  call: OF_CALL,
  sample: ['detail', 'signal'],
};

const invalid = (message: string) => new AbflatError('InvalidOption', message);

/** Such as "Float32Array", "Object" or "Null"; also right for values of another window. */
export function tagOf(value: unknown): string {
  const tag = Object.prototype.toString.call(value).slice('[object '.length, -1);
  // Any object can claim to be a typed array.
  return /\wArray$/.test(tag) && !ArrayBuffer.isView(value) ? 'Object' : tag;
}

/** For messages. Objects are shown by type, since their own text cannot be trusted. */
export function shown(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value);
  if (typeof value === 'bigint') return `${value}n`;
  const isObject = (typeof value === 'object' && value !== null) || typeof value === 'function';
  return isObject ? `of the type ${tagOf(value)}` : String(value);
}

/**
 * Throws if an array has lost its memory: its buffer was transferred, or has become smaller than
 * the array.
 */
export function checkMemory(name: string, view: ArrayBufferView): void {
  try {
    (view as Uint8Array).values();
  } catch {
    throw lost(name);
  }
}

/** The same for a bare buffer. */
export function bytesIn(name: string, buffer: ArrayBuffer): Uint8Array {
  try {
    return new Uint8Array(buffer);
  } catch {
    throw lost(name);
  }
}

const lost = (name: string) =>
  new AbflatError(
    'InvalidMesh',
    `${name} has lost its memory: its buffer was transferred or resized. Pass a copy.`,
  );

/** The caller's options. Nothing else of theirs may be read as options. */
export function optionsOf<T extends object>(options: T): T {
  if (tagOf(options) !== 'Object') throw invalid('The options must be an object.');
  return ownFields(options);
}

/** The same, for options with known names. `of`: what has them, if it is not the call. */
export function knownOptions<T extends object>(options: T, known: string[], of = ''): T {
  const own = optionsOf(options);
  const unknown = Object.keys(own).find((key) => !known.includes(key));
  if (unknown === undefined) return own;
  const name = of && `${of}.`;
  throw invalid(`There is no option "${name}${unknown}". The options are ${known.join(', ')}.`);
}

export function checkSignal(signal: unknown): void {
  const isSignal =
    tagOf(signal) === 'AbortSignal' && typeof fieldOf(signal, 'addEventListener') === 'function';
  if (signal !== undefined && !isSignal) throw invalid('signal must be an AbortSignal.');
}

export function checkBoolean(name: string, value: unknown): void {
  if (value !== undefined && typeof value !== 'boolean')
    throw invalid(`${name} must be true or false.`);
}

export function checkString(name: string, value: unknown): void {
  if (typeof value !== 'string') throw invalid(`${name} must be a string.`);
}

export function checkFunction(name: string, value: unknown): void {
  if (value !== undefined && typeof value !== 'function')
    throw invalid(`${name} must be a function.`);
}

/** For functions that take abflat as an argument, to call the method `name`. */
export function checkAbflat(abflat: unknown, name: 'unwrap' | 'pack' | 'verify' | 'bake'): void {
  if (typeof fieldOf(abflat, name) !== 'function')
    throw invalid(
      'The first argument must be what createAbflat resolves to: await createAbflat().',
    );
}

/** Whether it is a compiled module, or the bytes of one. */
export function isModuleItself(value: unknown): value is WebAssembly.Module | BufferSource {
  return ['WebAssembly.Module', 'ArrayBuffer', 'Uint8Array'].includes(tagOf(value));
}

export function checkAddress(name: string, value: unknown): void {
  if (value === undefined || typeof fieldOf(value, 'href') === 'string') return;
  if (typeof value !== 'string' || value === '') throw invalid(`${name} must be a URL.`);
}

interface NumberRule {
  /** In words: "above 0". */
  readonly range: string;
  readonly above?: number;
  readonly atLeast?: number;
  readonly below?: number;
  readonly atMost?: number;
}

/** A finite number within its bounds. */
export function checkNumber(name: string, value: unknown, rule: NumberRule): void {
  const isInRange =
    typeof value === 'number' &&
    Number.isFinite(value) &&
    value > (rule.above ?? Number.NEGATIVE_INFINITY) &&
    value >= (rule.atLeast ?? Number.NEGATIVE_INFINITY) &&
    value < (rule.below ?? Number.POSITIVE_INFINITY) &&
    value <= (rule.atMost ?? Number.POSITIVE_INFINITY);
  if (isInRange) return;
  throw invalid(`${name} must be a number ${rule.range}, not ${shown(value)}.`);
}

export function checkMaxMemory(value: unknown): void {
  const range = `of bytes from ${MIN_MEMORY} (16 MB) to ${MAX_MEMORY} (4 GB)`;
  checkNumber('maxMemory', value, { range, atLeast: MIN_MEMORY, atMost: MAX_MEMORY });
}

/** `builds`: those that there are here. */
export function checkBuild(value: unknown, builds: readonly Build[]): void {
  if (value === undefined || builds.some((build) => build === value)) return;
  throw invalid(`build must be one of ${builds.join(', ')}, not ${shown(value)}.`);
}

interface OptionRule extends NumberRule {
  readonly type: string;
  readonly words?: Readonly<Record<string, number>>;
  readonly choices?: readonly string[];
}

/** The number that stands for an option's value in the module: choices by index, words by value. */
function optionNumber(name: string, value: unknown, rule: OptionRule): number {
  if (rule.type === 'boolean') {
    checkBoolean(name, value);
    return Number(value);
  }
  if (rule.choices) {
    const index = rule.choices.indexOf(value as string);
    if (index >= 0) return index;
    throw invalid(`${name} must be one of ${rule.range}, not ${shown(value)}.`);
  }
  if (rule.type === 'size' && Array.isArray(value)) return sizeNumber(name, value, rule);
  if (typeof value === 'string' && rule.words && Object.hasOwn(rule.words, value))
    return rule.words[value] as number;
  checkNumber(name, value, rule);
  if (rule.type !== 'number' && !Number.isInteger(value))
    throw invalid(`${name} must be a number ${rule.range}, not ${value}.`);
  return value as number;
}

/** One number for a width and a height: kHeightUnit of the module. */
function sizeNumber(name: string, sides: unknown[], { words: _, ...rule }: OptionRule): number {
  if (sides.length !== 2)
    throw invalid(`${name} must be a number ${rule.range}, not ${sides.length} numbers.`);
  const [width, height] = Array.from(sides, (side) =>
    optionNumber(name, side, { ...rule, type: 'integer' }),
  ) as [number, number];
  return width + 65536 * height;
}

/** All options of flattening, in the order of FLATTEN_OPTIONS. */
export function flattenNumbers(options: Partial<FlattenOptionValues>): number[] {
  return optionNumbers(options, FLATTEN_OPTIONS, FLATTEN_DEFAULTS);
}

/** All options of unwrapping, in the order of UNWRAP_OPTIONS. */
export function unwrapNumbers(options: Partial<UnwrapOptionValues>): number[] {
  return optionNumbers(options, UNWRAP_OPTIONS, UNWRAP_DEFAULTS);
}

/** All options of packing a layout, in the order of PACK_OPTIONS. */
export function packNumbers(options: Partial<PackOptionValues>): number[] {
  return optionNumbers(options, PACK_OPTIONS, PACK_DEFAULTS);
}

/** All options of a set, in its order. */
export function optionNumbers<T extends object>(
  options: Partial<T>,
  rules: Readonly<Record<keyof T, OptionRule>>,
  defaults: Readonly<T>,
): number[] {
  return Object.entries<OptionRule>(rules).map(([name, rule]) => {
    const key = name as keyof T;
    const value = options[key] === undefined ? defaults[key] : options[key];
    return optionNumber(name, value, rule);
  });
}

/**
 * Copies the arrays. The module checks the numbers in them. `needsUv`: the option that needs `uv`.
 */
export function knownArrays(known: unknown, needsUv: string | false): KnownArrays | undefined {
  if (known === undefined) {
    if (needsUv) throw invalid(`${needsUv} needs known, the result that has these charts.`);
    return undefined;
  }
  const found = fieldsOf(known, OF_KNOWN);
  const options = fieldsOf(fieldOf(found.report, 'options'), ['t', 'balance', 'straightSeams']);
  const check = <T extends ArrayBufferView>(name: keyof typeof found, tag: string): T => {
    if (tagOf(found[name]) !== tag)
      throw invalid(`known must be a result of unwrap; its ${name} is not a ${tag}.`);
    checkMemory(`known.${name}`, found[name] as ArrayBufferView);
    return found[name] as T;
  };
  const reals = (name: keyof typeof found) =>
    new Float64Array(check<Float64Array>(name, 'Float64Array'));
  const whole = (name: keyof typeof found) =>
    new Uint32Array(check<Uint32Array>(name, 'Uint32Array'));
  const number = (name: 't' | 'balance') =>
    optionNumber(`known.report.options.${name}`, options[name], UNWRAP_OPTIONS[name]);
  return {
    arrays: {
      unpacked: reals('unpacked'),
      indices: whole('indices'),
      vertexMap: whole('vertexMap'),
      chartOfTriangle: whole('chartOfTriangle'),
      ...(needsUv && { uv: reals('uv') }),
    },
    t: number('t'),
    balance: number('balance'),
    straightSeams: options.straightSeams === true,
  };
}

const OF_KNOWN = ['uv', 'unpacked', 'indices', 'vertexMap', 'chartOfTriangle', 'report'] as const;

/**
 * Copies of the arrays among options, so that the caller's buffers stay, in the order of
 * UNWRAP_ARRAYS. The module checks the numbers.
 */
export function arraysOf(options: UnwrapArrays): (Uint32Array | Float64Array | undefined)[] {
  const names = Object.keys(UNWRAP_ARRAYS) as (keyof UnwrapArrays)[];
  return names.map((name) => copyOf(name, UNWRAP_ARRAYS[name], options[name]));
}

const PACK_ARRAYS: Record<keyof PackArrays, ArrayInfo> = {
  uv: { type: 'number', multiple: 2 },
  islands: { type: 'index', of: 'island numbers', multiple: 1 },
  tileOfIsland: { type: 'index', of: 'tile numbers', multiple: 1 },
};

/** The same for those of pack. */
export function packArrays(options: PackArrays): OwnPackArrays {
  const copy = (name: keyof PackArrays) => copyOf(name, PACK_ARRAYS[name], options[name]);
  return {
    uv: copy('uv') as Float64Array | undefined,
    islands: copy('islands') as Uint32Array | undefined,
    tileOfIsland: copy('tileOfIsland') as Uint32Array | undefined,
  };
}

/** A copy of coordinates for the corners of triangles, for verify. */
export const triangleUv = (given: unknown) =>
  copyOf('uv', PACK_ARRAYS.uv, given) as Float64Array | undefined;

interface ArrayInfo {
  readonly type: 'index' | 'number';
  readonly of?: string;
  readonly multiple: number;
  readonly word?: string;
}

function copyOf(
  name: string,
  info: ArrayInfo,
  given: unknown,
): Uint32Array | Float64Array | undefined {
  if (given === undefined || (info.word !== undefined && given === info.word)) return undefined;
  const tag = tagOf(given);
  const isIndex = info.type === 'index';
  if (info.word !== undefined && tag === 'String')
    throw invalid(`${name} must be '${info.word}' or a Uint32Array.`);
  const kinds = isIndex ? ['Uint32Array'] : ['Float32Array', 'Float64Array'];
  if (!kinds.includes(tag)) {
    const of = info.of ? ` of ${info.of}` : '';
    throw invalid(`${name} must be a ${kinds.join(' or ')}${of}, not ${tag}.`);
  }
  checkMemory(name, given as ArrayBufferView);
  const copy = isIndex
    ? new Uint32Array(given as Uint32Array)
    : new Float64Array(given as Float64Array);
  if (copy.length % info.multiple !== 0)
    throw invalid(`${name} has ${copy.length} elements, not a multiple of ${info.multiple}.`);
  return copy;
}

function checkIndex(name: string, kind: string, value: unknown): void {
  if (!Number.isInteger(value) || (value as number) < 0 || (value as number) >= 2 ** 32)
    throw invalid(`${name} must be a ${kind} number.`);
}

function checkArray(name: string, value: unknown, of: string): void {
  if (!Array.isArray(value)) throw invalid(`${name} must be an array of ${of}.`);
}

/** Unlike map, this also visits the holes of an array. */
const each = <T, R>(values: T[], see: (value: T | undefined, i: number) => R): R[] =>
  Array.from(values, see);

export function boundNumbers(bounds: unknown = []): number[] {
  checkArray('bounds', bounds, '{ vertex, t }');
  return each(bounds as unknown[], (bound, i) => {
    const { vertex, t } = fieldsOf(bound, ['vertex', 't']);
    checkIndex(`bounds[${i}].vertex`, 'vertex', vertex);
    checkNumber(`bounds[${i}].t`, t, { range: 'above 0', above: 0 });
    return [vertex as number, t as number];
  }).flat();
}

export function straightNumbers(runs: unknown = []): [number, number][] {
  checkArray('straight', runs, '{ from, to }');
  return each(runs as unknown[], (run, i) => {
    const { from, to } = fieldsOf(run, ['from', 'to']);
    checkIndex(`straight[${i}].from`, 'vertex', from);
    checkIndex(`straight[${i}].to`, 'vertex', to);
    return [from as number, to as number];
  });
}

export function pinnedVertices(pins: unknown): number[] {
  checkArray('pins', pins, 'vertex numbers');
  return each(pins as unknown[], (pin, i) => {
    checkIndex(`pins[${i}]`, 'vertex', pin);
    return pin as number;
  });
}

/** The face of a pin without one: kAnyFace of the module. */
const ANY_FACE = 2 ** 32 - 1;

export function pinNumbers(pins: unknown = []): PinNumbers[] {
  checkArray('pins', pins, '{ vertex, uv: [u, v] }');
  return each(pins as unknown[], (pin, i) => {
    const { vertex, uv, face = ANY_FACE } = fieldsOf(pin, ['vertex', 'uv', 'face']);
    checkIndex(`pins[${i}].vertex`, 'vertex', vertex);
    checkArray(`pins[${i}].uv`, uv, 'two numbers');
    const { length, 0: u, 1: v } = uv as unknown[];
    if (length !== 2) throw invalid(`pins[${i}].uv must be an array of two numbers.`);
    const place = [u, v];
    for (const [k, x] of place.entries())
      checkNumber(`pins[${i}].uv[${k}]`, x, { range: 'that is finite' });
    checkIndex(`pins[${i}].face`, 'face', face);
    return [vertex, ...place, face] as PinNumbers;
  });
}
