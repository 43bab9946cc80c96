// The islands of a file as charts, and the tiles that they get.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { UV_FAULT } from 'abflat';
import { loadModule as load } from './modules.mjs';

const NONE = 2 ** 32 - 1;

/** Two triangles of an island, one of another that shares a vertex, and one without uv. */
const SHARED = {
  uv: Float64Array.of(0, 0, 0.5, 0, 0.5, 0.5, 0, 0.5, 1, 0.5, 0, 0),
  positions: Float64Array.of(0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 3, 1, 0, 4, 4, 4),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 1, 2, 4, 3, 2, 5),
  vertexMap: Uint32Array.of(0, 1, 2, 3, 4, 5),
  chartOfTriangle: Uint32Array.of(0, 0, 1, NONE),
  faults: Uint8Array.of(UV_FAULT.overlapping, UV_FAULT.overlapping, UV_FAULT.flipped, 0),
};

test('islands that share a vertex have one each, and what is known of them is right', async () => {
  const { fileIslands } = await load('arrange/file-islands');
  const faces = Uint32Array.of(7, 7, 8, 9);
  const { arrays, facts } = fileIslands(SHARED, 2, faces);
  const { uv, indices, vertexMap, positions, chartOfTriangle } = arrays;
  const owners = new Map();
  indices.forEach((v, c) => {
    const chart = chartOfTriangle[Math.floor(c / 3)];
    assert.equal(owners.get(v) ?? chart, chart, 'no vertex belongs to two islands');
    owners.set(v, chart);
    const before = SHARED.indices[c];
    assert.deepEqual(uv.slice(2 * v, 2 * v + 2), SHARED.uv.slice(2 * before, 2 * before + 2));
    assert.deepEqual(
      positions.slice(3 * v, 3 * v + 3),
      SHARED.positions.slice(3 * before, 3 * before + 3),
    );
    assert.equal(vertexMap[v], before);
  });
  const [first, second] = facts;
  assert.deepEqual(
    [first.faces, first.firstFace, first.area, first.mirrored, first.lies],
    [2, 7, 2, false, 'stacked'],
  );
  assert.deepEqual([second.faces, second.firstFace, second.mirrored], [1, 8, true]);
  assert.equal(second.lies, 'apart');
  // Twice as long as wide on the surface, a square in uv.
  assert.ok(Math.abs(first.symmetricDirichlet - 1.25) < 1e-9);
});

test('each part that has an island gets a tile', async () => {
  const { tilesOfParts } = await load('mesh/own-tiles');
  const part = (...runs) => ({ runs });
  const islands = Uint32Array.of(0, 0, 1, NONE, 2, 2);
  const parts = [part([0, 2]), part([3, 1]), part([2, 1], [4, 2])];
  assert.deepEqual([...tilesOfParts(parts, islands, 3)], [0, 1, 1]);
  assert.deepEqual([...tilesOfParts([], islands, 3)], [0, 0, 0]);
  const stack = [[0, 1, 2]];
  assert.deepEqual([...tilesOfParts(parts, islands, 3, stack)], [0, 0, 0], 'and leave none empty');
});

test('the tile of an island is that of its middle, or the nearest', async () => {
  const { movedApart, tileAt, tilesOfFile } = await load('mesh/own-tiles');
  assert.deepEqual(
    [tileAt(0.5, 0.5), tileAt(2.5, 0), tileAt(1.1, 3.2), tileAt(-4, 0), tileAt(40, 1)],
    [0, 2, 31, 0, 19],
  );
  const corners = Float64Array.of(1.8, 0, 2.6, 0, 2.6, 0.5, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0);
  const islands = Uint32Array.of(0, 1, NONE);
  assert.deepEqual([...tilesOfFile(corners, islands, 2)], [2, 0]);
  // By more than all is wide, so that nothing lies on anything else.
  const apart = movedApart(corners, islands, Uint32Array.of(0, 1));
  assert.deepEqual([...apart.subarray(0, 6)], [...corners.subarray(0, 6)]);
  assert.deepEqual([...apart.subarray(6, 12)], [4, 0, 5, 0, 4, 1]);
  assert.deepEqual([...apart.subarray(12)], [0, 0, 0, 0, 0, 0]);
});
