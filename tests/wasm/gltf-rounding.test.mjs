// Charts of documents are checked with the coordinates that the document holds.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { unwrap } from 'abflat/gltf';
import {
  addMesh,
  atlasOf,
  emptyDocument,
  flaws,
  primitiveOf,
  primitivesOf,
  reread,
} from '../support/gltf.mjs';
import { sphere } from '../support/surfaces.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** A square with `n` rows of quads whose height halves towards one side. */
function halving(n) {
  const heights = Array.from({ length: n }, (_, i) => 2 ** -i);
  const positions = [...heights, 0].flatMap((y) => [
    [0, y, 0],
    [1, y, 0],
  ]);
  const faces = heights.flatMap((_, i) => [
    [2 * i, 2 * i + 2, 2 * i + 3],
    [2 * i, 2 * i + 3, 2 * i + 1],
  ]);
  return { positions, faces };
}

/** Nested squares, each a quarter of the size of the previous one. */
function nested(n) {
  const positions = Array.from({ length: n }, (_, i) => 4 ** -i).flatMap((s) => [
    [s, s, 0],
    [-s, s, 0],
    [-s, -s, 0],
    [s, -s, 0],
  ]);
  const faces = Array.from({ length: 4 * (n - 1) }, (_, a) => {
    const b = a % 4 === 3 ? a - 3 : a + 1;
    return [
      [a, b, b + 4],
      [a, b + 4, a + 4],
    ];
  }).flat();
  const last = 4 * (n - 1);
  faces.push([last, last + 1, last + 2], [last, last + 2, last + 3]);
  return { positions, faces };
}

async function unwrapped(surface, options) {
  const document = emptyDocument();
  addMesh(document, 'mesh', primitiveOf(document, surface));
  const atlases = [];
  await document.transform(unwrap(abflat, { ...options, onAtlas: (a) => atlases.push(a) }));
  const [{ result }] = atlases;
  return { result, held: atlasOf(primitivesOf(await reread(document))) };
}

/** Corners of a result's triangles, in the form that `atlasOf` returns for a document. */
const cornersOf = ({ uv, indices }) =>
  Array.from({ length: indices.length / 3 }, (_, t) =>
    Array.from(indices.subarray(3 * t, 3 * t + 3), (v) => [uv[2 * v], uv[2 * v + 1]]),
  );

for (const [name, isValid, surface, options] of [
  ['packed', true, sphere(6), {}],
  [
    'pinned where v has no fewer digits than u',
    true,
    halving(3),
    {
      pins: [
        { vertex: 0, uv: [0.1, 0.7] },
        { vertex: 1, uv: [0.3, 0.71] },
      ],
    },
  ],
  ['moved to what single precision holds', true, nested(14), {}],
  ['cut where faces of very different size meet', true, nested(18), {}],
  ['finer than single precision', false, nested(18), { seams: 'none' }],
  [
    'pinned where single precision is fine, but not with v from the top',
    false,
    halving(3),
    {
      pins: [
        { vertex: 6, uv: [1e-7, 0] },
        { vertex: 7, uv: [2e-7, 1e-8] },
      ],
    },
  ],
])
  test(`the report is about what the document holds: ${name}`, async () => {
    const { result, held } = await unwrapped(surface, options);
    assert.deepEqual(held, cornersOf(result));
    assert.equal(result.report.valid, isValid);
    assert.equal(isValid, flaws(held).length === 0, flaws(held).join('\n'));
  });

test('a chart that single precision breaks is valid only where it does not end up in it', async () => {
  const { positions, faces } = nested(18);
  const mesh = {
    positions: Float64Array.from(positions.flat()),
    indices: Uint32Array.from(faces.flat()),
  };
  const [exact, rounded] = await Promise.all(
    [false, true].map((roundsForGltf) => abflat.unwrap(mesh, { roundsForGltf, seams: 'none' })),
  );
  assert.deepEqual([exact.report.valid, rounded.report.valid], [true, false]);
  assert.ok(exact.report.notes.some((note) => /in double precision/.test(note)));
  assert.deepEqual(rounded.report.notes, []);
});
