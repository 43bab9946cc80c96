// An order of a module's functions in which like follows like, so that the module compresses better:
// deflate finds only what repeats within 32 KB.

import { callsOf, functionsOf } from './module-code.mjs';

/** Bytes that count as one feature of a function: four find less, ten as well. */
const RUN = 6;
/** A feature of more functions than this says nothing of any of them. */
const MOST_SHARED = 80;
/** How far back deflate looks, less what is behind the match. */
const WINDOW = 30_000;
/** What a function costs besides its bytes: small ones do not all come first. */
const OVERHEAD = 40;
/** Numbers below this take one byte. */
const SHORT = 128;

/** For each function its features: numbers, each of which at least two functions have. */
function featuresOf(bodies) {
  const owners = new Map();
  for (const [f, body] of bodies.entries()) {
    for (let i = 0; i + RUN <= body.length; ++i) {
      // A run of six bytes as a number, exactly.
      const run = body.readUIntBE(i, RUN);
      const known = owners.get(run);
      if (!known) owners.set(run, [f]);
      else if (known.at(-1) !== f) known.push(f);
    }
  }
  const shared = [...owners.values()].filter(({ length }) => length >= 2 && length <= MOST_SHARED);
  const features = bodies.map(() => []);
  for (const [feature, functions] of shared.entries())
    for (const f of functions) features[f].push(feature);
  return { shared, features };
}

/** Functions called most, as many as have numbers of one byte; they stay in front. */
function mostCalled(bytes, imported, count) {
  const calls = callsOf(bytes).subarray(imported);
  return Array.from({ length: count }, (_, f) => f)
    .sort((a, b) => calls[b] - calls[a] || a - b)
    .slice(0, Math.max(0, SHORT - imported));
}

/** Each time the function that shares most, for its size, with what deflate still sees. */
export function orderOfLike(bytes) {
  const { bodies, imported } = functionsOf(bytes);
  const { shared, features } = featuresOf(bodies);
  const seen = new Uint32Array(shared.length);
  const score = new Int32Array(bodies.length);
  const left = new Set(bodies.keys());
  const window = [];
  let inWindow = 0;
  let oldest = 0;
  const order = [];
  const count = (f, step) => {
    for (const feature of features[f]) {
      const before = seen[feature];
      seen[feature] += step;
      if (before === 0 || seen[feature] === 0) for (const g of shared[feature]) score[g] += step;
    }
  };
  const take = (f) => {
    left.delete(f);
    order.push(f);
    window.push(f);
    inWindow += bodies[f].length;
    count(f, 1);
    for (; inWindow > WINDOW; ++oldest) {
      inWindow -= bodies[window[oldest]].length;
      count(window[oldest], -1);
    }
  };
  for (const f of mostCalled(bytes, imported, bodies.length)) take(f);
  while (left.size > 0) {
    let best = -1;
    let most = -1;
    for (const f of left) {
      const share = score[f] / (bodies[f].length + OVERHEAD);
      if (share > most) {
        most = share;
        best = f;
      }
    }
    take(best);
  }
  return order;
}
