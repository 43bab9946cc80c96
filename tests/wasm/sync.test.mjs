// The engine in the calling thread: the same calls, which return their results.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { AbflatError, createAbflat, SAMPLE_NAMES } from 'abflat';
import { unwrap } from 'abflat/gltf';
import { createAbflatSync } from 'abflat/sync';
import { unwrapGeometry } from 'abflat/three';
import * as THREE from 'three';
import { addMesh, emptyDocument, primitiveOf, primitivesOf } from '../support/gltf.mjs';
import { sphere } from '../support/surfaces.mjs';
import { oneColour, SQUARE } from './support/bake.mjs';
import { bytesOf, grid, objText, TETRAHEDRON } from './support/meshes.mjs';
import { DIST } from './support/paths.mjs';

let abflat;
let inWorker;
before(async () => {
  abflat = await createAbflatSync({ also: ['pack', 'bake'] });
  inWorker = await createAbflat();
});
after(() => {
  abflat.terminate();
  inWorker.terminate();
});

const bytesOfFile = (name) => readFileSync(join(DIST, name));

/** Without what depends on the clock and on the module's past. */
function withoutTimes(result) {
  if (!result.report) return result;
  const { timings, peakMemory: _, ...report } = result.report;
  assert.ok(timings.total > 0);
  const seconds = ({ seconds: _, ...chart }) => chart;
  const charts = report.charts?.map(seconds);
  return { ...result, report: { ...report, ...(charts && { charts }) } };
}

const squareLayout = { uv: SQUARE.texcoords, indices: SQUARE.indices };
const CALLS = {
  flatten: (a) => a.flatten(grid(20), { t: 1, obj: true }),
  unwrap: (a) => a.unwrap(TETRAHEDRON, { padding: 4 }),
  'unwrap of a file': (a) => a.unwrap({ bytes: bytesOf(objText(grid(9))), name: 'a.obj' }),
  pack: (a) => a.pack(SQUARE, { resolution: 64 }),
  verify: (a) => a.verify(SQUARE, { padding: 3 }),
  bake: (a) =>
    a.bake(SQUARE, squareLayout, { image: oneColour(9, 99, 199, 255) }, { bakeResolution: 32 }),
  inspect: (a) => a.inspect(TETRAHEDRON),
  pinWeights: (a) => a.pinWeights(SQUARE, [0, 2]),
  load: (a) => a.load({ bytes: bytesOf(objText(grid(3))), name: 'a.obj' }),
  sample: (a) => a.sample(SAMPLE_NAMES[0]),
};
for (const [name, call] of Object.entries(CALLS))
  test(`${name} returns what the worker does`, async () => {
    const result = call(abflat);
    assert.ok(!(result instanceof Promise));
    assert.deepEqual(withoutTimes(result), withoutTimes(await call(inWorker)));
  });

test('compare returns the layouts that the worker does', async () => {
  const layouts = ({ methods }) => methods.map(({ method, uv, valid }) => ({ method, uv, valid }));
  const disk = grid(6);
  assert.deepEqual(layouts(abflat.compare(disk)), layouts(await inWorker.compare(disk)));
});

test('arrays stay with the caller, unchanged, even with transfer', () => {
  const mesh = grid(5);
  const file = { bytes: bytesOf(objText(mesh)), name: 'a.obj' };
  const before = structuredClone({ mesh, file });
  for (const transfer of [false, true]) {
    abflat.unwrap(mesh, { transfer });
    abflat.flatten(file, { transfer });
  }
  assert.deepEqual({ mesh, file }, before);
});

test('a view into a buffer and shared memory are read where they are', () => {
  const { positions, indices } = grid(4);
  const { uv } = abflat.flatten({ positions, indices });
  const shared = new Float64Array(new SharedArrayBuffer(8 * positions.length + 16), 16);
  shared.set(positions);
  assert.deepEqual(abflat.flatten({ positions: shared, indices }).uv, uv);
});

const REFUSED = {
  'no mesh': (a) => a.unwrap(null),
  'an index out of range': (a) => a.unwrap({ ...TETRAHEDRON, indices: [0, 1, 9] }),
  'a closed surface': (a) => a.flatten(TETRAHEDRON),
  'an option out of its range': (a) => a.unwrap(TETRAHEDRON, { padding: -1 }),
  'an unknown option': (a) => a.unwrap(TETRAHEDRON, { paddings: 1 }),
  'a broken file': (a) => a.load({ bytes: bytesOf('v 0 0\nf 1 2 3\n'), name: 'a.obj' }),
  'no texcoords': (a) => a.pack(TETRAHEDRON),
  'no sources': (a) => a.bake(SQUARE, squareLayout, []),
  'a detached array': (a) => {
    const mesh = grid(2);
    structuredClone(mesh.positions, { transfer: [mesh.positions.buffer] });
    return a.unwrap(mesh);
  },
};
for (const [name, call] of Object.entries(REFUSED))
  test(`${name} is the error that the worker gives, and the next call works`, async () => {
    const wanted = await call(inWorker).catch((error) => error);
    assert.throws(
      () => call(abflat),
      (error) => {
        assert.ok(error instanceof AbflatError, `${error}`);
        assert.deepEqual([error.code, error.message], [wanted.code, wanted.message]);
        return true;
      },
    );
    assert.equal(abflat.unwrap(TETRAHEDRON).report.valid, true);
  });

test('progress is told as in a worker, and a listener can end the call', () => {
  const seen = [];
  abflat.flatten(grid(30), { onProgress: (progress) => seen.push(progress) });
  assert.equal(seen.at(-1).fraction, 1);
  assert.deepEqual(
    [...new Set(seen.map(({ stage }) => stage))],
    ['read', 'connectivity', 'solve', 'layout', 'check', 'write'],
  );

  const mine = new RangeError('of the listener');
  const onProgress = () => {
    throw mine;
  };
  assert.throws(
    () => abflat.unwrap(grid(30), { onProgress }),
    (error) => error === mine,
  );
  const controller = new AbortController();
  const { signal } = controller;
  let count = 0;
  const abort = () => {
    ++count;
    controller.abort();
  };
  assert.throws(
    () => abflat.flatten(grid(60), { signal, onProgress: abort }),
    (error) => error === signal.reason,
  );
  assert.equal(count, 1);
  assert.throws(() => abflat.unwrap(grid(2), { signal }), { name: 'AbortError' });
  assert.equal(abflat.unwrap(grid(2)).report.valid, true);
});

test('a listener cannot make another call of the same module', () => {
  const onProgress = () => abflat.unwrap(TETRAHEDRON);
  assert.throws(() => abflat.unwrap(grid(3), { onProgress }), {
    code: 'InvalidOption',
    message: /listener.*busy/,
  });
  assert.equal(abflat.unwrap(TETRAHEDRON).report.valid, true);
});

test('after a lack of memory the next call works at once', async () => {
  const small = await createAbflatSync({ maxMemory: 2 ** 25 });
  const large = grid(300);
  for (let i = 0; i < 3; ++i) {
    assert.throws(() => small.flatten(large), { code: 'OutOfMemory', message: /32 MB/ });
    assert.equal(small.flatten(grid(3)).report.valid, true);
  }
});

test('modules are given compiled, as bytes, or by their places', async () => {
  const bytes = bytesOfFile('abflat-simd.wasm');
  const module = await WebAssembly.compile(bytes);
  const buffer = new Uint8Array(bytes).buffer;
  const url = new URL(`file://${join(DIST, 'abflat-simd.wasm')}`);
  for (const create of [createAbflat, createAbflatSync]) {
    for (const wasmUrl of [module, bytes, new Uint8Array(bytes), buffer]) {
      const one = await create({ wasmUrl, maxMemory: 2 ** 28 });
      assert.equal(one.build, 'simd');
      assert.equal((await one.unwrap(TETRAHEDRON)).report.valid, true);
      one.terminate();
    }
    const packUrl = await WebAssembly.compile(bytesOfFile('abflat-pack.wasm'));
    const bakeUrl = bytesOfFile('abflat-bake.wasm');
    const all = await create({ wasmUrl: url, packUrl, bakeUrl });
    assert.equal((await all.pack(SQUARE)).report.valid, true);
    const baked = await all.bake(SQUARE, squareLayout, { factor: [1, 0, 0, 1] });
    assert.deepEqual([...baked.data.subarray(0, 4)], [255, 0, 0, 255]);
    all.terminate();
    const placed = await create({ baseUrl: DIST, build: 'simd' });
    assert.equal(placed.build, 'simd');
    placed.terminate();
  }
});

test('modules that are none, or others, are refused', async () => {
  const empty = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
  const wrong = [
    [
      { wasmUrl: new Uint8Array(3) },
      'UnreadableFile',
      /module given as wasmUrl is not a WebAssembly/,
    ],
    [{ wasmUrl: empty }, 'UnreadableFile', /wasmUrl is not a WebAssembly module of this version/],
    [{ wasmUrl: bytesOfFile('abflat-pack.wasm') }, 'UnreadableFile', /wasmUrl/],
    [{ wasmUrl: 7 }, 'InvalidOption', /wasmUrl must be a URL/],
    [{ wasmUrl: '/nowhere.wasm' }, 'UnreadableFile', /nowhere\.wasm/],
    [{ build: 'fast' }, 'InvalidOption', /must be one of simd, threads/],
    [{ maxMemory: 1 }, 'InvalidOption', /maxMemory/],
    [{ baseUrl: 5 }, 'InvalidOption', /baseUrl must be a URL\./],
  ];
  for (const [settings, code, message] of wrong)
    for (const create of [createAbflat, createAbflatSync])
      await assert.rejects(create(settings), { code, message }, `${message}`);
  const onlySync = [
    [{ build: 'threads' }, 'InvalidOption', /threads build cannot run in the calling thread/],
    [{ packUrl: bytesOfFile('abflat-bake.wasm') }, 'UnreadableFile', /packUrl/],
    [{ wasmUrl: bytesOfFile('abflat-threads.wasm') }, 'InvalidOption', /threads/],
    [{ also: ['cut'] }, 'InvalidOption', /also must be a list of pack, bake, not "cut"/],
    [{ also: 'pack' }, 'InvalidOption', /also must be a list/],
    [{ workers: 2 }, 'InvalidOption', /no option "workers"/],
  ];
  for (const [settings, code, message] of onlySync)
    await assert.rejects(createAbflatSync(settings), { code, message });
});

test('a method whose module was not loaded says what to pass', async () => {
  const bare = await createAbflatSync();
  assert.throws(() => bare.pack(SQUARE), {
    code: 'InvalidOption',
    message: /also: \['pack'\].*packUrl/,
  });
  assert.throws(() => bare.bake(SQUARE, squareLayout, {}), { message: /also: \['bake'\]/ });
});

test('terminate refuses later calls', async () => {
  const other = await createAbflatSync({ also: ['pack'] });
  other.terminate();
  for (const call of [() => other.unwrap(TETRAHEDRON), () => other.pack(SQUARE)])
    assert.throws(call, { name: 'AbortError' });
});

test('the helpers for documents and geometries take it', async () => {
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(6)));
  await document.transform(unwrap(abflat, { bake: false }));
  assert.ok(primitivesOf(document)[0].getAttribute('TEXCOORD_0'));
  const { result } = await unwrapGeometry(abflat, new THREE.BoxGeometry());
  assert.equal(result.report.valid, true);
});

test('a module that can only start asynchronously is there a moment after it has stopped', async () => {
  const { LocalModule } = await import(join(DIST, 'local-module.js'));
  const runner = () => ({
    heapBytes: 0,
    isBroken: false,
    run({ fails }) {
      if (!fails) return 'done';
      this.isBroken = true;
      throw new AbflatError('OutOfMemory', 'There is not enough memory.');
    },
  });
  const starter = { now: () => undefined, later: async () => runner() };
  const module = await LocalModule.start(starter);
  const call = (fails) => module.answer({ request: { fails }, settings: {} });
  assert.equal(call(false), 'done');
  assert.throws(() => call(true), { code: 'OutOfMemory' });
  assert.throws(() => call(false), { code: 'Internal', lost: 'stopped', message: /Await/ });
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(call(false), 'done');
});
