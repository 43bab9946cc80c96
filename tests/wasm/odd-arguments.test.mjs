// Wrong arguments are rejected in the package's own words, not the engine's.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { AbflatError, createAbflat } from 'abflat';
import { unwrap as unwrapTransform } from 'abflat/gltf';
import { unwrapGeometry } from 'abflat/three';
import { BufferAttribute, BufferGeometry } from 'three';
import { accessor, addMesh, emptyDocument, io } from '../support/gltf.mjs';
import { madePng } from '../support/made-png.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';
import { oneColour, SQUARE } from './support/bake.mjs';
import { bytesOf, grid, objText } from './support/meshes.mjs';
import { assertFails } from './support/unwrapping.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const fails = (call, code, pattern) => assertFails(abflat, call, code, pattern);

function detached(array) {
  structuredClone(array.buffer, { transfer: [array.buffer] });
  return array;
}

function documentOfGrid() {
  const { positions, indices } = grid(2);
  const document = emptyDocument();
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor(document, 'VEC3', Float32Array.from(positions)))
    .setIndices(accessor(document, 'SCALAR', Uint16Array.from(indices)));
  addMesh(document, 'grid', primitive);
  return document;
}

const TEXTURED = texturedGlb([texturedCube()], oneTexture(madePng(8, 8, () => [9, 9, 0])));
const SQUARE_LAYOUT = { uv: SQUARE.texcoords };

function cyclic() {
  const value = {};
  value.self = value;
  return value;
}

/** Values that cannot be converted to text, or whose text says nothing. */
const ODD = [5n, Symbol('odd'), cyclic(), Object.create(null), [5n], () => 1, new Map()];

test('an option of any type is refused by its name', async () => {
  for (const value of ODD)
    for (const [method, name] of [
      ['flatten', 't'],
      ['flatten', 'untangle'],
      ['unwrap', 'padding'],
      ['unwrap', 'fillHoles'],
      ['unwrap', 'rotate'],
    ])
      await fails(
        abflat[method](grid(2), { [name]: value }),
        'InvalidOption',
        new RegExp(`^${name} must be`),
      );
  for (const name of ['build', 'maxMemory', 'baseUrl', 'wasmUrl', 'workerUrl'])
    for (const value of ODD)
      await fails(createAbflat({ [name]: value }), 'InvalidOption', /must be/);
  await fails(createAbflat({ baseUrl: 'http://[' }), 'InvalidOption', /baseUrl is not a valid URL/);
});

test('messages do not end in [object Object]', async () => {
  await fails(abflat.unwrap(grid(2), { padding: {} }), 'InvalidOption', /of the type Object\.$/);
  await fails(abflat.unwrap(grid(2), { padding: 5n }), 'InvalidOption', /not 5n\.$/);
});

test('an array that was transferred is refused by its name', async () => {
  const { positions, indices } = grid(2);
  const lost = /has lost its memory/;
  const gone = () => detached(positions.slice());
  await fails(abflat.unwrap({ positions: gone(), indices }), 'InvalidMesh', lost);
  await fails(
    abflat.unwrap({ positions: gone(), indices }, { transfer: true }),
    'InvalidMesh',
    lost,
  );
  await fails(
    abflat.flatten({ positions, indices: detached(indices.slice()) }),
    'InvalidMesh',
    lost,
  );
  const bytes = detached(bytesOf(objText(grid(2))).slice());
  await fails(abflat.unwrap({ bytes }), 'InvalidMesh', lost);
  await fails(abflat.inspect({ bytes: bytes.buffer }), 'InvalidMesh', lost);
  for (const name of ['seamEdges', 'fixedFaces', 'fixedCharts'])
    await fails(
      abflat.unwrap(grid(2), { [name]: detached(new Uint32Array(2)) }),
      'InvalidMesh',
      new RegExp(`${name} has lost`),
    );
  await fails(
    abflat.unwrap(grid(2), { faceDensities: detached(new Float32Array(2)) }),
    'InvalidMesh',
    /faceDensities has lost/,
  );
  const known = await abflat.unwrap(grid(2));
  detached(known.unpacked);
  await fails(abflat.unwrap(grid(2), { known }), 'InvalidMesh', /known\.unpacked has lost/);
});

/** Makes `get` a getter of the object. */
const withGetter = (object, name, get) =>
  Object.defineProperty(object, name, { get, enumerable: true });

const OF_ARRAYS = ['positions', 'indices', 'texcoords', 'normals', 'cornerNormals', 'materials'];
OF_ARRAYS.push('vertexObjects');

test('a getter that transfers an array away leaves a mesh that is refused', async () => {
  const names = OF_ARRAYS;
  const make = () => ({
    ...grid(2),
    texcoords: new Float64Array(18),
    normals: new Float64Array(27),
    cornerNormals: new Float64Array(72),
    materials: new Uint32Array(8),
    vertexObjects: new Uint32Array(9),
  });
  const takes = (array, value) => () => {
    if (array.byteLength > 0) detached(array);
    return value;
  };
  for (const taken of names)
    for (const name of names.filter((other) => other !== taken)) {
      const [mesh, other] = [make(), make()];
      const values = mesh[name];
      withGetter(mesh, name, takes(mesh[taken], values));
      other[name] = withGetter(Array.from(values), 0, takes(other[taken], values[0]));
      await fails(abflat.unwrap(mesh), 'InvalidMesh', /lost its memory/);
      await fails(abflat.unwrap(other), 'InvalidMesh', /lost its memory|elements, not/);
    }
  const mesh = make();
  const options = withGetter({ transfer: true }, 'padding', takes(mesh.positions, 2));
  await fails(abflat.unwrap(mesh, options), 'InvalidMesh', /lost its memory/);
});

/** All options, as the refusal of an unknown one lists them, and what else callers' objects have. */
async function fieldNames() {
  const refusals = [
    createAbflat({ nothing: 1 }),
    ...['flatten', 'unwrap', 'compare', 'inspect'].map((method) =>
      abflat[method](grid(2), { nothing: 1 }),
    ),
    abflat.sample('head', { nothing: 1 }),
    abflat.bake(SQUARE, SQUARE_LAYOUT, {}, { nothing: 1 }),
    abflat.bake(SQUARE, SQUARE_LAYOUT, { nothing: 1 }),
  ];
  const listed = await Promise.all(
    refusals.map((refusal) =>
      refusal.catch(({ message }) => /options are (.*)\.$/.exec(message)[1].split(', ')),
    ),
  );
  const ofMeshes = [...OF_ARRAYS, 'bytes', 'name'];
  const ofHelpers = ['attribute', 'texcoord', 'overwrite', 'groupBy', 'onAtlas', 'bake'];
  ofHelpers.push('readAttribute', 'readTexcoord', 'ownTexels', 'weights', 'assign', 'preset');
  const ofBaking = ['colours', 'tangents', 'parts', 'vertexMap', 'decode', 'encode'];
  const others = [...ofMeshes, ...ofHelpers, ...ofBaking, 'vertex', 'uv', 'face', 'report'];
  return new Set([...listed.flat(), ...others]);
}

/** What calls with few options return. */
async function usualResults() {
  const first = await abflat.unwrap(grid(2), { resolution: 64 });
  const pins = [0, 8].map((vertex) => ({ vertex, uv: [vertex, vertex] }));
  const { positions, indices } = grid(2);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  const layouts = [
    first,
    await abflat.unwrap(grid(2), { known: first, keepsPlaces: true }),
    await abflat.flatten(grid(2), { pins, bounds: [{ vertex: 0, t: 1 }] }),
    await abflat.flatten(grid(2), { straight: [{ from: 0, to: 2 }] }),
    { ...(await abflat.sample('hemisphere')), uv: [] },
    (await unwrapGeometry(abflat, geometry)).result,
    await abflat.flatten({ bytes: bytesOf(objText(grid(2))) }),
  ];
  const document = documentOfGrid();
  await document.transform(unwrapTransform(abflat));
  const [made] = document.getRoot().listMeshes()[0].listPrimitives();
  const image = oneColour(1, 2, 3);
  const painted = await abflat.bake(SQUARE, SQUARE_LAYOUT, { image });
  const textured = await io.readBinary(TEXTURED);
  const encode = ({ data }) => ({ bytes: new Uint8Array(data), mimeType: 'image/png' });
  await textured.transform(unwrapTransform(abflat, { bake: { decode: () => image, encode } }));
  const [texture] = textured.getRoot().listTextures();
  return [
    [...painted.data],
    [...texture.getImage()],
    ...layouts.map(({ uv, indices }) => [...uv, ...indices]),
    [...made.getAttribute('TEXCOORD_0').getArray()],
  ];
}

test('what every object inherits is no option and no array of a mesh', async () => {
  const expected = await usualResults();
  const names = await fieldNames();
  for (const name of names) Object.prototype[name] = 5;
  const ended = usualResults().finally(() => {
    for (const name of names) delete Object.prototype[name];
  });
  assert.deepEqual(await ended, expected);
  for (const name of [
    'build',
    'maxMemory',
    'baseUrl',
    'wasmUrl',
    'packUrl',
    'bakeUrl',
    'workerUrl',
  ])
    Object.prototype[name] = 5;
  const started = createAbflat().finally(() => {
    for (const name of names) delete Object.prototype[name];
  });
  const own = await started;
  assert.equal((await own.bake(SQUARE, SQUARE_LAYOUT, {}, { bakeResolution: 32 })).width, 32);
  own.terminate();
});

test('a mesh may be an object of a class', async () => {
  class Grid {
    get positions() {
      return grid(2).positions;
    }
    get indices() {
      return grid(2).indices;
    }
  }
  assert.deepEqual((await abflat.unwrap(new Grid())).uv, (await abflat.unwrap(grid(2))).uv);
});

test('a buffer that became smaller than its array is refused', async (context) => {
  if (!ArrayBuffer.prototype.resize) return context.skip('buffers cannot be resized here');
  const buffer = new ArrayBuffer(96, { maxByteLength: 96 });
  const positions = new Float64Array(buffer, 24, 9);
  buffer.resize(32);
  await fails(abflat.unwrap({ positions }), 'InvalidMesh', /positions has lost its memory/);
});

test('holes of arrays count as elements', async () => {
  for (const name of ['pins', 'bounds', 'straight'])
    await fails(
      abflat.flatten(grid(2), { [name]: new Array(3) }),
      'InvalidOption',
      new RegExp(`${name}\\[0\\]`),
    );
});

test('what only says that it is a typed array or a signal is none', async () => {
  const says = (tag) => ({ [Symbol.toStringTag]: tag, length: 9, byteLength: 72 });
  await fails(abflat.unwrap({ positions: says('Float64Array') }), 'InvalidMesh', /positions/);
  await fails(abflat.inspect({ bytes: says('Uint8Array') }), 'InvalidMesh', /bytes/);
  await fails(abflat.inspect(grid(2), { signal: says('AbortSignal') }), 'InvalidOption', /signal/);
  for (const call of ['flatten', 'unwrap', 'pack', 'verify', 'compare', 'inspect'])
    await fails(abflat[call](grid(2), { signal: { aborted: true } }), 'InvalidOption', /signal/);
});

test('pins that are no array are refused beside normalize as well', async () => {
  for (const pins of [null, 5, {}])
    await fails(
      abflat.flatten(grid(2), { normalize: true, pins }),
      'InvalidOption',
      /pins must be an array/,
    );
});

test('the rejection of a listener becomes that of its call', async () => {
  const mine = new Error('of the listener');
  const isMine = (error) => error === mine;
  for (const listener of [
    async () => {
      throw mine;
    },
    () => Promise.reject(mine),
    // biome-ignore lint/suspicious/noThenProperty: a promise of another library
    () => ({ then: (_, reject) => reject(mine) }),
  ]) {
    const options = { onProgress: listener };
    for (const method of ['unwrap', 'flatten', 'compare'])
      await assert.rejects(abflat[method](grid(2), options), isMine, method);
    for (const given of [options, { onAtlas: listener }])
      await assert.rejects(documentOfGrid().transform(unwrapTransform(abflat, given)), isMine);
  }
  // Too late for a call that has its result.
  let reject;
  const late = new Promise((_, refuse) => {
    reject = refuse;
  });
  const result = await abflat.unwrap(grid(2), { onProgress: () => late });
  reject(mine);
  await new Promise((resolve) => setImmediate(resolve));
  assert.deepEqual((await abflat.unwrap(grid(2))).uv, result.uv);
});

test('samples have a detail from 1 to 1000', async () => {
  for (const detail of [1001, 1e300])
    await fails(abflat.sample('head', { detail }), 'InvalidOption', /detail must be at most 1000/);
  assert.ok((await abflat.sample('hemisphere', { detail: 2 })).indices.length > 0);
});

test('abflat/three refuses in the same way', async () => {
  const { positions, indices } = grid(2);
  const make = (index) => {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
    return geometry.setIndex(new BufferAttribute(index, 1));
  };
  const call = (...args) => unwrapGeometry(abflat, ...args);
  await fails(call(null), 'InvalidMesh', /needs a BufferGeometry/);
  await fails(call(new BufferGeometry()), 'InvalidMesh', /position attribute/);
  await fails(call(make(detached(indices.slice()))), 'InvalidMesh', /index.*has lost/);
  for (const options of [null, 5, []])
    await fails(call(make(indices), options), 'InvalidOption', /options must be an object/);
  for (const seams of [5, null, ['uv']])
    await fails(call(make(indices), { seams }), 'InvalidOption', /seams must be a string/);
});

test('a document whose arrays were transferred is refused', async () => {
  const { positions, indices } = grid(2);
  for (const lost of ['positions', 'indices']) {
    const arrays = { positions: Float32Array.from(positions), indices: Uint16Array.from(indices) };
    const document = emptyDocument();
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor(document, 'VEC3', arrays.positions))
      .setIndices(accessor(document, 'SCALAR', arrays.indices));
    addMesh(document, 'grid', primitive);
    detached(arrays[lost]);
    await fails(document.transform(unwrapTransform(abflat)), 'InvalidMesh', /has lost|rows/);
  }
});

test('abflat/gltf refuses in the same way', () => {
  const isInvalid = (error) => error instanceof AbflatError && error.code === 'InvalidOption';
  for (const value of ODD) {
    assert.throws(() => unwrapTransform(abflat, { texcoord: value }), isInvalid);
    assert.throws(() => unwrapTransform(abflat, { groupBy: value }), isInvalid);
    if (typeof value !== 'function')
      assert.throws(() => unwrapTransform(abflat, { onProgress: value }), isInvalid);
  }
  for (const options of [null, 5]) assert.throws(() => unwrapTransform(abflat, options), isInvalid);
});

test('what was refused leaves nothing behind in memory', async () => {
  const small = await createAbflat({ maxMemory: 32 * 2 ** 20 });
  const { positions, indices } = grid(100);
  const wrong = { positions, indices: indices.slice() };
  wrong.indices[30000] = 2 ** 31;
  for (let i = 0; i < 100; ++i)
    for (const call of [
      small.unwrap(wrong),
      small.flatten(wrong),
      small.unwrap({ positions, indices }, { seams: 'nonsense' }),
    ])
      await assert.rejects(call, ({ code }) => code === 'InvalidMesh' || code === 'InvalidOption');
  small.terminate();
});
