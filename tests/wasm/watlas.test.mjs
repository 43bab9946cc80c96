// The names of watlas: what is declared, asked for and returned.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { before, test } from 'node:test';
import { AbflatError } from 'abflat';
import { createAbflatSync } from 'abflat/sync';
import * as watlas from 'abflat/watlas';
import { judge } from '../support/exact-atlas.mjs';
import { Random, randomSurface } from '../support/random-surfaces.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { ROOT } from './support/paths.mjs';
import { area, assertLaidOut } from './support/watlas.mjs';

before(() => watlas.Initialize());

/** Faces of any size become fans. */
function declOf({ positions, faces }, more = {}) {
  const fans = faces.flatMap((face) => face.slice(2).flatMap((c, k) => [face[0], face[k + 1], c]));
  return {
    vertexCount: positions.length,
    vertexPositionData: Float32Array.from(positions.flat()),
    vertexPositionStride: 12,
    indexData: Uint32Array.from(fans),
    indexCount: fans.length,
    ...more,
  };
}

const BALL = declOf(sphere(6));
const RING = declOf(torus(16, 8));

function generated(decls, ...options) {
  const atlas = new watlas.Atlas();
  for (const decl of decls) atlas.addMesh(decl);
  atlas.generate(...options);
  return atlas;
}

/** The triangles of a mesh in the unit square, as glTF-Transform writes them. */
function trianglesOf(atlas, index = 0) {
  const mesh = atlas.getMesh(index);
  const indices = new Uint32Array(mesh.indexCount);
  assert.equal(mesh.getIndexArray(indices), true);
  const [u, v] = [1 / atlas.width, 1 / atlas.height];
  const at = Array.from(indices, (vertex) => {
    const { uv } = mesh.getVertex(vertex);
    return [Math.fround(uv[0] * u), Math.fround(uv[1] * v)];
  });
  return Array.from({ length: at.length / 3 }, (_, t) => at.slice(3 * t, 3 * t + 3));
}

const allTriangles = (atlas) =>
  Array.from({ length: atlas.meshCount }, (_, i) => trianglesOf(atlas, i)).flat();

/** The input vertices of the faces, as they come out. */
function sourcesOf(atlas, index = 0) {
  const mesh = atlas.getMesh(index);
  const indices = new Uint32Array(mesh.indexCount);
  mesh.getIndexArray(indices);
  return indices.map((vertex) => mesh.getVertex(vertex).xref);
}

test('faces come in the order given, with no vertex that they do not use', () => {
  const atlas = generated([BALL, RING]);
  assert.equal(atlas.meshCount, 2);
  for (const [i, { indexData }] of [BALL, RING].entries()) {
    assert.deepEqual(sourcesOf(atlas, i), indexData);
    const mesh = atlas.getMesh(i);
    const indices = new Uint32Array(mesh.indexCount);
    mesh.getIndexArray(indices);
    assert.deepEqual(
      [...new Set(indices)].sort((a, b) => a - b),
      Array.from({ length: mesh.vertexCount }, (_, v) => v),
    );
  }
  assertLaidOut(allTriangles(atlas));
});

test('charts list the faces of their mesh, each once', () => {
  const atlas = generated([BALL, RING]);
  let charts = 0;
  for (const [i, { indexData }] of [BALL, RING].entries()) {
    const mesh = atlas.getMesh(i);
    const seen = [];
    for (let k = 0; k < mesh.chartCount; ++k) {
      const chart = mesh.getChart(k);
      const faces = new Uint32Array(chart.faceCount);
      assert.equal(chart.getFaceArray(faces), true);
      assert.deepEqual(
        [chart.atlasIndex, chart.type, chart.material],
        [0, watlas.ChartType.LSCM, 0],
      );
      seen.push(...faces);
    }
    assert.deepEqual(
      seen.sort((a, b) => a - b),
      Array.from({ length: indexData.length / 3 }, (_, face) => face),
    );
    charts += mesh.chartCount;
  }
  assert.equal(atlas.chartCount, charts);
  const numbers = new Set();
  for (let i = 0; i < 2; ++i)
    for (let v = 0; v < atlas.getMesh(i).vertexCount; ++v) {
      const { atlasIndex, chartIndex } = atlas.getMesh(i).getVertex(v);
      assert.equal(atlasIndex, 0);
      numbers.add(chartIndex);
    }
  assert.equal(numbers.size, charts);
});

test('meshes in the same place are not joined, and have one texel density', () => {
  const large = { ...BALL, vertexPositionData: BALL.vertexPositionData.map((x) => 3 * x) };
  const atlas = generated([BALL, BALL, large]);
  const areas = [0, 1, 2].map((i) => area(trianglesOf(atlas, i)));
  assert.ok(Math.abs(areas[1] / areas[0] - 1) < 0.05, `${areas}`);
  assert.ok(Math.abs(areas[2] / areas[0] / 9 - 1) < 0.05, `${areas}`);
  assertLaidOut(allTriangles(atlas));
});

test('arrays are read with their strides, whatever lies between', () => {
  const { vertexCount, indexData } = RING;
  const wanted = trianglesOf(generated([RING]));
  const floats = new Float32Array(8 * vertexCount + 2);
  for (let v = 0; v < vertexCount; ++v)
    floats.set(RING.vertexPositionData.subarray(3 * v, 3 * v + 3), 8 * v + 2);
  const interleaved = floats.subarray(2);
  const bytes = new Uint8Array(14 * vertexCount);
  const view = new DataView(bytes.buffer);
  for (let i = 0; i < 3 * vertexCount; ++i)
    view.setFloat32(14 * Math.floor(i / 3) + 4 * (i % 3), RING.vertexPositionData[i], true);
  for (const more of [
    { vertexPositionData: interleaved, vertexPositionStride: 32 },
    { vertexPositionData: bytes, vertexPositionStride: 14 },
    { indexData: Uint16Array.from(indexData) },
    { indexData: Uint32Array.from([...indexData, 7, 7, 7]), indexCount: indexData.length },
    { indexData: indexData.map((i) => i - 1), indexOffset: 1 },
    { indexCount: undefined },
    { faceVertexCount: new Uint32Array(indexData.length / 3).fill(3) },
  ])
    assert.deepEqual(
      trianglesOf(generated([{ ...RING, ...more }])),
      wanted,
      Object.keys(more).join(),
    );
});

test('without indices every three vertices are a face', () => {
  const loose = {
    vertexCount: BALL.indexCount,
    vertexPositionData: Float32Array.from(BALL.indexData, (_, c) => c).map(() => 0),
    vertexPositionStride: 12,
  };
  loose.vertexPositionData = Float32Array.from(
    [...BALL.indexData].flatMap((v) => [...BALL.vertexPositionData.subarray(3 * v, 3 * v + 3)]),
  );
  const atlas = generated([loose]);
  assert.deepEqual(
    sourcesOf(atlas),
    Uint32Array.from({ length: loose.vertexCount }, (_, v) => v),
  );
  assertLaidOut(allTriangles(atlas));
  assert.ok(atlas.chartCount < 10, `${atlas.chartCount}`);
});

test('the arrays of the caller stay as they are, and may change after addMesh', () => {
  const own = structuredClone(BALL);
  const atlas = new watlas.Atlas();
  atlas.addMesh(own);
  assert.deepEqual(own, BALL);
  own.vertexPositionData.fill(0);
  own.indexData.fill(0);
  atlas.generate();
  assert.deepEqual(trianglesOf(atlas), trianglesOf(generated([BALL])));
});

test('resolution and density as asked for', () => {
  const at = (pack) => generated([BALL, RING], {}, pack);
  assert.equal(at({ resolution: 300 }).width, 300);
  const [one] = [at({ texelsPerUnit: 100 })];
  assert.equal(one.texelsPerUnit, 100);
  assert.equal(one.atlasCount, 1);
  assertLaidOut(allTriangles(one));
  const many = at({ resolution: 256, texelsPerUnit: 150 });
  assert.deepEqual([many.width, many.texelsPerUnit], [256, 150]);
  assert.ok(many.atlasCount > 1, `${many.atlasCount}`);
  const shares = new Float32Array(many.atlasCount);
  assert.equal(many.getUtilization(shares), true);
  assert.equal(many.getUtilization(new Float32Array(0)), false);
  const perTile = Array.from({ length: many.atlasCount }, () => []);
  for (let i = 0; i < 2; ++i) {
    const mesh = many.getMesh(i);
    const indices = new Uint32Array(mesh.indexCount);
    mesh.getIndexArray(indices);
    const triangles = trianglesOf(many, i);
    for (const [t, triangle] of triangles.entries())
      perTile[mesh.getVertex(indices[3 * t]).atlasIndex].push(triangle);
  }
  for (const [tile, triangles] of perTile.entries()) {
    assertLaidOut(triangles, `tile ${tile}`);
    assert.ok(Math.abs(area(triangles) - shares[tile]) < 1e-3);
    assert.ok(shares[tile] > 0);
  }
});

test('charts can be packed again without being made again', () => {
  const atlas = new watlas.Atlas();
  atlas.addMesh(RING);
  atlas.computeCharts({});
  const charts = atlas.chartCount;
  for (const padding of [0, 8, 16]) {
    atlas.packCharts({ padding, resolution: 512 });
    assert.deepEqual([atlas.chartCount, atlas.width], [charts, 512]);
    assertLaidOut(allTriangles(atlas));
  }
});

const GRID = {
  vertexCount: 4,
  vertexUvData: Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1),
  vertexStride: 8,
  indexData: Uint16Array.of(0, 1, 2, 0, 2, 3),
};

test('uv meshes keep their charts, which no longer lie on each other', () => {
  const atlas = new watlas.Atlas();
  for (let i = 0; i < 3; ++i) atlas.addUvMesh(GRID);
  atlas.packCharts({ resolution: 128, bilinear: false });
  assert.equal(atlas.meshCount, 3);
  const areas = [0, 1, 2].map((i) => area(trianglesOf(atlas, i)));
  for (const each of areas) assert.ok(Math.abs(each - areas[0]) < 1e-6 && each > 0.1, `${areas}`);
  for (let i = 0; i < 3; ++i) assert.deepEqual([...sourcesOf(atlas, i)], [...GRID.indexData]);
  assertLaidOut(allTriangles(atlas));
  assert.throws(() => atlas.addMesh(BALL), { code: 'InvalidMesh', message: /not both/ });
});

test('useInputMeshUvs packs the layout that a mesh has', () => {
  const flat = {
    ...GRID,
    vertexPositionData: Float32Array.of(0, 0, 0, 5, 0, 0, 5, 1, 0, 0, 1, 0),
    vertexPositionStride: 12,
    vertexUvStride: 8,
  };
  const sides = (useInputMeshUvs) => {
    const [[a, b, c]] = trianglesOf(generated([flat], { useInputMeshUvs }));
    return Math.hypot(b[0] - a[0], b[1] - a[1]) / Math.hypot(c[0] - b[0], c[1] - b[1]);
  };
  assert.ok(Math.abs(sides(true) - 1) < 0.01);
  assert.ok(Math.abs(Math.log(sides(false)) / Math.log(5)) > 0.9);
});

test('faces of different materials share no chart', () => {
  const faces = RING.indexCount / 3;
  const faceMaterialData = Uint32Array.from({ length: faces }, (_, f) => Number(f >= faces / 2));
  const atlas = generated([{ ...RING, faceMaterialData }]);
  const mesh = atlas.getMesh(0);
  const materials = new Set();
  for (let k = 0; k < mesh.chartCount; ++k) {
    const chart = mesh.getChart(k);
    const list = new Uint32Array(chart.faceCount);
    chart.getFaceArray(list);
    for (const face of list) assert.equal(faceMaterialData[face], chart.material);
    materials.add(chart.material);
  }
  assert.equal(materials.size, 2);
});

test('faces that cannot be drawn have the uv 0, 0 and no chart', () => {
  const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, Number.NaN, 0, 0, 9, 9, 9);
  const atlas = generated([
    {
      vertexCount: 5,
      vertexPositionData: positions,
      vertexPositionStride: 12,
      indexData: Uint16Array.of(1, 1, 2, 0, 1, 2, 0, 1, 3),
    },
  ]);
  assert.deepEqual([...sourcesOf(atlas)], [1, 1, 2, 0, 1, 2, 0, 1, 3]);
  const mesh = atlas.getMesh(0);
  const indices = new Uint32Array(9);
  mesh.getIndexArray(indices);
  for (const c of [0, 1, 2, 6, 7, 8])
    assert.deepEqual(
      { ...mesh.getVertex(indices[c]), xref: 0 },
      { atlasIndex: -1, chartIndex: -1, uv: [0, 0], xref: 0 },
    );
  assert.ok(area(trianglesOf(atlas).slice(1, 2)) > 0.1);
});

test('nothing to draw is no error', () => {
  const point = {
    vertexCount: 1,
    vertexPositionData: new Float32Array(3),
    vertexPositionStride: 12,
  };
  for (const decl of [
    { ...point, indexData: new Uint16Array(0) },
    { ...point, indexData: Uint16Array.of(0, 0, 0) },
    { vertexCount: 0, vertexPositionData: new Float32Array(0), vertexPositionStride: 12 },
    { vertexCount: 3, vertexPositionData: new Float32Array(9), vertexPositionStride: 12 },
  ]) {
    const atlas = generated([decl]);
    assert.deepEqual([atlas.meshCount, atlas.chartCount, atlas.atlasCount], [1, 0, 0]);
    for (const triangle of trianglesOf(atlas)) assert.deepEqual(triangle.flat(), Array(6).fill(0));
  }
  const none = generated([]);
  assert.deepEqual([none.meshCount, none.chartCount], [0, 0]);
});

test('what is declared wrongly is refused by name', () => {
  const atlas = new watlas.Atlas();
  for (const [more, message] of [
    [{ vertexPositionData: undefined }, /no vertexPositionData/],
    [{ vertexPositionData: new Float64Array(3) }, /vertexPositionData must be a Float32Array/],
    [{ vertexPositionStride: -1 }, /vertexPositionStride/],
    [{ vertexPositionStride: 16 }, /vertexPositionData has \d+ bytes, but .* need \d+/],
    [{ vertexCount: 2.5 }, /vertexCount/],
    [
      { vertexCount: 3, indexData: Uint16Array.of(0, 1, 3), indexCount: 3 },
      /indexData\[2\] is vertex 3/,
    ],
    [{ indexCount: 4 }, /indexCount is 4, not a multiple of 3/],
    [{ indexCount: 3e6 }, /indexCount is 3000000, but/],
    [{ indexData: [0, 1, 2] }, /indexData must be a Uint32Array or Uint16Array, not Array/],
    [{ faceVertexCount: Uint32Array.of(4) }, /Face 0 is not a triangle/],
    [{ faceMaterialData: Uint32Array.of(1) }, /faceMaterialData has 1 elements/],
  ])
    assert.throws(
      () => atlas.addMesh({ ...BALL, ...more }),
      (error) =>
        error instanceof AbflatError && error.code === 'InvalidMesh' && message.test(error.message),
      `${message}`,
    );
  assert.throws(() => atlas.addUvMesh({ vertexCount: 1 }), { message: /no vertexUvData/ });
  assert.throws(() => atlas.generate({ maxCosts: 1 }), {
    code: 'InvalidOption',
    message: /maxCosts/,
  });
  assert.throws(() => atlas.generate({}, { padding: 'wide' }), {
    message: /padding must be a number/,
  });
  assert.throws(() => atlas.getMesh(0), { message: /no mesh 0: there are 0/ });
});

test('what means nothing here, or does not fit, is said', (t) => {
  const said = t.mock.method(console, 'warn', () => undefined);
  const atlas = generated(
    [BALL],
    { maxCost: 9, normalSeamWeight: 4 },
    { bruteForce: true, padding: 300 },
  );
  assert.equal(atlas.notes.length, said.mock.callCount());
  assert.match(atlas.notes.join(), /maxCost is ignored.*maxStretch.*bruteForce.*padding is 256/s);
  assert.doesNotMatch(atlas.notes.join(), /normalSeamWeight/);
  const small = generated(Array(40).fill(BALL), {}, { resolution: 16 });
  assert.ok(small.width > 16);
  assert.match(small.notes.join(), /larger than 16 texels/);
  assertLaidOut(allTriangles(small));
});

test('an engine and options of the caller', async () => {
  const abflat = await createAbflatSync({ also: ['pack'] });
  const { Initialize, Atlas } = watlas.createWatlas(abflat, { maxStretch: 1.0005 });
  await Initialize();
  const atlas = new Atlas();
  atlas.addMesh(RING);
  atlas.generate();
  assert.ok(atlas.chartCount > generated([RING]).chartCount);
  assertLaidOut(allTriangles(atlas));
  atlas.delete();
  assert.equal(atlas.meshCount, 0);
});

test('an atlas before Initialize says what to do', () => {
  const text = `
    import { Atlas, Initialize } from 'abflat/watlas';
    try { new Atlas(); } catch (error) { console.log(error.message); }
    await Initialize({ wasmUrl: '/nowhere.wasm' }).catch(({ code }) => console.log(code));
    await Promise.all([Initialize(), Initialize()]);
    console.log(new Atlas().meshCount);
  `;
  const args = ['--input-type=module', '--eval', text];
  const { stdout, stderr } = spawnSync(process.execPath, args, { cwd: ROOT, encoding: 'utf8' });
  assert.equal(stdout, 'Call Initialize() and await it before this.\nUnreadableFile\n0\n', stderr);
});

test('random surfaces, several in an atlas', (t) => {
  t.mock.method(console, 'warn', () => undefined);
  for (let seed = 0; seed < 12; ++seed) {
    const random = new Random(seed);
    const decls = [0, 1, 2].map(() => declOf(randomSurface(random)));
    const atlas = generated(decls);
    for (const [i, { indexData }] of decls.entries())
      assert.deepEqual(sourcesOf(atlas, i), indexData, `seed ${seed}`);
    if (atlas.notes.length > 0) continue;
    const drawn = [];
    for (let i = 0; i < 3; ++i) {
      const mesh = atlas.getMesh(i);
      const indices = new Uint32Array(mesh.indexCount);
      mesh.getIndexArray(indices);
      for (const [t, triangle] of trianglesOf(atlas, i).entries())
        if (mesh.getVertex(indices[3 * t]).chartIndex >= 0) drawn.push(triangle);
    }
    const { flipped, overlaps, outside } = judge(drawn);
    assert.deepEqual(
      { flipped, overlaps, outside },
      { flipped: [], overlaps: [], outside: [] },
      `seed ${seed}`,
    );
  }
});
