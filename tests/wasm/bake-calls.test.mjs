// Calls of bake: what they refuse and in which words, their progress, and how they end early.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { AbflatError, createAbflat } from 'abflat';
import { oneColour, SQUARE, waves } from './support/bake.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const image = oneColour(1, 2, 3);
const layout = { uv: SQUARE.texcoords };
const source = { image };
const { texcoords: _, ...bare } = SQUARE;

const REFUSED = [
  ['no mesh', [null, layout, source], 'InvalidMesh', /must be \{ positions, indices, texcoords \}/],
  ['no texcoords', [bare, layout, source], 'InvalidMesh', /no texcoords.*old images/],
  [
    'no layout',
    [SQUARE, [0, 1], source],
    'InvalidMesh',
    /layout must be \{ uv, indices, vertexMap/,
  ],
  ['uv of a wrong type', [SQUARE, { uv: 'uv' }, source], 'InvalidMesh', /uv must be an array/],
  [
    'a vertexMap that is too short',
    [SQUARE, { ...layout, vertexMap: [0, 1] }, source],
    'InvalidMesh',
    /vertexMap has 2 elements, not 4/,
  ],
  [
    'a layout of another mesh',
    [SQUARE, { ...layout, indices: [0, 1, 2, 3, 2, 1] }, source],
    'InvalidMesh',
    /triangle 1 of the layout has other vertices/,
  ],
  [
    'a vertex that does not exist',
    [SQUARE, { ...layout, indices: [0, 1, 2, 0, 2, 4] }, source],
    'InvalidMesh',
    /triangle 1 of the layout refers to vertex 4, but there are only 4/,
  ],
  [
    'a vertex of the mesh that does not exist',
    [{ ...SQUARE, indices: [0, 1, 9, 0, 2, 3] }, { uv: SQUARE.texcoords }, source],
    'InvalidMesh',
    /triangle 0 of the mesh refers to vertex 9/,
  ],
  [
    'a vertexMap beyond the mesh',
    [SQUARE, { ...layout, vertexMap: [0, 1, 2, 7] }, source],
    'InvalidMesh',
    /triangle 1 of the layout has other vertices/,
  ],
  [
    'uv that are not finite',
    [SQUARE, { uv: SQUARE.texcoords.map((x) => x / 0) }, source],
    'InvalidMesh',
    /triangle 0 has uv that are not finite/,
  ],
  ...['positions', 'normals', 'texcoords'].map((name) => [
    `${name} that are not finite, for a normal map`,
    [
      { ...SQUARE, [name]: SQUARE[name].map((x, i) => (i === 7 ? x / 0 || 1 / 0 : x)) },
      layout,
      source,
      { kind: 'normal' },
    ],
    'InvalidMesh',
    /vertex [23] has a (position|normal|texcoord) that is not finite/,
  ]),
  [
    'a material without a source',
    [{ ...SQUARE, materials: [0, 3] }, layout, [source]],
    'InvalidMesh',
    /triangle 1 uses source 3, but there is only 1 source/,
  ],
  [
    'too few colours',
    [{ ...SQUARE, colours: [1] }, layout, source],
    'InvalidMesh',
    /colours.*not 16/,
  ],
  [
    'colours that are not finite',
    [{ ...SQUARE, colours: Array(16).fill(Number.NaN) }, layout, source],
    'InvalidMesh',
    /triangle 0 has colours that are not finite/,
  ],
  ['too few tangents', [{ ...SQUARE, tangents: [1] }, layout, source], 'InvalidMesh', /tangents/],
  ['too few parts', [{ ...SQUARE, parts: [1] }, layout, source], 'InvalidMesh', /parts.*not 2/],
  ['no source', [SQUARE, layout, []], 'InvalidOption', /at least one source/],
  ['an image as a source', [SQUARE, layout, image], 'InvalidOption', /no option "sources.data"/],
  [
    'a source with an unknown key',
    [SQUARE, layout, [source, { wrap: 'clamp' }]],
    'InvalidOption',
    /no option "sources\[1\]\.wrap"/,
  ],
  [
    'pixels that are missing',
    [SQUARE, layout, { image: { ...image, width: 5 } }],
    'InvalidOption',
    /image\.data has 64 bytes, not 80: 4 for each of 5 x 4 pixels/,
  ],
  [
    'a side that is no number',
    [SQUARE, layout, { image: { ...image, height: 'four' } }],
    'InvalidOption',
    /image\.height must be a whole number of pixels from 1, not "four"/,
  ],
  [
    'pixels of 32 bits',
    [SQUARE, layout, { image: { ...image, data: new Float32Array(64) } }],
    'InvalidOption',
    /image\.data must be a Uint8ClampedArray or Uint8Array, not Float32Array/,
  ],
  [
    'an unknown wrap',
    [SQUARE, layout, { image, wrapU: 'mirrored' }],
    'InvalidOption',
    /wrapU must be one of repeat, mirror, clamp, not "mirrored"/,
  ],
  ['a short factor', [SQUARE, layout, { factor: [1, 1] }], 'InvalidOption', /array of 4 numbers/],
  ['an unknown kind', [SQUARE, layout, source, { kind: 'color' }], 'InvalidOption', /colour, data/],
  [
    'a resolution that is too small',
    [SQUARE, layout, source, { bakeResolution: 8 }],
    'InvalidOption',
    /bakeResolution must be a number at least 16/,
  ],
  ['an unknown option', [SQUARE, layout, source, { size: 8 }], 'InvalidOption', /no option "size"/],
];

for (const [what, given, code, pattern] of REFUSED)
  test(`${what}: refused in a sentence`, async () => {
    await assert.rejects(abflat.bake(...given), (error) => {
      assert.ok(error instanceof AbflatError, `${error.stack}`);
      assert.equal(error.code, code, error.message);
      assert.match(error.message, pattern);
      return true;
    });
    const { data } = await abflat.bake(SQUARE, layout, source);
    assert.deepEqual([...data.subarray(0, 4)], [1, 2, 3, 255]);
  });

test('progress grows to 1', async () => {
  const fractions = [];
  const stages = new Set();
  await abflat.bake(SQUARE, layout, source, {
    bakeResolution: 1024,
    onProgress: ({ stage, fraction }) => {
      stages.add(stage);
      fractions.push(fraction);
    },
  });
  assert.deepEqual([...stages], ['read', 'write']);
  assert.ok(fractions.every((each, i) => i === 0 || each >= fractions[i - 1]));
  assert.equal(fractions.at(-1), 1);
});

test('aborting rejects with the reason, and the next call works', async () => {
  const controller = new AbortController();
  const reason = new Error('enough');
  const call = abflat.bake(
    SQUARE,
    layout,
    { image: waves(512) },
    {
      bakeResolution: 8192,
      signal: controller.signal,
      onProgress: () => controller.abort(reason),
    },
  );
  await assert.rejects(call, reason);
  await assert.rejects(
    abflat.bake(SQUARE, layout, source, { signal: AbortSignal.abort(reason) }),
    reason,
  );
  assert.equal((await abflat.bake(SQUARE, layout, source)).width, 16);
});

test('a listener that throws ends its call', async () => {
  const failed = new Error('of the listener');
  const onProgress = () => {
    throw failed;
  };
  await assert.rejects(abflat.bake(SQUARE, layout, source, { onProgress }), failed);
});

test('images that do not fit into memory are refused, and smaller ones work', async () => {
  const small = await createAbflat({ maxMemory: 2 ** 25 });
  await assert.rejects(small.bake(SQUARE, layout, { image: waves(64) }, { bakeResolution: 4096 }), {
    code: 'OutOfMemory',
    message: /not enough memory for this image.*smaller bakeResolution, or a larger maxMemory/,
  });
  assert.equal((await small.bake(SQUARE, layout, source)).width, 16);
  small.terminate();
});

test('terminate ends calls, and refuses later ones', async () => {
  const own = await createAbflat();
  const call = own.bake(SQUARE, layout, { image: waves(512) }, { bakeResolution: 8192 });
  own.terminate();
  await assert.rejects(call, { name: 'AbortError' });
  await assert.rejects(own.bake(SQUARE, layout, source), { name: 'AbortError' });
});

test('a file that is not the module is named', async () => {
  const own = await createAbflat({ bakeUrl: new URL('./nowhere.wasm', import.meta.url) });
  const failed = { code: 'UnreadableFile', lost: 'module', message: /nowhere\.wasm/ };
  await assert.rejects(own.bake(SQUARE, layout, source), failed);
  await assert.rejects(own.bake(SQUARE, layout, source), failed, 'and again');
  assert.equal((await own.inspect(bare)).triangles, 2);
  own.terminate();
  const main = new URL('./abflat-simd.wasm', import.meta.resolve('abflat'));
  const other = await createAbflat({ bakeUrl: main });
  await assert.rejects(other.bake(SQUARE, layout, source), {
    code: 'UnreadableFile',
    message: /bakeUrl is not the module of this version of abflat that bakes/,
  });
  other.terminate();
});
