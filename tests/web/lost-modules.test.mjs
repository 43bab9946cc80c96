// Transferring values and restarting workers, without a page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { AbflatError, loadModule as load } from './modules.mjs';

test('copies are those of the arrays, whatever their size and kind, in buffers of their own', async () => {
  const { buffersOf, copied } = await load('base/buffers');
  const large = Float64Array.from({ length: 1_300_001 }, (_, i) => i * 1.5);
  const file = new File(['text'], 'a.obj');
  const value = {
    large,
    part: large.subarray(3, 8),
    none: undefined,
    nested: { bytes: Uint8Array.of(1, 2), colors: ['red'] },
    count: 7,
    file,
  };
  const copy = await copied(value);
  assert.deepEqual(copy, value);
  assert.equal(copy.file, file);
  const own = buffersOf(copy);
  assert.equal(own.length, 3);
  for (const buffer of buffersOf(value)) assert.ok(!own.includes(buffer));
  structuredClone(copy.large, { transfer: own });
  assert.equal(copy.large.length, 0);
  assert.equal(value.large.length, 1_300_001);
  assert.equal(value.nested.bytes.length, 2);
});

test('large arrays are copied in tasks between which others run', async () => {
  const { copied } = await load('base/buffers');
  const bytes = new Uint8Array(40 << 20);
  let others = 0;
  const timer = setInterval(() => ++others, 0);
  const copy = copied({ bytes });
  await copy;
  clearInterval(timer);
  assert.ok(others > 0, 'a timer was served');
});

test('what could not be started is started again, what could is not', async () => {
  const { startOnce } = await load('base/start-once');
  let starts = 0;
  const start = startOnce(async () => {
    starts += 1;
    if (starts === 1) throw new Error('offline');
    return starts;
  });
  const [first, same] = await Promise.allSettled([start(), start()]);
  assert.equal(first.reason.message, 'offline');
  assert.equal(same.reason, first.reason);
  assert.equal(await start(), 2);
  assert.equal(await start(), 2);
  assert.equal(starts, 2);
});

test('an error of abflat that it was not loaded is told from that of a mesh', async () => {
  const { lostOf } = await load('base/lost');
  const say = (part, message) => {
    const lost = lostOf(new AbflatError('UnreadableFile', message, part));
    return lost && [lost.message, lost.detail];
  };
  const [notLoaded, detail] = say('module', 'b.wasm: Failed to fetch. A bundler may.');
  assert.match(notLoaded, /connection/);
  assert.equal(detail, 'b.wasm: Failed to fetch.');
  assert.deepEqual(say('worker', 'b.js. Bundlers!'), [notLoaded, 'A worker could not be loaded.']);
  const [stopped, why] = say('stopped', 'memory');
  assert.match(stopped, /stopped/);
  assert.equal(why, 'memory.');
  // Regardless of the wording.
  assert.equal(say(null, 'Cannot load the worker of abflat'), null);
  assert.equal(say(undefined, 'mesh.xyz: unknown format. Use OBJ.'), null);
  assert.equal(lostOf(new Error('The worker of abflat stopped')), null);
});
