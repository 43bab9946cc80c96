// The helper for three.js.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { toBufferGeometry } from 'abflat/three';
import { bytesOf, grid, objText } from './support/meshes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

test('arrays: positions come from the mesh through vertexMap', async () => {
  const { positions, indices } = grid(5);
  const mesh = {
    positions: Float64Array.from([9, 9, 9, ...positions]),
    indices: indices.map((v) => v + 1),
  };
  const result = await abflat.flatten(mesh);
  const geometry = toBufferGeometry(result, mesh, { normalize: false });
  assert.deepEqual([...geometry.index.array], [...result.indices]);
  assert.deepEqual(geometry.attributes.uv.array, Float32Array.from(result.uv));
  assert.equal(geometry.attributes.uv.itemSize, 2);
  const { array } = geometry.attributes.position;
  result.vertexMap.forEach((vertex, i) => {
    const expected = Float32Array.from(mesh.positions.subarray(3 * vertex, 3 * vertex + 3));
    assert.deepEqual(array.subarray(3 * i, 3 * i + 3), expected);
  });
});

test('files: positions come with the result', async () => {
  const mesh = grid(4);
  const result = await abflat.flatten({ bytes: bytesOf(objText(mesh)), name: 'a.obj' });
  const { position } = toBufferGeometry(result).attributes;
  assert.deepEqual(position.array, Float32Array.from(mesh.positions));
});

/** A band of six quads round a hole whose ends meet in one vertex of the inner rim but not in the outer rim. */
function pinchedBand() {
  const at = (radius, degrees) => {
    const angle = (degrees * Math.PI) / 180;
    return [radius * Math.cos(angle), radius * Math.sin(angle), 0];
  };
  const inner = Array.from({ length: 6 }, (_, k) => at(1, 60 * k));
  const outer = Array.from({ length: 7 }, (_, k) => at(2, 55 * k));
  const indices = Array.from({ length: 6 }, (_, k) => {
    const [i, j, o, p] = [k, (k + 1) % 6, 6 + k, 7 + k];
    return [i, o, p, i, p, j];
  });
  return {
    positions: Float64Array.from([...inner, ...outer].flat()),
    indices: Uint32Array.from(indices.flat()),
  };
}

test('a vertex where the surface touches itself is there once for each side', async () => {
  const mesh = pinchedBand();
  // Convex: the two sides cannot stay together.
  const result = await abflat.flatten(mesh, { t: 1 });
  assert.deepEqual(
    [...result.vertexMap].sort((a, b) => a - b),
    [0, ...Array(13).keys()],
  );
  const { position, uv } = toBufferGeometry(result, mesh).attributes;
  assert.equal(position.count, 14);
  assert.equal(uv.count, 14);
  const [a, b] = [...result.vertexMap.keys()].filter((v) => result.vertexMap[v] === 0);
  assert.deepEqual([position.getX(a), position.getY(a)], [position.getX(b), position.getY(b)]);
  assert.notDeepEqual([uv.getX(a), uv.getY(a)], [uv.getX(b), uv.getY(b)]);
});

test('normalize fits the layout into the unit square without distorting it', async () => {
  const mesh = grid(6);
  const result = await abflat.flatten(mesh);
  const { array } = toBufferGeometry(result, mesh, { normalize: true }).attributes.uv;
  const [us, vs] = [0, 1].map((k) => [...array].filter((_, i) => i % 2 === k));
  const [least, most] = [Math.min(...us, ...vs), Math.max(...us, ...vs)];
  assert.ok(least >= 0 && most <= 1, `${least} to ${most}`);
  assert.equal(most, 1);
  const scale = (array[2] - array[0]) / (result.uv[2] - result.uv[0]);
  array.forEach((value, i) => {
    const expected = array[i % 2] + scale * (result.uv[i] - result.uv[i % 2]);
    assert.ok(Math.abs(value - expected) < 1e-5);
  });
});

test('without a mesh, arrays are refused', async () => {
  const result = await abflat.flatten(grid(2));
  assert.throws(() => toBufferGeometry(result), /mesh/);
});
