// Cancelling, queueing, progress, buffers, and the life of the worker.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { bytesOf, grid, objText } from './support/meshes.mjs';
import { ROOT } from './support/paths.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** Large enough to still be busy when the first progress arrives. */
const LARGE = grid(250);

function assertAborts(promise) {
  return assert.rejects(promise, (error) => {
    assert.ok(error instanceof DOMException, `${error}`);
    assert.equal(error.name, 'AbortError');
    return true;
  });
}

/** A call that is certainly running, and the means to abort it. */
async function runningCall() {
  const controller = new AbortController();
  const { signal } = controller;
  let call;
  await new Promise((resolve, reject) => {
    call = abflat.flatten(LARGE, { signal, onProgress: resolve });
    call.catch(reject);
  });
  return { controller, call };
}

test('abort ends a running call, and the next one works', async () => {
  const { controller, call } = await runningCall();
  controller.abort();
  await assertAborts(call);
  assert.equal((await abflat.flatten(grid(4))).report.valid, true);
});

test('abort of the running call lets the waiting ones go on', async () => {
  const { controller, call } = await runningCall();
  const waiting = [abflat.flatten(grid(4)), abflat.inspect(grid(5)), abflat.sample('hemisphere')];
  controller.abort();
  await assertAborts(call);
  const [flat, summary, sample] = await Promise.all(waiting);
  assert.equal(flat.report.valid, true);
  assert.equal(summary.faces, 50);
  assert.ok(sample.indices.length > 0);
});

test('abort of a waiting call leaves the running one alone', async () => {
  const first = abflat.flatten(grid(30));
  const controller = new AbortController();
  const second = abflat.flatten(grid(4), { signal: controller.signal });
  const third = abflat.flatten(grid(5));
  controller.abort();
  await assertAborts(second);
  assert.equal((await first).report.valid, true);
  assert.equal((await third).report.valid, true);
});

test('an aborted signal refuses the call and leaves the buffers alone', async () => {
  const mesh = grid(3);
  await assertAborts(abflat.flatten(mesh, { signal: AbortSignal.abort(), transfer: true }));
  assert.equal(mesh.positions.length, 48);
});

test('an abort rejects with the reason of the signal', async () => {
  const reason = new RangeError('no longer wanted');
  const { controller, call } = await runningCall();
  const waiting = abflat.unwrap(grid(4), { signal: controller.signal });
  controller.abort(reason);
  const late = abflat.sample('head', { signal: controller.signal });
  for (const promise of [call, waiting, late])
    await assert.rejects(promise, (error) => error === reason);

  const signal = AbortSignal.timeout(1);
  await assert.rejects(abflat.flatten(LARGE, { signal }), { name: 'TimeoutError' });
  assert.equal((await abflat.flatten(grid(4))).report.valid, true);
});

test('abort after the end changes nothing', async () => {
  const controller = new AbortController();
  await abflat.flatten(grid(3), { signal: controller.signal });
  controller.abort();
  assert.equal((await abflat.flatten(grid(3))).report.valid, true);
});

test('no progress arrives after an abort', async () => {
  const controller = new AbortController();
  let count = 0;
  const onProgress = () => {
    ++count;
    controller.abort();
  };
  await assertAborts(abflat.flatten(LARGE, { signal: controller.signal, onProgress }));
  await abflat.flatten(grid(20));
  assert.equal(count, 1);
});

test('calls end in the order they were made', async () => {
  const ended = [];
  const calls = [12, 3, 8, 2].map((size) =>
    abflat.flatten(grid(size)).then(() => ended.push(size)),
  );
  await Promise.all(calls);
  assert.deepEqual(ended, [12, 3, 8, 2]);
});

test('what the caller does with the mesh after the call does not matter', async () => {
  const mesh = grid(6);
  const { uv } = await abflat.flatten(mesh);
  const first = abflat.flatten(grid(20));
  const second = abflat.flatten(mesh);
  mesh.positions.fill(0);
  mesh.indices.fill(0);
  await first;
  assert.deepEqual((await second).uv, uv);
});

test('buffers stay with the caller unless transfer is asked for', async () => {
  const mesh = grid(5);
  const file = { bytes: bytesOf(objText(mesh)), name: 'a.obj' };
  await abflat.flatten(mesh);
  await abflat.inspect(file);
  assert.equal(mesh.positions.length, 108);
  assert.equal(mesh.indices.length, 150);
  assert.ok(file.bytes.length > 0);
});

test('transfer: true moves the buffers', async () => {
  const mesh = grid(5);
  const file = { bytes: bytesOf(objText(mesh)), name: 'a.obj' };
  const { uv } = await abflat.flatten(mesh);
  const moved = await abflat.flatten(mesh, { transfer: true });
  assert.deepEqual(moved.uv, uv);
  assert.equal(mesh.positions.buffer.byteLength, 0);
  assert.equal(mesh.indices.buffer.byteLength, 0);
  assert.deepEqual((await abflat.flatten(file, { transfer: true })).uv, uv);
  assert.equal(file.bytes.byteLength, 0);
});

test('transfer: true with both arrays in one buffer', async () => {
  const { positions, indices } = grid(4);
  const buffer = new ArrayBuffer(positions.byteLength + indices.byteLength);
  const mesh = {
    positions: new Float64Array(buffer, 0, positions.length),
    indices: new Uint32Array(buffer, positions.byteLength),
  };
  mesh.positions.set(positions);
  mesh.indices.set(indices);
  const { uv } = await abflat.flatten({ positions, indices });
  assert.deepEqual((await abflat.flatten(mesh, { transfer: true })).uv, uv);
  assert.equal(buffer.byteLength, 0);
});

test('arrays in shared memory work', async () => {
  const { positions, indices } = grid(4);
  const shared = new Float64Array(new SharedArrayBuffer(positions.byteLength));
  shared.set(positions);
  const { uv } = await abflat.flatten({ positions, indices });
  assert.deepEqual((await abflat.flatten({ positions: shared, indices })).uv, uv);
});

test('a Node buffer from the pool is copied', async () => {
  const bytes = Buffer.from(objText(grid(2)));
  const { report } = await abflat.flatten({ bytes, name: 'a.obj' });
  assert.equal(report.valid, true);
  assert.ok(bytes.length > 0);
});

test('progress is monotonous, names every stage and ends at 1', async () => {
  const seen = [];
  const file = { bytes: bytesOf(objText(grid(40))), name: 'a.obj' };
  const { report } = await abflat.flatten(file, { obj: true, onProgress: (p) => seen.push(p) });
  const fractions = seen.map(({ fraction }) => fraction);
  assert.deepEqual(
    fractions,
    [...fractions].sort((a, b) => a - b),
  );
  assert.ok(fractions.every((fraction) => fraction >= 0 && fraction <= 1));
  assert.equal(fractions.at(-1), 1);
  const stages = ['read', 'connectivity', 'solve', 'layout', 'check', 'write'];
  assert.deepEqual([...new Set(seen.map(({ stage }) => stage))], stages);
  assert.ok(report.charts[0].iterations >= Math.max(...seen.map(({ newtonStep }) => newtonStep)));
});

test('progress comes about 30 times a second at most', async () => {
  let count = 0;
  const start = performance.now();
  await abflat.flatten(grid(100), { onProgress: () => ++count });
  const seconds = (performance.now() - start) / 1000;
  // The start of each of the six stages and the end are never throttled.
  assert.ok(count <= 30 * seconds + 8, `${count} in ${seconds} s`);
});

test('what onProgress throws rejects the call, and the next one works', async () => {
  const onProgress = () => {
    throw new RangeError('from the callback');
  };
  await assert.rejects(abflat.flatten(grid(60), { onProgress }), /from the callback/);
  assert.equal((await abflat.flatten(grid(3))).report.valid, true);
});

test('terminate rejects running, waiting and later calls', async () => {
  const other = await createAbflat();
  const calls = [other.flatten(LARGE), other.flatten(grid(3)), other.sample('head')];
  other.terminate();
  for (const call of calls) await assertAborts(call);
  await assertAborts(other.flatten(grid(3)));
  other.terminate();
});

test('many aborted calls in a row leave a working worker', async () => {
  for (let i = 0; i < 5; ++i) {
    const controller = new AbortController();
    const call = abflat.flatten(LARGE, { signal: controller.signal });
    setTimeout(() => controller.abort(), 5 * i);
    await assertAborts(call);
  }
  assert.equal((await abflat.flatten(grid(3))).report.valid, true);
});

/** Runs a script in a separate process. */
function runScript(text) {
  const args = ['--input-type=module', '--eval', text];
  return spawnSync(process.execPath, args, { cwd: ROOT, encoding: 'utf8', timeout: 60_000 });
}

const TRIANGLE =
  '{ positions: new Float64Array([0,0,0,1,0,0,0,1,0]), indices: new Uint32Array([0,1,2]) }';

test('an idle worker does not keep the process alive', () => {
  const { status, stderr } = runScript(`
    import { createAbflat } from 'abflat';
    const abflat = await createAbflat();
    await abflat.flatten(${TRIANGLE});
  `);
  assert.equal(status, 0, stderr);
  assert.equal(stderr, '');
});

test('a call that nobody awaits is finished before the process ends', () => {
  const { status, stdout, stderr } = runScript(`
    import { createAbflat } from 'abflat';
    createAbflat().then((abflat) => abflat.flatten(${TRIANGLE})).then(({ report }) => console.log(report.valid));
  `);
  assert.equal(status, 0, stderr);
  assert.equal(stdout, 'true\n');
});
