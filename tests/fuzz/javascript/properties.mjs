// Properties that must hold for every call, whatever its arguments.

import assert from 'node:assert/strict';
import { types } from 'node:util';
import { AbflatError, createAbflat, STATUS_NAMES } from 'abflat';
import { judge } from '../../support/exact-atlas.mjs';
import { outlineOf } from '../../support/stacks.mjs';
import { grid } from '../../wasm/support/meshes.mjs';
import { CallersError } from './odd-values.mjs';

/** A call that takes longer is assumed never to end. */
const SECONDS = 60;
/** Small, so that leaks soon exhaust it. */
const MEMORY = 128 * 2 ** 20;
/** Engines use such messages for their own errors. */
const OF_ENGINE =
  /is not (a|an) (function|object|iterable|constructor)|Cannot (read|convert|mix|destructure|perform)|\[object |unreachable|RuntimeError|TypeError|RangeError|(has|of|are|is) undefined\b|\bNaN (elements|vertices)/;
/** File names are repeated as they are, so messages may be long. */
const MOST_LETTERS = 6000;

export const start = () => createAbflat({ maxMemory: MEMORY });

const KNOWN = grid(3);

/** The bytes that a call which must always work returns. */
export async function knownBytes(abflat) {
  const { uv, indices } = await abflat.unwrap(KNOWN, { padding: 4 });
  return Buffer.concat([new Uint8Array(uv.buffer), new Uint8Array(indices.buffer)]).toString(
    'base64',
  );
}

/** Also works for an array whose memory is gone. */
const elements = (array) => Array.from({ length: array.length }, (_, i) => array[i]);

/** All arrays inside a value, with their current contents. */
function arraysIn(value, found = new Map(), depth = 0) {
  if (ArrayBuffer.isView(value) && !(value instanceof DataView)) found.set(value, elements(value));
  if (depth > 3 || value === null || typeof value !== 'object' || ArrayBuffer.isView(value))
    return found;
  for (const { value: child } of Object.values(descriptorsOf(value)))
    arraysIn(child, found, depth + 1);
  return found;
}

/** Without triggering the caller's getters and proxies. */
export function descriptorsOf(value) {
  try {
    return Object.getOwnPropertyDescriptors(Object(value));
  } catch {
    return {};
  }
}

function assertRefusal(error, { args }) {
  const signal = descriptorsOf(args[1]).signal?.value;
  const isAborted =
    !types.isProxy(signal) &&
    signal instanceof AbortSignal &&
    signal.aborted &&
    error === signal.reason;
  if (error instanceof CallersError || isAborted) return;
  assert.ok(error instanceof AbflatError, `rejected with ${error?.stack ?? String(error)}`);
  const { code, message } = error;
  assert.ok(STATUS_NAMES.includes(code) && code !== 'Ok', `code ${code}`);
  assert.notEqual(code, 'Internal', message);
  assert.notEqual(code, 'OutOfMemory', message);
  const isSentence = /\S\s+\S/.test(message) && message.length < MOST_LETTERS;
  assert.ok(isSentence && !/[\n\r]/.test(message) && !OF_ENGINE.test(message), message);
}

/**
 * Too small relative to the mesh, or too thin, to have area in an atlas: as in targets/layouts.cpp.
 */
function mayBeFlat(corners, extent) {
  const places = corners.map(({ place }) => place.map((x) => x / extent));
  const edges = places.map((p, k) => places[(k + 1) % 3].map((x, d) => x - p[d]));
  const lengths = edges.map((edge) => Math.hypot(...edge));
  const [a, b] = edges;
  const area = Math.hypot(
    ...[0, 1, 2].map((d) => a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3]),
  );
  return !(Math.min(...lengths) > 1e-6 && area > 1e-6 * Math.max(...lengths) ** 2);
}

/** Islands lie in tiles if the report says valid; vertices are those of the input, then copies. */
function assertPacked({ uv, indices, vertexMap, islandOfTriangle, report }) {
  const isBelow = (count) => (v) => v < count;
  assert.equal(uv.length, 2 * vertexMap.length);
  assert.ok(indices.every(isBelow(vertexMap.length)));
  assert.equal(3 * islandOfTriangle.length, indices.length);
  const first = vertexMap.findIndex((v, i) => v !== i);
  assert.ok(first < 0 || vertexMap.subarray(first).every(isBelow(first)), 'copies come last');
  if (!report.valid) return;
  const isIn = (v) =>
    uv[2 * v] >= 0 && uv[2 * v] <= 10 && uv[2 * v + 1] >= 0 && uv[2 * v + 1] <= report.tiles;
  for (const [i, island] of islandOfTriangle.entries())
    if (island < report.islands)
      assert.ok(indices.subarray(3 * i, 3 * i + 3).every(isIn), `triangle ${i} is in no tile`);
}

/** Asserts that, if a report says valid, no triangles are flipped or overlap. */
function assertValid(result, { method, args }) {
  if (method === 'pack') assertPacked(result);
  if (method !== 'unwrap' && method !== 'flatten') return;
  const { uv, indices, vertexMap, report } = result;
  assert.equal(uv.length, 2 * vertexMap.length);
  assert.ok(indices.every((v) => v < vertexMap.length));
  for (const { valid, problem } of report.charts) assert.equal(valid, problem === '', problem);
  if (!report.valid) return;
  // The positions of a file are in the result, one row per vertex of it.
  const { positions } = result;
  const placeOf = (v, d) =>
    positions ? positions[3 * v + d] : args[0].positions[3 * vertexMap[v] + d];
  const corner = (v) => ({
    uv: [uv[2 * v], uv[2 * v + 1]],
    place: [0, 1, 2].map((d) => Number(placeOf(v, d))),
  });
  const triangles = Array.from({ length: indices.length / 3 }, (_, i) =>
    [...indices.subarray(3 * i, 3 * i + 3)].map(corner),
  );
  const extent = Math.max(...triangles.flat().flatMap(({ place }) => place.map(Math.abs)));
  const judged = (some) =>
    judge(
      some.map((corners) => corners.map((c) => c.uv)),
      { mayBeFlat: (i) => mayBeFlat(some[i], extent), tiles: [10, 1000] },
    );
  const chartOf = (i) => report.charts[result.chartOfTriangle?.[i]];
  const found = judged(triangles.filter((_, i) => !(chartOf(i)?.stackedOn >= 0)));
  for (const [c, { stackedOn, mirrored }] of report.charts.entries()) {
    if (!(stackedOn >= 0)) continue;
    const [own, below] = [c, stackedOn].map((chart) =>
      triangles.filter(
        (corners, i) =>
          result.chartOfTriangle[i] === chart && new Set(corners.map((c) => `${c.uv}`)).size === 3,
      ),
    );
    assert.equal(outlineOf(own), outlineOf(below), `chart ${c} has another outline`);
    const turned = mirrored ? own.map((corners) => [...corners].reverse()) : own;
    assert.ok(judged(turned).isValid, `valid, but stacked chart ${c} is not`);
  }
  if (method === 'flatten' || args[1]?.pins?.length > 0) found.outside = [];
  for (const flaw of ['flipped', 'flat', 'overlaps', 'outside'])
    assert.deepEqual(found[flaw], [], `valid, but ${flaw}`);
}

async function settled(call, abflat) {
  let timer;
  const tooLong = new Promise((_, reject) => {
    timer = setTimeout(
      () => reject(new assert.AssertionError({ message: `does not settle within ${SECONDS} s` })),
      1000 * SECONDS,
    );
  });
  // What a call throws synchronously counts as a rejection too.
  const made = (async () => call.run(abflat))();
  try {
    return await Promise.race([
      made.then(
        (value) => ({ value }),
        (error) => ({ error }),
      ),
      tooLong,
    ]);
  } finally {
    clearTimeout(timer);
  }
}

/** Makes a call and throws if a property does not hold. Resolves to whether it had a result. */
export async function check(abflat, call, expectedBytes) {
  const before = arraysIn(call.args);
  const { value, error } = await settled(call, abflat);
  const isResult = error === undefined && value !== undefined;
  if (isResult) assertValid(value, call);
  else assertRefusal(error, call);
  const mayMove = Boolean(descriptorsOf(call.args[1]).transfer?.value);
  for (const [array, values] of mayMove ? [] : before)
    assert.deepEqual(elements(array), values, 'input');
  if (!isResult) assert.equal(await knownBytes(abflat), expectedBytes, 'the next call');
  return isResult;
}
