// Several workers, calls that wait for room, and cancelling.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { SQUARE } from './support/bake.mjs';
import { grid } from './support/meshes.mjs';
import { ROOT } from './support/paths.mjs';

/** Large enough to be busy for a while. */
const LARGE = grid(200);

let pool;
before(async () => {
  pool = await createAbflat({ workers: 2 });
});
after(() => pool.terminate());

/** A promise for the first progress of a call, and the call. */
function begun(make) {
  let call;
  const started = new Promise((resolve, reject) => {
    call = make(resolve);
    call.catch(reject);
  });
  return { call, started };
}

test('several workers give the results of one', async () => {
  const alone = await createAbflat({ build: 'simd' });
  assert.equal(pool.build, 'simd');
  const sizes = [12, 3, 8, 20, 5];
  const results = await Promise.all(sizes.map((size) => pool.unwrap(grid(size))));
  for (const [i, size] of sizes.entries()) {
    const { uv, indices, vertexMap } = await alone.unwrap(grid(size));
    const found = results[i];
    assert.deepEqual([found.uv, found.indices, found.vertexMap], [uv, indices, vertexMap]);
  }
  alone.terminate();
});

test('two calls run at a time, and others follow in their order', async () => {
  const starts = [];
  const options = (name) => ({
    onProgress: () => {
      if (!starts.includes(name)) starts.push(name);
    },
  });
  const first = begun((onProgress) => pool.flatten(LARGE, { onProgress }));
  const second = begun((onProgress) => pool.flatten(LARGE, { onProgress }));
  const others = ['a', 'b', 'c', 'd'].map((name) => pool.flatten(grid(30), options(name)));
  // Neither waits for the other to end.
  await Promise.all([first.started, second.started]);
  assert.deepEqual(starts, []);
  await Promise.all([first.call, second.call, ...others]);
  // What one worker has taken may be heard of after what the other does next, but each of them
  // takes what is next: no three are heard of the other way round.
  assert.deepEqual([...starts].sort(), ['a', 'b', 'c', 'd']);
  assert.ok('ab'.includes(starts[0]), starts.join());
  const isBetween = (name, i) =>
    starts.slice(0, i).some((earlier) => earlier > name) &&
    starts.slice(i).some((later) => later < name);
  assert.ok(!starts.some(isBetween), starts.join());
});

test('cancelling a call leaves its worker, and the others go on', async () => {
  const controller = new AbortController();
  const { signal } = controller;
  const first = begun((onProgress) => pool.flatten(LARGE, { signal, onProgress }));
  const second = begun((onProgress) => pool.flatten(LARGE, { onProgress }));
  const waiting = pool.flatten(grid(10), { signal });
  const later = pool.flatten(grid(9));
  await Promise.all([first.started, second.started]);
  controller.abort(new RangeError('no longer'));
  await assert.rejects(first.call, /no longer/);
  await assert.rejects(waiting, /no longer/);
  assert.equal((await later).report.valid, true);
  assert.equal((await second.call).report.valid, true);
});

test('a cancelled call ends in its worker, which takes the next one', () => {
  const text = `
    import { Worker } from 'node:worker_threads';
    import { createAbflat } from 'abflat';
    const { terminate } = Worker.prototype;
    let ended = 0;
    Worker.prototype.terminate = function () { ++ended; return terminate.call(this); };
    const size = 60;
    const positions = Float64Array.from({ length: 3 * size ** 2 }, (_, i) =>
      [Math.floor(i / 3) % size, Math.floor(i / 3 / size), Math.sin(i / 3)][i % 3]);
    const indices = [];
    for (let y = 0; y < size - 1; ++y)
      for (let x = 0; x < size - 1; ++x) {
        const v = y * size + x;
        indices.push(v, v + 1, v + size, v + 1, v + size + 1, v + size);
      }
    const mesh = { positions, indices };
    for (const settings of [{}, { workers: 1 }]) {
      const abflat = await createAbflat(settings);
      for (let i = 0; i < 5; ++i) {
        const controller = new AbortController();
        const options = { signal: controller.signal, onProgress: () => controller.abort() };
        const name = await abflat.unwrap(mesh, options).catch((error) => error.name);
        const { report } = await abflat.inspect(mesh).then((report) => ({ report }));
        console.log(name, report.faces);
      }
    }
    console.log(ended);
  `;
  const args = ['--input-type=module', '--eval', text];
  const { stdout, stderr } = spawnSync(process.execPath, args, { cwd: ROOT, encoding: 'utf8' });
  assert.equal(stderr, '');
  assert.equal(stdout, `${'AbortError 6962\n'.repeat(10)}0\n`);
});

test('one signal of many calls has one listener, which is taken off', async () => {
  const controller = new AbortController();
  const { signal } = controller;
  let [most, listeners] = [0, 0];
  const { addEventListener, removeEventListener } = signal;
  signal.addEventListener = (...args) => {
    most = Math.max(most, ++listeners);
    return addEventListener.apply(signal, args);
  };
  signal.removeEventListener = (...args) => {
    --listeners;
    return removeEventListener.apply(signal, args);
  };
  const alone = await createAbflat({ queue: 2 });
  for (const abflat of [pool, alone]) {
    [most, listeners] = [0, 0];
    await Promise.all(Array.from({ length: 20 }, () => abflat.inspect(grid(2), { signal })));
    assert.deepEqual([most, listeners], [1, 0]);
  }
  const calls = Array.from({ length: 20 }, () => alone.unwrap(grid(2), { signal }));
  controller.abort();
  for (const call of calls) await assert.rejects(call, { name: 'AbortError' });
  assert.equal(listeners, 0);
  alone.terminate();
});

/** A mesh that knows when it is read. */
function watched(size, onRead) {
  const { positions, indices } = grid(size);
  return {
    indices,
    get positions() {
      onRead();
      return positions;
    },
  };
}

test('a call that finds the queue full reads its mesh when there is room', async () => {
  const abflat = await createAbflat({ workers: 2, queue: 1 });
  const read = [];
  const ended = [];
  const calls = [0, 1, 2, 3, 4, 5].map((i) =>
    abflat.unwrap(watched(20, () => read.push(i))).then(() => ended.push(i)),
  );
  assert.deepEqual(read, [0, 1, 2]);
  await Promise.race(calls);
  await Promise.all(calls);
  assert.deepEqual(read, [0, 1, 2, 3, 4, 5]);
  assert.equal(ended.length, 6);

  const none = await createAbflat({ queue: 0 });
  read.length = 0;
  const two = [0, 1].map((i) => none.unwrap(watched(20, () => read.push(i))));
  assert.deepEqual(read, [0]);
  await Promise.all(two);
  abflat.terminate();
  none.terminate();
});

test('there are never more copies than running and waiting calls', async () => {
  const abflat = await createAbflat({ workers: 1, queue: 2 });
  let [open, most] = [0, 0];
  const calls = Array.from({ length: 12 }, () =>
    abflat
      .inspect(
        watched(10, () => {
          most = Math.max(most, ++open);
        }),
      )
      .finally(() => --open),
  );
  await Promise.all(calls);
  assert.equal(most, 3);
  abflat.terminate();
});

test('a call that waits for room can be cancelled, refused and terminated', async () => {
  const abflat = await createAbflat({ workers: 1, queue: 0 });
  const controller = new AbortController();
  const { signal } = controller;
  const running = abflat.unwrap(grid(40));
  let reads = 0;
  const mesh = () => watched(5, () => ++reads);
  const failing = (call) => {
    call.catch(() => undefined); // looked at later
    return call;
  };
  const cancelled = failing(abflat.unwrap(mesh(), { signal }));
  const wrong = failing(abflat.unwrap(mesh(), { paddings: 1 }));
  const noSignal = failing(abflat.unwrap(mesh(), { signal: 5 }));
  const last = abflat.unwrap(mesh());
  await assert.rejects(noSignal, { code: 'InvalidOption', message: /signal/ });
  controller.abort();
  await assert.rejects(cancelled, { name: 'AbortError' });
  await assert.rejects(abflat.unwrap(mesh(), { signal }), { name: 'AbortError' });
  assert.equal(reads, 0);
  assert.equal((await running).report.valid, true);
  await assert.rejects(wrong, { code: 'InvalidOption', message: /paddings/ });
  assert.equal((await last).report.valid, true);
  assert.equal(reads, 1);

  const busy = failing(abflat.unwrap(grid(40)));
  const late = failing(abflat.unwrap(mesh()));
  const packing = [abflat.pack(SQUARE), abflat.pack(SQUARE)].map(failing);
  abflat.terminate();
  for (const call of [busy, late, ...packing, failing(abflat.unwrap(mesh()))])
    await assert.rejects(call, { name: 'AbortError' });
  assert.equal(reads, 1);
});

test('an error of one call is not that of others', async () => {
  const calls = [pool.unwrap(grid(4)), pool.flatten({ positions: [] }), pool.unwrap(grid(5))];
  const [first, failed, third] = await Promise.allSettled(calls);
  assert.equal(failed.reason.code, 'EmptyMesh');
  assert.ok(first.value.report.valid && third.value.report.valid);
});

test('numbers that make no sense are refused', async () => {
  for (const workers of [0, 1.5, 65, '2', null])
    await assert.rejects(createAbflat({ workers }), {
      code: 'InvalidOption',
      message: /workers must be a whole number from 1 to 64/,
    });
  for (const queue of [-1, 0.5, '2', null])
    await assert.rejects(createAbflat({ queue }), {
      code: 'InvalidOption',
      message: /queue must be a whole number from 0/,
    });
});

test('memory stays what it is over many calls', async () => {
  const abflat = await createAbflat({ workers: 2, queue: 2 });
  const mesh = grid(12);
  const run = async (count) => {
    await Promise.all(Array.from({ length: count }, () => abflat.unwrap(mesh)));
    return (await abflat.unwrap(mesh)).report.peakMemory.write;
  };
  const first = await run(10);
  assert.equal(await run(40), first);
  abflat.terminate();
});
