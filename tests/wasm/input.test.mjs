// Arrays of every kind.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { sphere } from '../support/surfaces.mjs';
import { grid } from './support/meshes.mjs';
import { arraysOf } from './support/unwrapping.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** Integer coordinates, so that every numeric type holds them. */
const HILL = (() => {
  const { positions, indices } = grid(5);
  return { positions: positions.map((x) => Math.round(20 * x)), indices };
})();

test('every kind of array is the same mesh', async () => {
  const { positions, indices } = HILL;
  const { uv } = await abflat.flatten(HILL);
  for (const Kind of [Array, Float32Array, Int8Array, Int16Array, Int32Array])
    assert.deepEqual((await abflat.flatten({ positions: Kind.from(positions), indices })).uv, uv);
  for (const Kind of [Array, Uint8Array, Uint16Array, Int32Array])
    for (const transfer of [false, true]) {
      const mesh = { positions: positions.slice(), indices: Kind.from(indices) };
      assert.deepEqual((await abflat.flatten(mesh, { transfer })).uv, uv, Kind.name);
    }
});

test('coordinates and materials come in every kind as well', async () => {
  const { positions, indices } = HILL;
  const count = indices.length / 3;
  const materials = Array.from({ length: count }, (_, i) => Number(i >= count / 2));
  const texcoords = Array.from({ length: (2 * positions.length) / 3 }, (_, i) => i % 7);
  const mesh = { positions, indices, materials, texcoords };
  const { chartOfTriangle } = await abflat.unwrap(mesh, { seams: 'material' });
  assert.equal(new Set(chartOfTriangle).size, 2);
  for (const Kind of [Uint8Array, Uint16Array, Int32Array]) {
    const other = {
      ...mesh,
      materials: Kind.from(materials),
      texcoords: Int8Array.from(texcoords),
    };
    const result = await abflat.unwrap(other, { seams: 'material' });
    assert.deepEqual(result.chartOfTriangle, chartOfTriangle);
  }
});

test('without indices each three vertices are a triangle', async () => {
  const { positions, indices } = arraysOf(sphere(6));
  const soup = new Float32Array(3 * indices.length);
  indices.forEach((vertex, c) => {
    soup.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * c);
  });
  const inOrder = Uint32Array.from({ length: indices.length }, (_, c) => c);
  const wanted = await abflat.unwrap({ positions: soup, indices: inOrder });
  assert.ok(wanted.report.valid);
  for (const nothing of [{}, { indices: undefined }, { indices: null }]) {
    const result = await abflat.unwrap({ positions: soup, ...nothing });
    assert.deepEqual(result.uv, wanted.uv);
    assert.deepEqual(result.indices, wanted.indices);
  }
  assert.equal((await abflat.inspect({ positions: soup })).faces, indices.length / 3);
});
