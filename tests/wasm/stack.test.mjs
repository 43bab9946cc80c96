// Parts of equal shape share their place in the atlas of the package, too.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { turn } from '../support/exact-atlas.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

/** A pyramid whose base has four different sides. */
const BASE = [
  [0, 0, 0],
  [3, 0, 0],
  [2, 2, 0],
  [0, 1, 0],
  [1, 1, 2],
];
const FACES = [
  [0, 1, 4],
  [1, 2, 4],
  [2, 3, 4],
  [3, 0, 4],
  [0, 2, 1],
  [0, 3, 2],
];

/** Copies side by side, turned by quarters, every second one mirrored. */
function pyramids(count) {
  const positions = [];
  const indices = [];
  for (let i = 0; i < count; i++) {
    const isMirrored = i % 2 === 1;
    for (let [x, y, z] of BASE) {
      if (isMirrored) x = -x;
      for (let k = 0; k < i; k++) [x, y] = [-y, x];
      positions.push(x + 10 * i, y, z);
    }
    for (const [a, b, c] of FACES) {
      const face = isMirrored ? [c, b, a] : [a, b, c];
      indices.push(...face.map((v) => v + BASE.length * i));
    }
  }
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

const trianglesOf = ({ uv, indices, chartOfTriangle }, chart) =>
  [...chartOfTriangle.keys()]
    .filter((f) => chartOfTriangle[f] === chart)
    .map((f) => [0, 1, 2].map((k) => [0, 1].map((d) => uv[2 * indices[3 * f + k] + d])));

const formOf = (triangles) => triangles.map((t) => t.map(String).sort().join(' ')).sort();

for (const stack of ['identical', 'mirrored'])
  test(`${stack} charts have the same coordinates, bit by bit`, async () => {
    const mesh = pyramids(6);
    const apart = await abflat.unwrap(mesh);
    const result = await abflat.unwrap(mesh, { stack });
    const { charts, atlas, valid, options } = result.report;
    assert.ok(valid);
    assert.equal(options.stack, stack);
    assert.ok(atlas.stacked.charts >= (stack === 'mirrored' ? 5 : 4));
    assert.equal(atlas.stacked.mirrored > 0, stack === 'mirrored');
    assert.ok(atlas.texelDensity > 1.4 * apart.report.atlas.texelDensity);
    for (const [c, { stackedOn, mirrored }] of charts.entries()) {
      const own = trianglesOf(result, c);
      const before = trianglesOf({ ...result, uv: result.unpacked }, c);
      assert.ok(own.every((triangle) => turn(...triangle) === (mirrored ? -1 : 1)));
      assert.ok(before.every((triangle) => turn(...triangle) === 1));
      if (stackedOn >= 0) assert.deepEqual(formOf(own), formOf(trianglesOf(result, stackedOn)));
    }
  });

test('a known layout with stacks stays, is packed again, or is taken apart', async () => {
  const mesh = pyramids(4);
  const first = await abflat.unwrap(mesh, { stack: 'mirrored' });
  const seams = { seams: 'none', seamEdges: first.seams };
  const kept = await abflat.unwrap(mesh, {
    ...seams,
    stack: 'mirrored',
    known: first,
    keepsPlaces: true,
  });
  assert.ok(kept.report.valid);
  assert.deepEqual(kept.uv, first.uv);
  assert.deepEqual(kept.report.atlas.stacked, first.report.atlas.stacked);
  const packed = await abflat.unwrap(mesh, { ...seams, stack: 'mirrored', known: first });
  assert.deepEqual(packed.report.atlas.stacked, first.report.atlas.stacked);
  const apart = await abflat.unwrap(mesh, { ...seams, known: first });
  assert.ok(apart.report.valid);
  assert.equal(apart.report.atlas.stacked.charts, 0);
  assert.ok(apart.report.charts.every(({ solver }) => solver === 'known'));
});

test('a value that does not exist is refused', async () => {
  await assert.rejects(abflat.unwrap(pyramids(1), { stack: 'all' }), {
    code: 'InvalidOption',
    message: /stack.*none, identical.*mirrored/,
  });
});
