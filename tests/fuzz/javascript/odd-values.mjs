// Values that callers pass by mistake.

/** Thrown by the callers' own values; it reaches them unchanged. */
export class CallersError extends Error {}

const fail = () => {
  throw new CallersError('of the caller');
};

function cyclic() {
  const value = { name: 'cyclic' };
  value.self = value;
  return value;
}

/** Its memory has already been transferred away. */
export function detached(array) {
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
}

/** Reaches beyond the end of its buffer. */
export function cutOff(Kind) {
  const buffer = new ArrayBuffer(96, { maxByteLength: 96 });
  const array = new Kind(buffer, 24, 3);
  buffer.resize?.(24);
  return array;
}

/** Claims to be of a type that it is not. */
const impostor = (tag) => ({ [Symbol.toStringTag]: tag, length: 9, byteLength: 72 });

const KINDS_TO_BE = [
  'Float64Array',
  'Uint32Array',
  'Uint8Array',
  'ArrayBuffer',
  'AbortSignal',
  'Array',
  'Object',
];

/** As functions, for most can be changed by whoever gets them. */
const ODD_VALUES = [
  ...[null, true, false, Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY],
  ...[-0, 0, 1, -1, 0.5, 3, 1e-320, 1e308, 2 ** 31, 2 ** 32 - 1, 2 ** 32, 2 ** 53, 5n],
  ...['', '1', 'auto', 'none', 'uv', 'NaN', 'constructor', '__proto__', '\0', '\ud800', 'é😀'],
]
  .map((value) => () => value)
  .concat([
    () => 'x'.repeat(2000),
    () => Symbol('odd'),
    () => () => 1,
    () => ({}),
    () => Object.create(null),
    () => cyclic(),
    () => [],
    () => [cyclic()],
    () => [5n],
    () => [null],
    () => Object.assign(new Array(2), { 1: 1 }),
    () => new Array(7),
    () => new Map([[1, 2]]),
    () => new Date(Number.NaN),
    () => Object('auto'),
    () => Object(1),
    () => ({ valueOf: fail }),
    () => ({ toString: fail }),
    () => ({ toJSON: fail }),
    () => new Proxy({}, { get: fail, has: fail, ownKeys: fail, getPrototypeOf: fail }),
    () => new Float64Array(2),
    () => new Uint32Array([0, 1, 2, 3]),
    () => detached(new Uint32Array(4)),
    () => detached(new Float64Array(6)),
    () => detached(new Uint8Array(6)),
    () => detached(new Uint8Array(6)).buffer,
    () => cutOff(Float64Array),
    () => cutOff(Uint32Array),
    () => new Uint32Array(new SharedArrayBuffer(16)),
    () => new BigUint64Array(2),
    () => new DataView(new ArrayBuffer(8)),
    () => Promise.resolve(1),
    () => new Error('odd'),
    () => new AbortController(),
    () => AbortSignal.abort(),
    ...KINDS_TO_BE.map((tag) => () => impostor(tag)),
  ]);

export const oddValue = (random) => random.pick(ODD_VALUES)();

export function isPlain(value) {
  try {
    return Object.getPrototypeOf(Object(value)) === Object.prototype;
  } catch {
    return false; // a proxy that throws
  }
}

/** A plain copy without getters. */
export function plainly(mesh) {
  try {
    return { ...mesh };
  } catch {
    return {};
  }
}
