// pack: the layout that a mesh has, packed again, as the command line program does it.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { createAbflat, PACK_DEFAULTS, UV_FAULT } from 'abflat';
import { runAbflat } from '../support/run-abflat.mjs';
import { CUBE, CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { bytesOf } from './support/meshes.mjs';
import { ROOT } from './support/paths.mjs';
import { assertSameShape, assertSameText, withoutSeconds } from './support/same.mjs';
import { assertFails } from './support/unwrapping.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

/** A square of two triangles and a triangle, which share a vertex, and a triangle without texcoords. */
const PARTS = () => ({
  positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 2, 2, 0, 3, 3, 3],
  indices: [0, 1, 2, 1, 3, 2, 3, 4, 5, 4, 6, 5],
  texcoords: [0, 0, 3, 0, 0, 3, 3, 3, 6, 3, 6, 6, Number.NaN, 0],
});

const squared = (a, b) => (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2;
const rowOf = (array, i) => [array[2 * i], array[2 * i + 1]];

test('islands keep their shapes, and a vertex that they shared is copied', async () => {
  const mesh = PARTS();
  const { uv, indices, vertexMap, islandOfTriangle, report } = await abflat.pack(mesh);
  assert.equal(report.valid, true);
  assert.deepEqual([report.islands, report.unmapped], [2, 1]);
  assert.deepEqual([...islandOfTriangle], [0, 0, 1, 2 ** 32 - 1]);
  assert.deepEqual([...vertexMap.slice(0, 7)], [0, 1, 2, 3, 4, 5, 6]);
  // The third vertex of both; the two that a triangle with texcoords shares with one without.
  assert.deepEqual([...vertexMap.slice(7)].sort(), [3, 4, 5]);
  assert.deepEqual(
    [...indices].map((v) => vertexMap[v]),
    mesh.indices,
  );
  for (let i = 0; i < 9; i += 3)
    for (const [a, b] of [
      [0, 1],
      [1, 2],
      [2, 0],
    ]) {
      const [p, q] = [indices[i + a], indices[i + b]];
      const was = squared(
        rowOf(mesh.texcoords, mesh.indices[i + a]),
        rowOf(mesh.texcoords, mesh.indices[i + b]),
      );
      const is = squared(rowOf(uv, p), rowOf(uv, q));
      assert.ok(Math.abs(is / (was * report.scale ** 2) - 1) < 1e-5, `triangle ${i / 3}`);
    }
  for (const v of indices.subarray(0, 9))
    for (const x of rowOf(uv, v)) assert.ok(x > 0 && x < 1 && x === Math.fround(x));
});

test('with keepPlaces the layout is as it was, and what is wrong with each triangle is said', async () => {
  const mesh = PARTS();
  // The last triangle has no texcoords; the one before it is turned over, and all are too large.
  mesh.indices.splice(6, 3, 4, 3, 5);
  const { uv, indices, faults, report } = await abflat.pack(mesh, { keepPlaces: true });
  for (const [i, v] of indices.subarray(0, 9).entries())
    assert.deepEqual([...rowOf(uv, v)], rowOf(mesh.texcoords, mesh.indices[i]));
  const { outside, flipped } = UV_FAULT;
  assert.deepEqual([...faults], [outside, outside, outside | flipped, 0]);
  assert.deepEqual(report.faces, { overlapping: 0, flipped: 1, empty: 0, outside: 3 });
  assert.equal(report.valid, false);
});

test('other coordinates take the place of those of the mesh, in its file, too', async () => {
  const file = { bytes: bytesOf(CUBE_OF_PARTS), name: 'cube.obj' };
  const { uv, indices } = await abflat.pack(file, { keepPlaces: true });
  const given = Float64Array.from(indices, (v) => uv[2 * v]);
  const corners = Float64Array.from({ length: 2 * indices.length }, (_, i) =>
    i % 2 === 0 ? given[i / 2] + 2 : uv[2 * indices[(i - 1) / 2] + 1],
  );
  const moved = await abflat.pack(file, { keepPlaces: true, obj: true, uv: corners });
  const at = Float64Array.from(corners, (_, i) => moved.uv[2 * moved.indices[i >> 1] + (i % 2)]);
  assert.deepEqual(at, corners);
  const written = await abflat.pack({ bytes: moved.obj, name: 'moved.obj' }, { keepPlaces: true });
  assert.deepEqual(written.uv, moved.uv);
  await assertFails(
    abflat,
    abflat.pack(file, { uv: corners.slice(2) }),
    'InvalidMesh',
    /corners of triangles, not 2 for each/,
  );
  await assertFails(abflat, abflat.pack(file, { uv: [0] }), 'InvalidOption', /uv must be a Float/);
});

test('some islands are packed around the others, or all in tiles of their own', async () => {
  const mesh = PARTS();
  mesh.texcoords = mesh.texcoords.map((x) => x / 20);
  const islands = Uint32Array.of(1);
  const some = await abflat.pack(mesh, { islands });
  assert.equal(some.report.valid, true);
  for (const c of [0, 1, 2, 3, 4, 5])
    assert.deepEqual(
      rowOf(some.uv, some.indices[c]),
      rowOf(mesh.texcoords, mesh.indices[c]).map(Math.fround),
    );
  const { uv, indices, report } = await abflat.pack(mesh, { tileOfIsland: Uint32Array.of(0, 10) });
  assert.deepEqual([report.valid, report.tiles], [true, 11]);
  const rows = [...indices.subarray(0, 9)].map((v) => Math.floor(uv[2 * v + 1]));
  assert.deepEqual(rows, [0, 0, 0, 0, 0, 0, 1, 1, 1]);
  await assertFails(
    abflat,
    abflat.pack(mesh, { islands: Uint32Array.of(2) }),
    'InvalidOption',
    /island 2 cannot be packed/,
  );
});

test('options and progress are those of pack', async () => {
  const stages = new Set();
  const { report } = await abflat.pack(PARTS(), {
    islandSizes: 'even',
    margin: 30,
    rotate: 'none',
    onProgress: ({ stage, fraction }) => stages.add(stage) && assert.ok(fraction <= 1),
  });
  assert.deepEqual(report.options, {
    ...PACK_DEFAULTS,
    islandSizes: 'even',
    margin: 30,
    rotate: 'none',
  });
  assert.equal(report.margin, 30);
  assert.deepEqual([...stages], ['read', 'pack', 'check', 'write']);
});

test('a mesh without a layout, and options of other calls, are refused', async () => {
  const { texcoords, ...bare } = PARTS();
  assert.ok(texcoords);
  await assertFails(abflat, abflat.pack(bare), 'NoTexcoords', /Make one with unwrap/);
  const file = { bytes: bytesOf(CUBE), name: 'cube.obj' };
  await assertFails(abflat, abflat.pack(file), 'NoTexcoords', /no face has texcoords/);
  for (const [options, pattern] of [
    [{ maxStretch: 2 }, /maxStretch.*islandSizes/],
    [{ pins: [] }, /pins/],
    [{ islandSizes: 'odd' }, /islandSizes must be one of keep, even/],
    [{ margin: -1 }, /margin/],
    [{ udim: true }, /texel density/],
  ])
    await assertFails(abflat, abflat.pack(PARTS(), options), 'InvalidOption', pattern);
});

test('a signal ends the call, and the next one works', async () => {
  const controller = new AbortController();
  const call = abflat.pack(PARTS(), { signal: controller.signal });
  controller.abort();
  await assert.rejects(call, { name: 'AbortError' });
  assert.equal((await abflat.pack(PARTS())).report.valid, true);
});

const ARTIST = join(ROOT, '../shared/artist');
const artistMeshes = existsSync(ARTIST)
  ? readdirSync(ARTIST).filter((name) => name.endsWith('.obj'))
  : [];
const MESHES = [
  ['cube.obj', CUBE_OF_PARTS],
  ...artistMeshes.map((name) => [name, readFileSync(join(ARTIST, name), 'utf8')]),
];

for (const [name, text] of MESHES)
  test(`${name}: the same bytes and report as from the program`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at(name), text);
    const wasm = await abflat.pack(
      { bytes: bytesOf(text), name },
      { obj: true, padding: 4, rotate: 'quarter' },
    );
    const args = ['pack', name, '-o', 'out.obj', '--padding', '4', '--rotate', 'quarter'];
    const { code, stderr } = await runAbflat([...args, '--report', 'r.json', '-q'], { cwd: at() });
    assert.equal(code, wasm.report.valid ? 0 : 1, stderr);
    assertSameText(new TextDecoder().decode(wasm.obj), readFileSync(at('out.obj'), 'utf8'));
    const native = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assertSameShape(wasm.report, native, 'report');
    const comparable = ({ timings, threads, path, ...report }) => withoutSeconds(report);
    assert.deepEqual(comparable(wasm.report), comparable(native));
    assert.equal(wasm.positions.length, 3 * wasm.vertexMap.length);
  });

test('arguments are read at once, although the module is loaded later', async () => {
  const own = await createAbflat();
  const mesh = { ...PARTS(), positions: new Float64Array(PARTS().positions) };
  const call = own.pack(mesh);
  mesh.positions.fill(0);
  const { uv } = await call;
  assert.deepEqual(uv, (await own.pack(PARTS())).uv);
  own.terminate();
  await assert.rejects(own.pack(PARTS()), { name: 'AbortError' });
});

test('a call ends when everything is terminated while the module is loaded', async () => {
  const own = await createAbflat();
  const call = own.pack(PARTS());
  own.terminate();
  await assert.rejects(call, { name: 'AbortError' });
});

test('a file that is not the module is named, and other calls work', async () => {
  const own = await createAbflat({ packUrl: new URL('./nowhere.wasm', import.meta.url) });
  const failed = { code: 'UnreadableFile', lost: 'module', message: /nowhere\.wasm/ };
  await assert.rejects(own.pack(PARTS()), failed);
  await assert.rejects(own.pack(PARTS()), failed, 'and again');
  assert.equal((await own.inspect(PARTS())).triangles, 4);
  own.terminate();
  const other = await createAbflat({
    packUrl: new URL('./abflat-simd.wasm', import.meta.resolve('abflat')),
  });
  await assert.rejects(other.pack(PARTS()), {
    code: 'UnreadableFile',
    message: /packUrl is not the module of this version of abflat that packs/,
  });
  other.terminate();
});
