// The order of the functions in a module: it changes how well the module compresses, nothing else.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { createAbflatSync } from 'abflat/sync';
import { orderOfLike } from '../../wasm/function-order.mjs';
import { functionsOf, reordered } from '../../wasm/module-code.mjs';
import { TETRAHEDRON } from './support/meshes.mjs';
import { DIST } from './support/paths.mjs';

const NAMES = ['simd', 'threads', 'pack', 'bake'];
const moduleOf = (name) => readFileSync(join(DIST, `abflat-${name}.wasm`));
const compressed = (bytes) => gzipSync(bytes, { level: 9 }).length;

/** Numbers below `count` in an order that looks random. */
function shuffled(count, seed) {
  const order = [...Array(count).keys()];
  let state = seed;
  for (let i = count - 1; i > 0; --i) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const j = state % (i + 1);
    [order[i], order[j]] = [order[j], order[i]];
  }
  return order;
}

const inverse = (order) => {
  const out = new Array(order.length);
  for (const [i, f] of order.entries()) out[f] = i;
  return out;
};

for (const name of NAMES) {
  test(`${name}: every order is a module, and the way back gives the same bytes`, () => {
    const bytes = moduleOf(name);
    const count = functionsOf(bytes).bodies.length;
    assert.ok(reordered(bytes, [...Array(count).keys()]).equals(bytes));
    const order = shuffled(count, 7);
    const other = reordered(bytes, order);
    assert.ok(!other.equals(bytes));
    assert.ok(WebAssembly.validate(other));
    assert.ok(reordered(other, inverse(order)).equals(bytes));
  });
}

test('like follows like: the package compresses better than any other order', (t) => {
  for (const name of NAMES) {
    const bytes = moduleOf(name);
    const count = functionsOf(bytes).bodies.length;
    const others = [1, 2].map((seed) => compressed(reordered(bytes, shuffled(count, seed))));
    const own = compressed(bytes);
    t.diagnostic(`${name}: ${own} bytes, in other orders ${others}`);
    for (const other of others) assert.ok(own < 0.96 * other, `${name}: ${own}, not ${other}`);
  }
});

test('the order is found again from any other one nearly as well', () => {
  const bytes = moduleOf('bake');
  const other = reordered(bytes, shuffled(functionsOf(bytes).bodies.length, 3));
  assert.deepEqual(orderOfLike(other), orderOfLike(other));
  const again = reordered(other, orderOfLike(other));
  assert.ok(WebAssembly.validate(again));
  assert.ok(compressed(again) < 1.02 * compressed(bytes));
});

test('a module in another order computes the same', async () => {
  const bytes = moduleOf('simd');
  const other = reordered(bytes, shuffled(functionsOf(bytes).bodies.length, 11));
  const uvOf = async (wasmUrl) => {
    const abflat = await createAbflatSync({ wasmUrl });
    const { uv } = abflat.unwrap(TETRAHEDRON);
    abflat.terminate();
    return uv;
  };
  assert.deepEqual(await uvOf(other), await uvOf(bytes));
});

test('an instruction that is not known is named', () => {
  // (module (func)) with 0x06 ("try") in its body
  const head = [0, 97, 115, 109, 1, 0, 0, 0];
  const types = [1, 4, 1, 0x60, 0, 0];
  const body = [3, 2, 1, 0, 10, 6, 1, 4, 0, 0x06, 0x40, 0x0b];
  const bytes = Buffer.from([...head, ...types, ...body]);
  assert.throws(() => reordered(bytes, [0]), /the instruction 6, which is not known/);
});
