// vertexObjects: which vertices may be joined.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { grid } from './support/meshes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

/** Two grids side by side, with vertices of their own on the side that they have in common. */
function neighbours() {
  const { positions, indices } = grid(4);
  const count = positions.length / 3;
  const besides = positions.map((x, i) => (i % 3 === 0 ? 2 - x : x));
  const turned = indices.map((_, c) => indices[c % 3 === 0 ? c : c % 3 === 1 ? c + 1 : c - 1]);
  return {
    positions: Float64Array.from([...positions, ...besides]),
    indices: Uint32Array.from([...indices, ...turned.map((v) => v + count)]),
    ofObjects: Uint16Array.from({ length: 2 * count }, (_, v) => (v < count ? 3 : 1)),
  };
}

test('objects that touch are apart; without objects, or in one, they are joined', async () => {
  const { positions, indices, ofObjects } = neighbours();
  const merged = async (vertexObjects) => {
    const mesh = { positions, indices, ...(vertexObjects && { vertexObjects }) };
    const { report, chartOfTriangle } = await abflat.unwrap(mesh, { resolution: 256 });
    assert.ok(report.valid);
    const half = chartOfTriangle.length / 2;
    const [first, second] = [chartOfTriangle.slice(0, half), chartOfTriangle.slice(half)];
    return [report.repair.mergedVertices, first.some((chart) => second.includes(chart))];
  };
  assert.deepEqual(await merged(undefined), [5, true]);
  assert.deepEqual(await merged(ofObjects.map(() => 7)), [5, true]);
  assert.deepEqual(await merged(ofObjects), [0, false]);
  assert.deepEqual(await merged([...ofObjects]), [0, false]);
  assert.equal(ofObjects[0], 3, 'what was passed stays');
});
