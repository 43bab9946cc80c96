// Any mesh in, an atlas out: the same as from the command line program, in arrays that suit
// graphics cards.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { createAbflat, UNWRAP_DEFAULTS } from 'abflat';
import { CUBE_OF_PARTS, CUBE as CUBE_TEXT } from '../support/small-meshes.mjs';
import {
  boxArray,
  defects,
  kleinBottle,
  knot,
  moebius,
  objText,
  plate,
  sphere,
  together,
  torus,
  triangleSoup,
  unwelded,
} from '../support/surfaces.mjs';
import { bytesOf, grid, objNumbers } from './support/meshes.mjs';
import { MESHES, NATIVE, NEEDS_MESHES } from './support/paths.mjs';
import { assertSameShape, assertSameText } from './support/same.mjs';
import { arraysOf, CUBE } from './support/unwrapping.mjs';

let abflat;
let folder;
before(async () => {
  assert.ok(existsSync(NATIVE), 'build/native/abflat is missing; run: npm run build:native');
  folder = mkdtempSync(join(tmpdir(), 'abflat-unwrap-'));
  abflat = await createAbflat();
});
after(() => {
  abflat?.terminate();
  if (folder) rmSync(folder, { recursive: true });
});

const decode = (bytes) => new TextDecoder().decode(bytes);

/** The OBJ, seams and report that the command line program writes. */
function unwrapNatively(path, args = []) {
  const name = (file) => join(folder, file);
  const { status, stderr } = spawnSync(
    NATIVE,
    ['unwrap', path, '-o', name('out.obj'), '--report', name('report.json'), '--quiet', ...args],
    { encoding: 'utf8' },
  );
  assert.ok(status === 0 || status === 1, stderr);
  return {
    obj: readFileSync(name('out.obj'), 'utf8'),
    report: JSON.parse(readFileSync(name('report.json'), 'utf8')),
  };
}

async function assertSameAsNative(path, options = {}, args = []) {
  const native = unwrapNatively(path, args);
  const file = { bytes: readFileSync(path), name: path };
  const { obj, report } = await abflat.unwrap(file, { ...options, obj: true });
  assertSameText(decode(obj), native.obj);
  assertSameShape(report, native.report, 'report');
  const untimed = ({ timings, peakMemory, threads, ...rest }) => rest;
  assert.deepEqual(untimed(report), untimed(native.report));
  return report;
}

const SURFACES = {
  sphere: sphere(6),
  torus: torus(24, 12),
  knot: knot(60, 8),
  moebius: moebius(24, 3),
  'klein-bottle': kleinBottle(24, 12),
  plate: plate(2),
  boxes: boxArray(3),
  soup: triangleSoup(20),
  'sphere-and-torus': together([
    [sphere(4), [0, 0, 0]],
    [torus(16, 8), [5, 0, 0]],
  ]),
  'torus-in-pieces': unwelded(torus(16, 8)),
  defects: defects(),
};

describe('generated surfaces: the bytes and the report of the command line program', () => {
  for (const [name, surface] of Object.entries(SURFACES)) {
    test(name, async () => {
      const path = join(folder, `${name}.obj`);
      writeFileSync(path, objText(surface));
      const report = await assertSameAsNative(path);
      assert.equal(report.valid, true);
    });
  }

  test('with options', async () => {
    const path = join(folder, 'options.obj');
    writeFileSync(path, objText(SURFACES['sphere-and-torus']));
    const options = { maxStretch: 1.2, resolution: 256, padding: 4, t: 1, seams: 'auto,sharp=80' };
    const args = '--max-stretch 1.2 --resolution 256 --padding 4 --t 1 --seams auto,sharp=80';
    const { options: asked } = await assertSameAsNative(path, options, args.split(' '));
    const { seams, ...numbers } = options;
    assert.deepEqual(asked, { ...UNWRAP_DEFAULTS, ...numbers });
  });
});

describe('real meshes: the bytes and the report of the command line program', () => {
  for (const file of ['spot-uv.obj', 'suzanne-quads.obj', 'beetle-nonmanifold.obj', 'genus3.off']) {
    test(file, NEEDS_MESHES, async () => {
      const report = await assertSameAsNative(join(MESHES, file));
      assert.equal(report.valid, true);
      if (file.startsWith('beetle')) assert.ok(report.repair.nonManifoldEdges.length > 0);
    });
  }
});

function doubleArea(uv, [a, b, c]) {
  const [ux, uy] = [uv[2 * b] - uv[2 * a], uv[2 * b + 1] - uv[2 * a + 1]];
  const [vx, vy] = [uv[2 * c] - uv[2 * a], uv[2 * c + 1] - uv[2 * a + 1]];
  return ux * vy - uy * vx;
}

test('arrays: triangles keep vertices and order, and lie the right way round in the unit square', async () => {
  for (const name of ['sphere', 'torus', 'klein-bottle', 'boxes', 'defects']) {
    const mesh = arraysOf(SURFACES[name]);
    const result = await abflat.unwrap(mesh);
    assert.ok(result.report.valid, name);
    assert.equal(result.positions, undefined);
    assert.deepEqual(
      result.indices.map((v) => result.vertexMap[v]),
      mesh.indices,
      name,
    );
    assert.equal(result.uv.length, 2 * result.vertexMap.length);
    assert.ok(result.uv.every((x) => x >= 0 && x <= 1));
    assert.equal(result.chartOfTriangle.length, mesh.indices.length / 3);
    const inChart = new Array(result.report.charts.length).fill(0);
    result.chartOfTriangle.forEach((chart, f) => {
      if (doubleArea(result.uv, result.indices.subarray(3 * f, 3 * f + 3)) > 0) inChart[chart]++;
    });
    assert.deepEqual(
      inChart,
      result.report.charts.map(({ faces }) => faces),
      name,
    );
  }
});

test('a vertex is there once for every uv that it has, and all vertices of faces are', async () => {
  const mesh = arraysOf(SURFACES.torus);
  const { uv, vertexMap } = await abflat.unwrap(mesh);
  assert.deepEqual(new Set(vertexMap), new Set(mesh.indices));
  const keys = Array.from(vertexMap, (v, i) => `${v} ${uv[2 * i]} ${uv[2 * i + 1]}`);
  assert.equal(new Set(keys).size, keys.length);
  assert.ok(vertexMap.length > mesh.positions.length / 3);
});

test('charts are connected within a chart and apart at seams', async () => {
  const mesh = arraysOf(SURFACES['sphere-and-torus']);
  const { indices, vertexMap, chartOfTriangle, seams } = await abflat.unwrap(mesh);
  const key = (a, b) => `${Math.min(a, b)} ${Math.max(a, b)}`;
  const cut = new Set();
  for (let i = 0; i < seams.length; i += 2) cut.add(key(seams[i], seams[i + 1]));
  assert.equal(cut.size, seams.length / 2, 'each seam once');
  const sides = new Map();
  for (let h = 0; h < indices.length; ++h) {
    const [a, b] = [indices[h], indices[h % 3 === 2 ? h - 2 : h + 1]];
    const edge = key(vertexMap[a], vertexMap[b]);
    const here = { ends: key(a, b), chart: chartOfTriangle[Math.floor(h / 3)] };
    const there = sides.get(edge);
    sides.set(edge, here);
    if (!there) continue;
    if (cut.has(edge)) assert.notEqual(here.ends, there.ends, `${edge} is cut`);
    else assert.deepEqual(here, there, `${edge} is whole`);
  }
});

test('a file gives what its arrays give, and its positions', async () => {
  const surface = SURFACES.torus;
  const mesh = arraysOf(surface);
  const fromArrays = await abflat.unwrap(mesh);
  const bytes = bytesOf(objText(surface));
  const fromFile = await abflat.unwrap({ bytes, name: 'torus.obj' });
  for (const key of ['uv', 'indices', 'vertexMap', 'chartOfTriangle', 'seams'])
    assert.deepEqual(fromFile[key], fromArrays[key], key);
  const positions = [...fromFile.vertexMap].flatMap((v) => surface.positions[v]);
  assert.deepEqual([...fromFile.positions], positions);
  assert.equal(fromFile.report.input.path, 'torus.obj');
});

test('polygons are triangulated', async () => {
  const bytes = bytesOf(objText(CUBE));
  const { indices, chartOfTriangle, report } = await abflat.unwrap({ bytes, name: 'cube.obj' });
  assert.equal(indices.length, 36);
  assert.equal(chartOfTriangle.length, 12);
  assert.equal(report.input.faces, 6);
});

test('uv is in single precision as checked, with obj that of the file', async () => {
  const mesh = arraysOf(SURFACES.sphere);
  const single = await abflat.unwrap(mesh);
  assert.deepEqual(Float64Array.from(Float32Array.from(single.uv)), single.uv);
  assert.deepEqual(single.report.notes, []);
  const { uv, indices, obj } = await abflat.unwrap(mesh, { obj: true });
  const text = decode(obj);
  const texcoords = objNumbers(text, 'vt');
  const corners = text
    .split('\n')
    .filter((line) => line.startsWith('f '))
    .flatMap((line) => line.slice(2).split(' '))
    .map((corner) => Number(corner.split('/')[1]) - 1);
  assert.deepEqual(
    corners.flatMap((i) => [texcoords[2 * i], texcoords[2 * i + 1]]),
    [...indices].flatMap((v) => [uv[2 * v], uv[2 * v + 1]]),
  );
});

test('ply has the vertices of the result in single precision', async () => {
  const { ply, uv, obj } = await abflat.unwrap(arraysOf(SURFACES.sphere), { ply: true });
  assert.match(decode(ply.subarray(0, 40)), /^ply\nformat binary/);
  assert.equal(obj, undefined);
  assert.deepEqual(Float64Array.from(Float32Array.from(uv)), uv);
});

test('seams: none keeps as few charts as topology allows, edges are cut as asked', async () => {
  const mesh = arraysOf(CUBE);
  const none = await abflat.unwrap(mesh, { seams: 'none' });
  const sharp = await abflat.unwrap(mesh, { seams: 'sharp=45' });
  assert.equal(none.report.charts.length, 1);
  assert.equal(sharp.report.charts.length, 6);
  assert.equal(sharp.seams.length, 24);
  const again = await abflat.unwrap(mesh, { seams: 'none', seamEdges: sharp.seams });
  for (const key of ['uv', 'indices', 'vertexMap', 'chartOfTriangle', 'seams'])
    assert.deepEqual(again[key], sharp[key], key);
  assert.ok(sharp.seams.length > 0, 'the edges that were passed stay');
});

test('unpacked: charts as large as on the surface, at the scale of the atlas in uv', async () => {
  const { uv, unpacked, indices, chartOfTriangle, report } = await abflat.unwrap(
    arraysOf(SURFACES['sphere-and-torus']),
  );
  const areas = (of) => {
    const sums = new Array(report.charts.length).fill(0);
    for (const [f, chart] of chartOfTriangle.entries())
      sums[chart] += doubleArea(of, indices.subarray(3 * f, 3 * f + 3)) / 2;
    return sums;
  };
  const inUv = areas(uv);
  const scale = (report.atlas.texelDensity / report.atlas.resolution) ** 2;
  for (const [i, area] of areas(unpacked).entries()) {
    assert.ok(Math.abs(area / report.charts[i].area - 1) < 1e-9);
    assert.ok(Math.abs(inUv[i] / (area * scale) - 1) < 1e-4);
  }
});

test('a disk becomes one chart with the angles of flatten', async () => {
  const mesh = grid(8);
  const flat = await abflat.flatten(mesh);
  const { report, vertexMap } = await abflat.unwrap(mesh, {
    maxStretch: 10,
    balance: 0,
    minUtilization: 0,
  });
  assert.equal(report.charts.length, 1);
  assert.equal(vertexMap.length, 81);
  assert.ok(
    Math.abs(report.angularDistortion - flat.report.charts[0].angularDistortion) < 1e-9,
    `${report.angularDistortion}`,
  );
});

test('progress names the stages in their order and ends with 1', async () => {
  const stages = [];
  const fractions = [];
  await abflat.unwrap(arraysOf(SURFACES.torus), {
    onProgress: ({ stage, fraction }) => {
      if (stages.at(-1) !== stage) stages.push(stage);
      fractions.push(fraction);
    },
  });
  assert.deepEqual(stages, ['read', 'surface', 'seams', 'solve', 'pack', 'check', 'write']);
  assert.deepEqual(
    fractions,
    [...fractions].sort((a, b) => a - b),
  );
  assert.equal(fractions.at(-1), 1);
});

test('transfer takes the buffers of the mesh, but not those of the options', async () => {
  const mesh = arraysOf(CUBE);
  const seamEdges = Uint32Array.of(0, 1);
  const { seams } = await abflat.unwrap(mesh, { transfer: true, seams: 'none', seamEdges });
  assert.equal(mesh.positions.length, 0);
  assert.equal(seamEdges.length, 2);
  const edges = Array.from({ length: seams.length / 2 }, (_, i) => seams.slice(2 * i, 2 * i + 2));
  assert.ok(
    edges.some(([a, b]) => a === 0 && b === 1),
    'the edge is cut',
  );
});

test('an abort ends the run, and the next one works', async () => {
  const controller = new AbortController();
  const mesh = arraysOf(sphere(40));
  const call = abflat.unwrap(mesh, {
    signal: controller.signal,
    onProgress: () => controller.abort(),
  });
  await assert.rejects(call, { name: 'AbortError' });
  assert.equal((await abflat.unwrap(arraysOf(CUBE))).report.valid, true);
});

test('seams along texcoords and materials of an OBJ, and what the mesh has of them', async () => {
  const file = (text) => ({ bytes: bytesOf(text), name: 'cube.obj' });
  const chartsOf = async (seams) =>
    (await abflat.unwrap(file(CUBE_OF_PARTS), { seams, maxStretch: 3 })).report.charts.map(
      ({ faces }) => faces,
    );
  assert.deepEqual((await chartsOf('uv')).sort(), [10, 2]);
  assert.deepEqual((await chartsOf('material')).sort(), [10, 2]);
  assert.deepEqual((await chartsOf('uv,material')).sort(), [2, 2, 8]);
  const { texcoords, materials } = await abflat.inspect(file(CUBE_OF_PARTS));
  assert.deepEqual([texcoords, materials], [16, 2]);
  const plain = await abflat.inspect(file(CUBE_TEXT));
  assert.deepEqual([plain.texcoords, plain.materials], [0, 0]);
  for (const seams of ['uv', 'material'])
    await assert.rejects(abflat.unwrap(file(CUBE_TEXT), { seams }), { code: 'InvalidOption' });
});

test('load tells the face of each triangle', async () => {
  const { indices, faces } = await abflat.load({ bytes: bytesOf(CUBE_TEXT), name: 'cube.obj' });
  assert.deepEqual([...faces], [0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5]);
  assert.equal(indices.length, 3 * faces.length);
  for (let f = 0; f < 6; ++f)
    assert.equal(new Set(indices.subarray(6 * f, 6 * f + 6)).size, 4, 'two halves of a square');
});
