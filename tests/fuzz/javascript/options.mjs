// Random options for every call: those of the schema, and those that only the package takes.

import { FLATTEN_OPTIONS, PACK_OPTIONS, UNWRAP_OPTIONS } from 'abflat';
import { CallersError, oddValue } from './odd-values.mjs';

/** Within the bounds, at them, or just outside. */
function valueWithin(random, name, { type, choices, words, ...bounds }) {
  if (random.chance(0.1)) return oddValue(random);
  if (type === 'boolean') return random.chance(0.5);
  if (choices) return random.pick(choices);
  if (words && random.chance(0.3)) return Object.keys(words)[0];
  if (name === 'resolution')
    return random.pick([
      ...[15, 16, 17, 64, 512, 2048, 32768, 32769, 64.5],
      ...[[64, 300], [512, 64], [64, 15], [64], [64, 64, 64], ['64', 64]],
    ]);
  if (name === 'padding') return random.pick([-1, 0, 1, 7, 256, 257]);
  const low = bounds.above ?? bounds.atLeast ?? 0;
  const steps = [-1, 0, 1e-320, 1e-9, 0.01, 0.3, 1, 2, 50, 1e6, 1e300, Number.MAX_VALUE];
  return low + random.pick(steps);
}

const listOf = (random, make) => Array.from({ length: random.below(4) }, () => make(random));

/** Mostly a vertex or a face of a small mesh. */
const number = (random) => (random.chance(0.95) ? random.below(20) : oddValue(random));

function pin(random) {
  const uv = [random.next(), random.next()];
  if (random.chance(0.05)) uv[random.below(3)] = oddValue(random);
  return { vertex: number(random), uv, ...(random.chance(0.3) && { face: number(random) }) };
}

const numbers = (random) =>
  Uint32Array.from({ length: random.below(5) }, () =>
    random.chance(0.95) ? random.below(20) : 2 ** 32 - 1,
  );

const SEAMS = [
  'auto',
  'none',
  'hard',
  'uv',
  'material',
  'sharp=60',
  'auto,hard,sharp=30',
  'sharp=0',
  'sharp=',
];
const OTHER_SEAMS = [
  'auto,',
  'nothing',
  'sharp=1e999',
  'file=seams.txt',
  ' auto , uv',
  'sharp=nan',
];

const fail = () => {
  throw new CallersError('of the caller');
};
const LISTENERS = [
  fail,
  async () => fail(),
  () => new Promise((resolve) => setTimeout(resolve, 1)).then(fail),
];

const onProgress = (random) => (random.chance(0.8) ? () => undefined : random.pick(LISTENERS));

const boolean = (random) => random.chance(0.5);

const pins = (random) => listOf(random, pin);

const OF_LAYOUT = {
  obj: boolean,
  ply: boolean,
  roundsForGltf: boolean,
  onProgress,
};

/** The options that only the package has, by method. */
const OF_PACKAGE = {
  flatten: {
    pins,
    ...OF_LAYOUT,
    bounds: (random) =>
      listOf(random, () => ({ vertex: number(random), t: random.between(-0.1, 2.2) })),
    straight: (random) => listOf(random, () => ({ from: number(random), to: number(random) })),
    normalize: boolean,
  },
  unwrap: {
    pins,
    ...OF_LAYOUT,
    seams: (random) => random.pick(random.chance(0.8) ? SEAMS : OTHER_SEAMS),
    seamEdges: numbers,
    fixedFaces: (random) => (random.chance(0.4) ? 'uv' : numbers(random)),
    keepsValidOnly: boolean,
    fixedCharts: numbers,
    keepsPlaces: boolean,
  },
  pack: OF_LAYOUT,
  compare: { onProgress },
  inspect: {},
  load: {},
  bake: {
    kind: (random) => random.pick(['colour', 'data', 'normal']),
    bakeResolution: (random) => random.pick([16, 16, 32, 15, 20000, [16, 32], [16, 15]]),
    padding: (random) => random.pick([0, 2, 256, 257]),
    layoutResolution: (random) => random.pick(['none', 1, 64, 0, [64, 128]]),
    onProgress,
  },
  sample: { detail: (random) => random.pick([1, 1, 2.5, 0, -1, Number.NaN, 1e300, 5n]) },
};

const SCHEMA = { flatten: FLATTEN_OPTIONS, unwrap: UNWRAP_OPTIONS, pack: PACK_OPTIONS };

/** A signal that is never aborted, is already aborted, or will be shortly. */
function signalOf(random) {
  const controller = new AbortController();
  const kind = random.below(4);
  const reason = random.chance(0.5) ? new CallersError('of the caller') : undefined;
  if (kind === 0) controller.abort(reason);
  if (kind === 1) queueMicrotask(() => controller.abort(reason));
  if (kind === 2) setTimeout(() => controller.abort(reason), random.below(10));
  return controller.signal;
}

/**
 * All options except those in `without`, each with some probability; leaving one out changes
 * nothing else.
 */
export function randomOptions(random, method, without = []) {
  if (random.chance(0.03)) return oddValue(random);
  const options = {};
  const add = (name, make, share = 0.15) => {
    if (!random.chance(share)) return;
    options[name] = random.chance(0.06) ? oddValue(random) : make();
  };
  for (const [name, rule] of Object.entries(SCHEMA[method] ?? {}))
    add(name, () => valueWithin(random, name, rule));
  for (const [name, make] of Object.entries(OF_PACKAGE[method])) add(name, () => make(random));
  if (!['sample', 'bake'].includes(method)) add('transfer', () => boolean(random), 0.1);
  add('signal', () => signalOf(random), 0.1);
  add(random.pick(['T', 'padding', 'constructor', '', 'é']), () => oddValue(random), 0.02);
  for (const name of without) delete options[name];
  return options;
}
