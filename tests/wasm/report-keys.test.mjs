// Every key of every report of the package is in the schema, and every key of the schema is in a report.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { drum, objWithGroups, objWithNormals } from '../support/drums.mjs';
import { ReportKeys } from '../support/report-keys.mjs';
import {
  EMPTY_IN_UV,
  foldingPins,
  MIRROR_IMAGES,
  NEEDLE,
  overlappingIslands,
  rough,
  stellated,
  TOUCHING,
} from '../support/report-meshes.mjs';
import { CUBE_OF_PARTS, grid as gridText } from '../support/small-meshes.mjs';
import { defects, knot, objText, sphere, torus, windows } from '../support/surfaces.mjs';
import { bytesOf, grid } from './support/meshes.mjs';
import { arraysOf } from './support/unwrapping.mjs';

const keys = new ReportKeys('package');
/** In flatten, only the research solvers have linear iterations. */
const RESEARCH = ['NewtonStep.linearIterations'];

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const file = (text) => ({ bytes: bytesOf(text), name: 'mesh.obj' });

async function flatten(mesh, options) {
  keys.check((await abflat.flatten(mesh, options)).report, 'Report');
}

async function unwrap(mesh, options) {
  const result = await abflat.unwrap(mesh, options);
  keys.check(result.report, 'UnwrapReport');
  return result;
}

test('flatten', async () => {
  const mesh = () => grid(6);
  const corners = [0, 6, 48, 42];
  const uv = [
    [0.1, 0.2],
    [0.7, 0.3],
    [0.8, 0.9],
    [0.05, 0.85],
  ];
  const pins = corners.map((vertex, i) => ({ vertex, uv: uv[i] }));
  await flatten(mesh(), { t: 1, delaunay: true, bounds: [{ vertex: 3, t: 0.9 }] });
  await flatten(await abflat.sample('head'), { t: 1, delaunay: true });
  await flatten(mesh(), { pins });
  await flatten(mesh(), { straight: [{ from: 0, to: 6 }], balance: 0.5 });
  await flatten(grid(70), { t: 2, memory: 1 });
  await flatten(await abflat.sample('alpha-band'), { t: 2, untangle: 'none' });
  await flatten(file(stellated()), { t: 1, delaunay: true });
  await flatten(file(rough(2)), { t: 1 });
  await flatten(file(NEEDLE));
  await flatten(file(gridText(4)), { pins: foldingPins(4) });
});

test('pack', async () => {
  for (const mesh of [overlappingIslands(), EMPTY_IN_UV])
    for (const keepPlaces of [false, true]) {
      const { report } = await abflat.pack(file(mesh), { keepPlaces });
      keys.check(report, 'PackReport');
    }
});

test('verify', async () => {
  for (const mesh of [overlappingIslands(), EMPTY_IN_UV]) {
    const { report } = await abflat.verify(file(mesh), { margin: 2 });
    keys.check(report, 'VerifyReport');
  }
});

test('unwrap', async () => {
  for (const text of [objText(defects()), NEEDLE, TOUCHING]) await unwrap(file(text));
  await unwrap(file(objText(defects())), { orient: true });
  await unwrap(file(MIRROR_IMAGES), { stack: 'mirrored' });
  await unwrap(arraysOf(knot()), { straightSeams: true });
  await unwrap(arraysOf(windows(3)), { balance: 1 });
  const pins = [0, 6].map((vertex, i) => ({ vertex, uv: [0.1 + 0.3 * i, 0.2] }));
  await unwrap(grid(6), { pins });
  await unwrap(grid(70), { memory: 1 });
  await unwrap(file(gridText(4)), { pins: foldingPins(4) });
  await unwrap(arraysOf(sphere()), { minUtilization: 0.9, symmetricSeams: 'always' });
});

test('inspect and compare', async () => {
  const shaded = [file(objWithNormals(drum())), file(objWithGroups(drum()))];
  for (const mesh of [file(CUBE_OF_PARTS), ...shaded, arraysOf(torus()), arraysOf(defects())])
    keys.check(await abflat.inspect(mesh), 'MeshSummary');
  for (const mesh of [await abflat.sample('alpha-band'), file(rough(2))]) {
    const { indices, vertexMap, positions, ...report } = await abflat.compare(mesh);
    assert.ok(indices.length > 0 && vertexMap.length > 0);
    assert.equal(positions !== undefined, 'bytes' in mesh);
    keys.check(report, 'ComparisonReport');
  }
});

after(() => {
  const unseen = keys.unseen('Report', 'UnwrapReport', 'ComparisonReport');
  assert.deepEqual(
    [...new Set(unseen)].filter((path) => !RESEARCH.includes(path)),
    [],
    'fields that no report has',
  );
});
