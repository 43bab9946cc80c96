// Existing atlases, kept in whole or in part, and atlases that have to match others.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { bytesOf } from './support/meshes.mjs';
import { arraysOf, assertFails, CUBE } from './support/unwrapping.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const SPHERE_AND_TORUS = together([
  [sphere(4), [0, 0, 0]],
  [torus(16, 8), [5, 0, 0]],
]);

const solvers = ({ report }) => report.charts.map(({ solver }) => solver);
const ARRAYS = ['uv', 'unpacked', 'indices', 'vertexMap', 'chartOfTriangle', 'seams'];

test('known: charts that an edit of the seams leaves alone are not solved, and the result is that of solving', async () => {
  const mesh = arraysOf(CUBE);
  const file = { bytes: bytesOf(objText(CUBE)), name: 'cube.obj' };
  for (const input of [mesh, file]) {
    const first = await abflat.unwrap(input, { seams: 'sharp=45' });
    const edit = { seams: 'none', seamEdges: first.seams.slice(2) };
    const solved = await abflat.unwrap(input, edit);
    const quick = await abflat.unwrap(input, { ...edit, known: first });
    assert.equal(solved.report.charts.length, 5);
    assert.ok(!solvers(solved).includes('known'));
    assert.equal(solvers(quick).filter((solver) => solver === 'known').length, 4);
    for (const key of ARRAYS) assert.deepEqual(quick[key], solved[key], key);
    const again = await abflat.unwrap(input, { ...edit, known: quick });
    assert.deepEqual(new Set(solvers(again)), new Set(['known']));
    for (const key of ARRAYS) assert.deepEqual(again[key], solved[key], key);
    const other = await abflat.unwrap(input, { ...edit, t: 1, known: quick });
    assert.ok(!solvers(other).includes('known'), 'other angles were asked for');
    assert.ok(quick.unpacked.length > 0, 'what was passed stays');
  }
});

test('known: charts of the same balance are taken over, those of another one solved anew', async () => {
  const mesh = arraysOf(sphere(8));
  const options = { seams: 'auto', balance: 0.5, minUtilization: 0 };
  const first = await abflat.unwrap(mesh, options);
  assert.ok(first.report.charts.every(({ refined }) => refined.energy < refined.energyBefore));
  const edit = { ...options, seams: 'none', seamEdges: first.seams };
  const again = await abflat.unwrap(mesh, { ...edit, known: first });
  assert.deepEqual(new Set(solvers(again)), new Set(['known']));
  for (const key of ARRAYS) assert.deepEqual(again[key], first[key], key);
  for (const balance of [0, 0.25, 1]) {
    const other = await abflat.unwrap(mesh, { ...edit, balance, known: first });
    assert.ok(!solvers(other).includes('known'), `balance ${balance}`);
    const solved = await abflat.unwrap(mesh, { ...edit, balance });
    for (const key of ARRAYS) assert.deepEqual(other[key], solved[key], key);
  }
});

test('known: straight seams are kept where they end at the same places', async () => {
  const mesh = arraysOf(torus(16, 8));
  const straight = { seams: 'auto', straightSeams: true };
  const first = await abflat.unwrap(mesh, straight);
  const again = await abflat.unwrap(mesh, { ...straight, known: first });
  assert.deepEqual(new Set(solvers(again)), new Set(['known']));
  for (const key of ARRAYS) assert.deepEqual(again[key], first[key], key);
  assert.deepEqual(
    again.report.charts.map((chart) => chart.straight),
    first.report.charts.map((chart) => chart.straight),
  );
  const bent = await abflat.unwrap(mesh, { seams: 'auto', known: first });
  assert.ok(!solvers(bent).includes('known'), 'seams were straight then');
});

test('known: what is no result, or that of another mesh, is refused', async () => {
  const cube = await abflat.unwrap(arraysOf(CUBE));
  const { uv, ...rest } = cube;
  assert.equal((await abflat.unwrap(arraysOf(CUBE), { known: rest })).report.valid, true);
  for (const [known, pattern] of [
    [null, /result of unwrap; its unpacked/],
    [{ ...cube, indices: [0, 1, 2] }, /its indices is not a Uint32Array/],
    [{ ...cube, report: {} }, /report\.options\.t/],
    [{ ...cube, vertexMap: cube.vertexMap.slice(1) }, /belongs to another mesh.*coordinates/],
    [await abflat.unwrap(arraysOf(sphere(6))), /belongs to another mesh.*triangles/],
  ])
    await assertFails(abflat, abflat.unwrap(arraysOf(CUBE), { known }), 'InvalidOption', pattern);
});

test('fixedFaces: islands stay as they are, of arrays and of files', async () => {
  const mesh = arraysOf(SPHERE_AND_TORUS);
  const { uv, indices, vertexMap, chartOfTriangle, report, obj } = await abflat.unwrap(mesh, {
    obj: true,
  });
  const positions = Float64Array.from(
    [...vertexMap].flatMap((v) => [...mesh.positions.slice(3 * v, 3 * v + 3)]),
  );
  const fixedFaces = Uint32Array.of(report.charts[0].firstFace);
  const isKept = (f) => chartOfTriangle[f] === 0;
  for (const input of [
    { positions, indices, texcoords: uv },
    { bytes: obj, name: 'before.obj' },
  ]) {
    const after = await abflat.unwrap(input, { fixedFaces, seams: 'auto,sharp=50' });
    assert.equal(after.report.valid, true);
    assert.deepEqual(
      after.report.charts.map(({ fixed }) => fixed),
      after.report.charts.map((_, i) => i === after.chartOfTriangle[fixedFaces[0]]),
    );
    for (let h = 0; h < indices.length; ++h) {
      const f = Math.floor(h / 3);
      assert.equal(after.report.charts[after.chartOfTriangle[f]].fixed, isKept(f));
      if (!isKept(f)) continue;
      const [v, w] = [after.indices[h], indices[h]];
      assert.deepEqual([...after.uv.slice(2 * v, 2 * v + 2)], [...uv.slice(2 * w, 2 * w + 2)]);
      assert.ok(Number.isNaN(after.unpacked[2 * v]));
    }
    const again = await abflat.unwrap(input, { known: after, seams: 'auto,sharp=50' });
    assert.equal(solvers(again).includes('given'), false);
  }
});

test("fixedFaces 'uv': all faces that have coordinates keep them, of arrays and of files", async () => {
  const mesh = arraysOf(SPHERE_AND_TORUS);
  const first = await abflat.unwrap(mesh, { obj: true });
  const positions = Float64Array.from(
    [...first.vertexMap].flatMap((v) => [...mesh.positions.slice(3 * v, 3 * v + 3)]),
  );
  // Only one chart has texcoords.
  const isKept = (f) => first.chartOfTriangle[f] === 0;
  const texcoords = new Float64Array(first.uv.length).fill(Number.NaN);
  first.indices.forEach((v, h) => {
    if (isKept(Math.floor(h / 3))) texcoords.set(first.uv.slice(2 * v, 2 * v + 2), 2 * v);
  });
  let face = -1;
  const text = new TextDecoder().decode(first.obj).replace(/^f .*$/gm, (line) => {
    face += 1;
    return isKept(face) ? line : line.replace(/\/\d+/g, '');
  });
  const named = Uint32Array.from(first.chartOfTriangle.keys()).filter(isKept);
  for (const input of [
    { positions, indices: first.indices, texcoords },
    { bytes: bytesOf(text), name: 'painted.obj' },
  ]) {
    const [all, some] = await Promise.all(
      ['uv', named].map((fixedFaces) => abflat.unwrap(input, { fixedFaces, maxStretch: 1.01 })),
    );
    assert.deepEqual(all.uv, some.uv);
    assert.deepEqual(all.indices, some.indices);
    assert.equal(all.report.valid, true);
    all.chartOfTriangle.forEach((chart, f) => {
      assert.equal(all.report.charts[chart].fixed, isKept(f));
    });
  }
});

test('fixedCharts: charts of an earlier result stay, of arrays and of files', async () => {
  const mesh = arraysOf(SPHERE_AND_TORUS);
  const file = { bytes: bytesOf(objText(SPHERE_AND_TORUS)), name: 'both.obj' };
  for (const [input, options] of [
    [mesh, {}],
    [file, { obj: true }],
    [mesh, { straightSeams: true }],
  ]) {
    const first = await abflat.unwrap(input, options);
    const change = { ...options, maxStretch: 1.01, straightSeams: false, seams: 'auto,sharp=50' };
    const fixedCharts = Uint32Array.of(1);
    const second = await abflat.unwrap(input, { ...change, known: first, fixedCharts });
    assert.equal(second.report.valid, true);
    for (let h = 0; h < first.indices.length; ++h) {
      const f = Math.floor(h / 3);
      const stays = first.chartOfTriangle[f] === 1;
      assert.equal(second.report.charts[second.chartOfTriangle[f]].fixed, stays);
      if (!stays) continue;
      const [v, w] = [second.indices[h], first.indices[h]];
      assert.deepEqual(
        [...second.uv.slice(2 * v, 2 * v + 2)],
        [...first.uv.slice(2 * w, 2 * w + 2)],
      );
    }
  }
});

test('fixedCharts: what is missing is said', async () => {
  const mesh = arraysOf(CUBE);
  const { uv, ...known } = await abflat.unwrap(mesh);
  const fixedCharts = Uint32Array.of(0);
  for (const [options, pattern] of [
    [{ fixedCharts }, /fixedCharts needs known/],
    [{ fixedCharts, known }, /its uv is not a Float64Array/],
    [{ fixedCharts: [0], known: { ...known, uv } }, /must be a Uint32Array of chart numbers/],
    [{ fixedCharts: Uint32Array.of(9999), known: { ...known, uv } }, /has no such chart/],
  ])
    await assertFails(abflat, abflat.unwrap(mesh, options), 'InvalidOption', pattern);
});

test('keepsPlaces: charts that the caller moved stay there, and are checked there', async () => {
  const mesh = arraysOf(SPHERE_AND_TORUS);
  const first = await abflat.unwrap(mesh);
  const same = { seams: 'none', seamEdges: first.seams, keepsPlaces: true };
  const again = await abflat.unwrap(mesh, { ...same, known: first });
  for (const name of ARRAYS) assert.deepEqual(again[name], first[name], name);
  const moved = new Set(
    first.indices.filter((_, h) => first.chartOfTriangle[Math.floor(h / 3)] === 0),
  );
  const uv = first.uv.map((x, i) => (moved.has(i >> 1) && i % 2 === 0 ? x + 2 : x));
  const away = await abflat.unwrap(mesh, { ...same, known: { ...first, uv } });
  assert.deepEqual(away.uv, uv);
  assert.deepEqual(
    away.report.charts.map(({ valid }) => valid),
    first.report.charts.map((_, chart) => chart !== 0),
  );
  assert.equal(away.report.valid, false);
});

test('keepsPlaces: what is missing is said', async () => {
  const mesh = arraysOf(CUBE);
  const { uv, ...known } = await abflat.unwrap(mesh);
  for (const [options, pattern] of [
    [{ keepsPlaces: true }, /keepsPlaces needs known/],
    [{ keepsPlaces: 1, known: { ...known, uv } }, /keepsPlaces must be/],
    [{ keepsPlaces: true, known }, /its uv is not a Float64Array/],
  ])
    await assertFails(abflat, abflat.unwrap(mesh, options), 'InvalidOption', pattern);
});

test('texelDensity and udim: tiles beside each other at the scale that was asked for', async () => {
  const mesh = arraysOf(together([0, 4, 8].map((x) => [torus(24, 12), [x, 0, 0]])));
  const { report, uv } = await abflat.unwrap(mesh, {
    texelDensity: 120,
    udim: true,
    rotate: 'none',
  });
  assert.equal(report.valid, true);
  assert.equal(report.atlas.texelDensity, 120);
  assert.equal(report.options.texelDensity, 120);
  assert.ok(report.atlas.tiles > 1 && report.atlas.tiles <= 10);
  const us = uv.filter((_, i) => i % 2 === 0);
  assert.equal(Math.ceil(us.reduce((a, b) => Math.max(a, b))), report.atlas.tiles);
  await assertFails(
    abflat,
    abflat.unwrap(mesh, { texelDensity: 7e4 }),
    'AtlasTooSmall',
    /Lower the density/,
  );
});
