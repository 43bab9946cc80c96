// A layout in formats that its mesh did not come in: the same coordinates, bit by bit, and nothing is laid out again.

import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { createAbflat, FLATTEN_DEFAULTS, UNWRAP_DEFAULTS } from 'abflat';
import { parseObj } from '../support/atlas.mjs';
import { assertValidFile, atlasOf, flaws, io, primitivesOf } from '../support/gltf.mjs';
import { column, elementOf, parsePly } from '../support/ply.mjs';
import { grid } from '../support/small-meshes.mjs';
import { knot, objText, sphere } from '../support/surfaces.mjs';
import { loadModule } from './modules.mjs';

const { writeAgain } = await loadModule('session/write-again');
const { layOut } = await loadModule('session/lay-out');
const { newGlb } = await loadModule('files/new-glb');

const abflat = await createAbflat();
after(() => abflat.terminate());

const { signal } = new AbortController();
const UNWRAP = { mode: 'unwrap', ...UNWRAP_DEFAULTS, seams: 'auto' };
const FLATTEN = { mode: 'flatten', ...FLATTEN_DEFAULTS, balance: 0.2 };

async function laidOut(name, text, settings) {
  const input = { bytes: Buffer.from(text), name };
  const mesh = await abflat.load(input);
  const opened = { source: { kind: 'file', name }, input, mesh };
  return { input, outcome: await layOut(abflat, opened, settings, null, { signal }) };
}

const again = ({ input, outcome }, format) => writeAgain(abflat, input, outcome, format, signal);

/** The [u, v] of each corner of a face. */
function cornersOfObj(bytes) {
  const { texcoords, faces } = parseObj(new TextDecoder().decode(bytes));
  return faces.flat().map(([, t]) => texcoords[t]);
}

function cornersOfPly(bytes) {
  const file = parsePly(Buffer.from(bytes));
  const uv = column(elementOf(file, 'vertex'), 's', 't');
  return column(elementOf(file, 'face'), 'vertex_indices').flatMap((face) =>
    face.map((v) => uv[v]),
  );
}

async function documentOf({ outcome }) {
  const { uv, indices, positions } = outcome.result;
  const blob = await newGlb('ball', { uv, indices }, positions);
  return io.readBinary(new Uint8Array(await blob.arrayBuffer()));
}

for (const [what, name, text, settings] of [
  ['an atlas', 'ball.obj', objText(sphere(8)), UNWRAP],
  [
    'an atlas in tiles',
    'knot.obj',
    objText(knot(60, 8)),
    { ...UNWRAP, udim: true, texelDensity: 300 },
  ],
  ['a mesh in one piece', 'waves.obj', grid(8), FLATTEN],
])
  test(`${what} is written in every format, and in its own with the same bytes`, async () => {
    const made = await laidOut(name, text, settings);
    for (const format of ['obj', 'ply', 'glb'])
      assert.equal((await again(made, format)).isValid, true, format);
    assert.deepEqual((await again(made, 'obj')).obj, made.outcome.result.obj);
  });

test('OBJ and PLY have the same UVs at each corner, to the last digit', async () => {
  const made = await laidOut('ball.obj', objText(sphere(8)), UNWRAP);
  const { ply } = await again(made, 'ply');
  assert.deepEqual(cornersOfPly(ply), cornersOfObj(made.outcome.result.obj));
  const back = await laidOut('ball.ply', ply, UNWRAP);
  assert.deepEqual(
    cornersOfObj((await again(back, 'obj')).obj),
    cornersOfPly(back.outcome.result.ply),
  );
});

test('a GLB of a mesh that is no glTF is valid, and its UVs overlap nowhere', async () => {
  const made = await laidOut('ball.obj', objText(sphere(8)), UNWRAP);
  const document = await documentOf(made);
  await assertValidFile(document);
  const [primitive, ...others] = primitivesOf(document);
  assert.deepEqual(others, []);
  assert.equal(primitive.getMaterial().getName(), 'ball');
  const { uv, indices, positions } = made.outcome.result;
  assert.deepEqual([...primitive.getIndices().getArray()], [...indices]);
  assert.deepEqual(primitive.getAttribute('POSITION').getArray(), Float32Array.from(positions));
  assert.deepEqual(
    primitive.getAttribute('TEXCOORD_0').getArray(),
    Float32Array.from(uv, (x, i) => (i % 2 === 0 ? x : 1 - x)),
    'v of a glTF points down',
  );
  assert.deepEqual(flaws(atlasOf([primitive])), []);
});

test('a GLB of a mesh far from the origin keeps its shape', async () => {
  const made = await laidOut('ball.obj', objText(sphere(8)), UNWRAP);
  const { uv, indices, positions } = made.outcome.result;
  const far = positions.map((x, i) => x + [5412345.75, 0.25, -3e8][i % 3]);
  const blob = await newGlb('ball', { uv, indices }, far);
  const document = await io.readBinary(new Uint8Array(await blob.arrayBuffer()));
  await assertValidFile(document);
  const [node] = document.getRoot().listNodes();
  const translation = node.getTranslation();
  assert.deepEqual(translation, translation.map(Math.fround));
  assert.equal(translation[1], 0);
  const own = primitivesOf(document)[0].getAttribute('POSITION').getArray();
  const error = own.map((x, i) => Math.abs(x + translation[i % 3] - far[i]));
  assert.ok(Math.max(...error) < 1e-6, `${Math.max(...error)}`);
});

test('what a GLB cannot hold is said', async () => {
  const made = await laidOut('ball.obj', objText(sphere(4)), UNWRAP);
  const { uv, indices, positions } = made.outcome.result;
  await assert.rejects(
    newGlb(
      'ball',
      { uv, indices },
      positions.map((x) => 1e39 * x),
    ),
    {
      message: /too large for GLB\. Scale the mesh down, or choose OBJ/,
    },
  );
});

test('a layout that is not valid is written as it is', async () => {
  const mesh = await abflat.sample('alpha-band');
  const source = { kind: 'sample', name: 'alpha-band' };
  const settings = { ...FLATTEN, t: 2 };
  const outcome = await layOut(abflat, { source, input: mesh, mesh }, settings, null, { signal });
  assert.equal(outcome.result.report.valid, false);
  const written = await again({ input: mesh, outcome }, 'ply');
  assert.equal(written.isValid, false);
  assert.deepEqual(cornersOfPly(written.ply), cornersOfObj(outcome.result.obj));
});

test('a file with other coordinates is refused', async () => {
  const made = await laidOut('ball.obj', objText(sphere(4)), UNWRAP);
  const liar = {
    unwrap: async (...call) => {
      const result = await abflat.unwrap(...call);
      result.uv[0] += 2 ** -40;
      return result;
    },
  };
  await assert.rejects(writeAgain(liar, made.input, made.outcome, 'ply', signal), {
    message: /gave a different layout/,
  });
});
