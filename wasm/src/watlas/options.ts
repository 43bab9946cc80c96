// The options of xatlas, and which of them mean nothing here.

import { AbflatError } from '../base/errors.js';
import { knownOptions, shown } from '../messages/validate.js';
import type { ChartOptions, PackOptions } from './types.js';

const STRETCH = 'charts are bounded by their stretch, the option maxStretch of abflat';
const SIGHT = 'seams go where they are little in sight';

/** Defaults, and why a field is ignored. */
const CHART = {
  maxChartArea: [0, STRETCH],
  maxBoundaryLength: [0, STRETCH],
  normalDeviationWeight: [2, STRETCH],
  roundnessWeight: [0.01, STRETCH],
  straightnessWeight: [6, STRETCH],
  normalSeamWeight: [4, SIGHT],
  textureSeamWeight: [0.5, SIGHT],
  maxCost: [2, STRETCH],
  maxIterations: [1, STRETCH],
  useInputMeshUvs: [false],
  fixWinding: [false], // all triangles run counter-clockwise anyway
} as const satisfies Fields<ChartOptions>;

const PACK = {
  maxChartSize: [0, 'all charts have one texel density'],
  padding: [0],
  texelsPerUnit: [0],
  resolution: [0],
  bilinear: [true],
  blockAlign: [false, 'charts are placed by texels'],
  bruteForce: [false, 'there is one way of packing'],
  rotateChartsToAxis: [true, 'charts lie level and upright'],
  rotateCharts: [true],
} as const satisfies Fields<PackOptions>;

type Fields<T> = Record<keyof T, readonly [number | boolean, string?]>;

/** All fields, and a note for each that is ignored and not at its default. */
export interface Read<T> {
  values: Required<T>;
  notes: string[];
}

export const readChartOptions = (given: ChartOptions = {}): Read<ChartOptions> =>
  read(given, CHART);

export const readPackOptions = (given: PackOptions = {}): Read<PackOptions> => read(given, PACK);

function read<T extends object>(given: T, fields: Fields<T>): Read<T> {
  const own = knownOptions(given, Object.keys(fields)) as Record<string, unknown>;
  const values: Record<string, unknown> = {};
  const notes: string[] = [];
  for (const [name, [usual, reason]] of Object.entries(fields) as [string, Field][]) {
    const value = own[name] ?? usual;
    check(name, value, usual);
    values[name] = value;
    if (reason && value !== usual) notes.push(`${name} is ignored: ${reason}.`);
  }
  return { values: values as Required<T>, notes };
}

type Field = readonly [number | boolean, string?];

function check(name: string, value: unknown, usual: number | boolean): void {
  const isRight =
    typeof usual === 'boolean'
      ? typeof value === 'boolean'
      : Number.isFinite(value) && (value as number) >= 0;
  if (isRight) return;
  const wanted = typeof usual === 'boolean' ? 'true or false' : 'a number from 0';
  throw new AbflatError('InvalidOption', `${name} must be ${wanted}, not ${shown(value)}.`);
}
