// Comparing methods in the package: the layouts themselves, and the same numbers as the command
// line program.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { judge, withoutShared } from '../support/shared.mjs';
import { bytesOf, grid, objText, TETRAHEDRON } from './support/meshes.mjs';
import { NATIVE } from './support/paths.mjs';

const NUMBERS = [
  (m) => m.angularDistortion,
  (m) => m.lengthDistortion,
  (m) => m.areaDistortion,
  (m) => m.areaRatio.min,
  (m) => m.areaRatio.max,
  (m) => m.quasiConformal.mean,
  (m) => m.quasiConformal.max,
  (m) => m.symmetricDirichlet,
];

let abflat;
let folder;
before(async () => {
  abflat = await createAbflat();
  folder = mkdtempSync(join(tmpdir(), 'abflat-compare-'));
});
after(() => {
  abflat?.terminate();
  if (folder) rmSync(folder, { recursive: true });
});

const assertClose = (a, b, what) =>
  assert.ok(Math.abs(a - b) <= 1e-6 * Math.max(Math.abs(b), 1e-6), `${what}: ${a}, not ${b}`);

/** Signed area of each triangle. */
function areas(uv, indices) {
  return Array.from({ length: indices.length / 3 }, (_, f) => {
    const [a, b, c] = [0, 1, 2].map((k) => 2 * indices[3 * f + k]);
    const [ux, uy] = [uv[b] - uv[a], uv[b + 1] - uv[a + 1]];
    return (ux * (uv[c + 1] - uv[a + 1]) - uy * (uv[c] - uv[a])) / 2;
  });
}

for (const name of ['alpha-band', 'three-balls', 'head'])
  test(`${name}: the same numbers as the command line program`, async () => {
    const path = join(folder, `${name}.obj`);
    const text = objText(await abflat.sample(name));
    writeFileSync(path, text);
    const { status, stdout, stderr } = spawnSync(NATIVE, ['compare', path, '--json', '-'], {
      encoding: 'utf8',
    });
    assert.equal(status, 0, stderr);
    const native = JSON.parse(stdout);
    const wasm = await abflat.compare({ bytes: bytesOf(text), name: path });
    assert.deepEqual(wasm.input, native.input);
    assert.equal(wasm.version, native.version);
    assert.equal(wasm.methods.length, native.methods.length);
    for (const [i, found] of wasm.methods.entries()) {
      const wanted = native.methods[i];
      const { uv, ...rest } = found;
      assert.deepEqual(Object.keys(rest), Object.keys(wanted));
      for (const key of ['method', 'title', 'flippedTriangles', 'boundaryCrossings'])
        assert.deepEqual(found[key], wanted[key], wanted.method);
      assert.deepEqual([found.valid, found.problem], [wanted.valid, wanted.problem]);
      for (const number of NUMBERS)
        assertClose(number(found), number(wanted), `${wanted.method} ${number}`);
      assert.equal(uv.length, 2 * wasm.vertexMap.length);
    }
  });

test('each method brings its own layout, of the same area and with the flips it says', async () => {
  const { methods, indices, vertexMap, positions } = await abflat.compare(grid(12));
  assert.equal(positions, undefined);
  assert.equal(indices.length, 3 * 2 * 144);
  const seen = new Set();
  const total = areas(methods[0].uv, indices).reduce((a, b) => a + b);
  for (const { method, uv, flippedTriangles, valid } of methods) {
    assert.ok(uv instanceof Float64Array);
    assert.equal(uv.length, 2 * vertexMap.length);
    seen.add(Array.from(uv.slice(0, 40), (x) => x.toFixed(6)).join());
    const signed = areas(uv, indices);
    assertClose(
      signed.reduce((a, b) => a + b),
      total,
      method,
    );
    assert.equal(signed.filter((area) => !(area > 0)).length, flippedTriangles);
    assert.equal(valid, true);
  }
  // t = auto leaves this boundary free.
  assert.equal(seen.size, methods.length - 1);
});

test('the judge finds the same of every layout', { skip: withoutShared }, async () => {
  const mesh = await abflat.sample('alpha-band');
  const plain = join(folder, 'plain.obj');
  writeFileSync(plain, objText(mesh));
  const { methods } = await abflat.compare(mesh);
  const lines = objText(mesh).split('\n');
  for (const m of methods) {
    const texcoords = Array.from(
      { length: m.uv.length / 2 },
      (_, i) => `vt ${m.uv[2 * i]} ${m.uv[2 * i + 1]}`,
    );
    const faces = lines
      .filter((line) => line.startsWith('f'))
      .map((line) => line.replace(/(\d+)/g, '$1/$1'));
    const vertices = lines.filter((line) => line.startsWith('v'));
    const result = join(folder, `${m.method}.obj`);
    writeFileSync(result, [...vertices, ...texcoords, ...faces, ''].join('\n'));
    const found = judge(plain, result, 2);
    assertClose(m.angularDistortion, found.angularDistortion, `${m.method} angles`);
    assertClose(m.lengthDistortion, found.lengthDistortion, `${m.method} lengths`);
    assertClose(m.symmetricDirichlet, found.symmetricDirichlet, `${m.method} Dirichlet`);
    assertClose(m.quasiConformal.mean, found.quasiConformal.mean, `${m.method} conformal`);
    assert.equal(m.flippedTriangles, found.flipped + found.zeroArea);
    assert.equal(m.valid, found.flipped + found.zeroArea + found.boundaryCrossings === 0);
  }
});

test('a file brings its positions', async () => {
  const mesh = grid(3);
  const { positions, input } = await abflat.compare({
    bytes: bytesOf(objText(mesh)),
    name: 'a.obj',
  });
  assert.deepEqual(positions, mesh.positions);
  assert.equal(input.path, 'a.obj');
});

test('progress names every method in turn and ends at 1', async () => {
  const seen = [];
  const file = { bytes: bytesOf(objText(grid(20))), name: 'a.obj' };
  const { methods } = await abflat.compare(file, { onProgress: (p) => seen.push(p) });
  assert.deepEqual(
    [...new Set(seen.map(({ stage }) => stage))],
    ['read', ...methods.map(({ method }) => method)],
  );
  for (let i = 1; i < seen.length; i++) assert.ok(seen[i].fraction >= seen[i - 1].fraction);
  assert.equal(seen.at(-1).fraction, 1);
});

test('an abort ends a comparison at once, and the next call works', async () => {
  const controller = new AbortController();
  const { signal } = controller;
  let count = 0;
  const onProgress = () => {
    ++count;
    controller.abort();
  };
  const call = abflat.compare(grid(150), { signal, onProgress });
  await assert.rejects(call, { name: 'AbortError' });
  assert.equal((await abflat.compare(grid(3))).methods.length, 10);
  assert.equal(count, 1);
});

test('transfer moves the buffers, without it they stay', async () => {
  const mesh = grid(4);
  const { methods } = await abflat.compare(mesh);
  assert.equal(mesh.positions.length, 75);
  const moved = await abflat.compare(mesh, { transfer: true });
  assert.equal(mesh.positions.length, 0);
  for (const [i, { uv }] of moved.methods.entries()) assert.deepEqual(uv, methods[i].uv);
});

test('what cannot be flattened or understood is refused', async () => {
  await assert.rejects(abflat.compare(TETRAHEDRON), { code: 'ClosedSurface' });
  await assert.rejects(abflat.compare(grid(2), { t: 1 }), { code: 'InvalidOption' });
  await assert.rejects(abflat.compare(grid(2), { onProgress: 1 }), { code: 'InvalidOption' });
  await assert.rejects(abflat.compare({ bytes: bytesOf('v 1\n'), name: 'a.obj' }), {
    code: 'ParseError',
  });
});
