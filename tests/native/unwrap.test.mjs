// abflat unwrap: any mesh in, an atlas out.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { chartsOf, complaints, parseObj } from '../support/atlas.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { judge, MILD_DISKS, sharedMesh, withoutShared } from '../support/shared.mjs';
import { TETRAHEDRON, TRIANGLE } from '../support/small-meshes.mjs';
import * as surfaces from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** Runs unwrap on a file and reads the output. */
async function unwrapped(at, input, ...options) {
  const args = ['unwrap', input, '-o', 'out.obj', '--report', 'r.json', ...options];
  const run = await runAbflat(args, { cwd: at() });
  if (run.code > 1) return run;
  return {
    ...run,
    text: readFileSync(at('out.obj'), 'utf8'),
    report: JSON.parse(readFileSync(at('r.json'), 'utf8')),
  };
}

async function unwrappedSurface(at, surface, ...options) {
  writeFileSync(at('in.obj'), surfaces.objText(surface));
  return unwrapped(at, 'in.obj', ...options);
}

/** Asserts exit code 0, silence, and a proper atlas. */
function assertFine({ code, stderr, text, report }) {
  assert.deepEqual([code, stderr], [0, '']);
  assert.deepEqual(complaints(text), []);
  assert.equal(report.valid, true);
  assert.ok(report.atlas.utilization > 0 && report.atlas.utilization <= 1);
}

/** With sanitizers all takes ten times as long. */
const COMPONENTS = isInstrumented ? 300 : 3000;

const GENERATED = {
  sphere: () => surfaces.sphere(),
  torus: () => surfaces.torus(),
  ...Object.fromEntries(
    [2, 3, 4, 5, 6].map((genus) => [`genus ${genus}`, () => surfaces.plate(genus, 3)]),
  ),
  knot: () => surfaces.knot(),
  'Moebius strip': () => surfaces.moebius(),
  'Klein bottle': () => surfaces.kleinBottle(),
  'triangle soup': () => surfaces.triangleSoup(800),
  'unwelded torus': () => surfaces.unwelded(surfaces.torus()),
  'array of boxes': () => surfaces.boxArray(20),
  [`${COMPONENTS} small components`]: () =>
    surfaces.together(
      Array.from({ length: COMPONENTS }, (_, i) => [
        surfaces.sphere(1),
        [3 * (i % 60), 3 * Math.floor(i / 60), 0],
      ]),
    ),
  'every defect': () => surfaces.defects(),
  isosurface: () => surfaces.isosurface(isInstrumented ? 10 : 20),
  'isosurface with tiny triangles': () =>
    surfaces.withTinyTriangles(surfaces.isosurface(isInstrumented ? 8 : 12)),
};

for (const [name, make] of Object.entries(GENERATED))
  test(`${name} becomes an atlas`, async (t) => {
    const at = tempFolder(t);
    const run = await unwrappedSurface(at, make());
    assertFine(run);
    assert.equal(chartsOf(parseObj(run.text)).count >= run.report.charts.length, true);
    if (withoutShared) return t.diagnostic(`not judged: ${withoutShared}`);
    const judged = judge(at('in.obj'), at('out.obj'));
    assert.deepEqual(judged.failures, []);
    assert.ok(Math.abs(judged.symmetricDirichlet - run.report.symmetricDirichlet) < 1e-3);
  });

const SHARED = [
  ...MILD_DISKS,
  'camel-cut.obj',
  'cow-cut.off',
  'bunny-closed.off',
  'spot-uv.obj',
  'fertility-genus4.off',
  'genus3.off',
  'suzanne-quads.obj',
  'halftunnel-quads.off',
  'teapot-5parts.obj',
  'beetle-nonmanifold.obj',
];

for (const file of SHARED)
  test(`${file} becomes an atlas`, { skip: withoutShared }, async (t) => {
    const at = tempFolder(t);
    assertFine(await unwrapped(at, sharedMesh(file)));
    assert.deepEqual(judge(sharedMesh(file), at('out.obj')).failures, []);
  });

test('what is wrong with a mesh is in the report, with its places', async (t) => {
  const at = tempFolder(t);
  const mesh = surfaces.defects();
  const faces = mesh.faces.length;
  const n = mesh.positions.length;
  mesh.faces.push([n - 5, n - 4, n - 3, n - 5, n - 2, 0]);
  const { report } = await unwrappedSurface(at, mesh);
  const { repair } = report;
  assert.ok(repair.mergedVertices >= 1);
  assert.deepEqual(repair.collapsedFaces, [faces - 2, faces - 1]);
  assert.deepEqual(repair.splitFaces, [faces]);
  assert.deepEqual(repair.duplicateFaces.slice(0, 2), [
    [faces - 7, 0],
    [faces - 6, 0],
  ]);
  assert.ok(repair.nonManifoldEdges.length >= 1);
  assert.ok(repair.orientationConflicts.length >= 1);
});

test('loops that cut handles open are counted and measured', async (t) => {
  const seamsOf = async (surface) =>
    (await unwrappedSurface(tempFolder(t), surface, '--seams', 'none')).report.seams;
  const opened = await seamsOf(surfaces.plate(3, 3));
  assert.equal(opened.handleLoops, 6);
  assert.ok(opened.handleLength > 0);
  assert.ok(Math.abs(opened.handleLength - opened.relativeLength) < 1e-9);
  const disk = await seamsOf(surfaces.sheet(4, 4, (i, j) => [i, j, 0]));
  assert.deepEqual([disk.handleLoops, disk.handleLength], [0, 0]);
});

test('the 47 edges of beetle with more than two faces are cut and named', {
  skip: withoutShared,
}, async (t) => {
  const { report } = await unwrapped(tempFolder(t), sharedMesh('beetle-nonmanifold.obj'));
  assert.equal(report.repair.nonManifoldEdges.length, 47);
});

test('only texcoords change in an OBJ text', async (t) => {
  const at = tempFolder(t);
  const surface = surfaces.plate(2);
  const half = surface.faces.length / 2;
  const lines = surfaces
    .objText(surface, 'vn 0 0 1\nvt 0.5 0.5\no thing\nusemtl red\n')
    .split('\n');
  const first = lines.findIndex((line) => line.startsWith('f '));
  lines.splice(first + half, 0, 's 1', 'g second # a comment', 'usemtl blue');
  const source = lines.map((line) =>
    line.startsWith('f ') ? line.replaceAll(/(\d+)/g, '$1/1/1') : line,
  );
  writeFileSync(at('in.obj'), source.join('\n'));
  const { code, text } = await unwrapped(at, 'in.obj');
  assert.equal(code, 0);
  const rest = (content) =>
    content
      .split('\n')
      .filter((line) => !line.startsWith('vt '))
      .map((line) => (line.startsWith('f ') ? line.replaceAll(/\/\d+\//g, '//') : line))
      .join('\n');
  assert.equal(rest(text), rest(source.join('\n')));
});

/** Interior angles of all corners in uv. */
function anglesOf(text) {
  const { texcoords, faces } = parseObj(text);
  return faces.flatMap((face) =>
    face.map(([, t], i) => {
      const at = (k) =>
        texcoords[face[(i + k) % face.length][1]].map((x, d) => x - texcoords[t][d]);
      const [a, b] = [at(1), at(face.length - 1)];
      return Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    }),
  );
}

test('a disk without seams is what flatten makes of it, packed', async (t) => {
  const at = tempFolder(t);
  for (const sample of ['hemisphere', 'head', 'alpha-band', 'three-balls']) {
    await runAbflat(['sample', sample, '-o', 'in.obj'], { cwd: at() });
    await runAbflat(['flatten', 'in.obj', '-o', 'flat.obj', '--report', 'f.json'], { cwd: at() });
    const { text, report } = await unwrapped(at, 'in.obj', '--seams', 'none', '--balance', '0');
    assert.equal(report.charts.length, 1);
    if (sample === 'alpha-band') {
      // Which bounds keep its ends apart depends on the order of its vertices, which differs.
      const [flat] = JSON.parse(readFileSync(at('f.json'), 'utf8')).charts;
      assert.ok(report.charts[0].angularDistortion < 1.1 * flat.angularDistortion);
      continue;
    }
    const wanted = anglesOf(readFileSync(at('flat.obj'), 'utf8'));
    const largest = anglesOf(text).reduce(
      (most, angle, i) => Math.max(most, Math.abs(angle - wanted[i])),
      0,
    );
    assert.ok(largest < 1e-8, `${sample}: ${largest}`);
  }
});

/** Per unit, the chart of each face. */
async function chartsInUnits(at, size, ...args) {
  const surface = surfaces.isosurface(size);
  const charts = [];
  for (const scale of isInstrumented ? [1e-6, 1] : [1e-6, 1e-3, 1, 1e6]) {
    const positions = surface.positions.map((p) => p.map((x) => x * scale));
    const run = await unwrappedSurface(at, { ...surface, positions }, ...args);
    assertFine(run);
    charts.push(chartsOf(parseObj(run.text)).ofFace);
  }
  return charts;
}

test('charts do not depend on the unit', async (t) => {
  const at = tempFolder(t);
  for (const size of isInstrumented ? [8] : [8, 9, 11]) {
    const charts = await chartsInUnits(at, size);
    for (const other of charts) assert.deepEqual(other, charts[0]);
  }
});

test('without padding inside charts to hold, charts of a twisted surface do not depend on the unit', async (t) => {
  const at = tempFolder(t);
  for (const size of isInstrumented ? [7] : [7, 10]) {
    const charts = await chartsInUnits(at, size, '--padding', '0');
    for (const other of charts) assert.deepEqual(other, charts[0]);
  }
});

test('split vertices do not change the charts', async (t) => {
  const at = tempFolder(t);
  const whole = await unwrappedSurface(at, surfaces.plate(1));
  const split = await unwrappedSurface(at, surfaces.unwelded(surfaces.plate(1)));
  assert.deepEqual(chartsOf(parseObj(split.text)), chartsOf(parseObj(whole.text)));
  assert.deepEqual(parseObj(split.text).texcoords, parseObj(whole.text).texcoords);
});

test('seams can be written, and give the same atlas when they are read', async (t) => {
  const at = tempFolder(t);
  // A chart that is cut for packing keeps its layout; if the cut is read as a seam, it is flattened
  // again.
  const whole = ['--min-utilization', '0'];
  const first = await unwrappedSurface(
    at,
    surfaces.torus(),
    '--write-seams',
    'seams.txt',
    ...whole,
  );
  const again = await unwrapped(at, 'in.obj', '--seams', 'file=seams.txt');
  assertFine(again);
  assert.equal(again.text, first.text);
  assert.equal(
    readFileSync(at('seams.txt'), 'utf8').split('\n').length - 1,
    first.report.seams.edges,
  );
});

test('sharp edges of a box are its seams', async (t) => {
  const run = await unwrappedSurface(
    tempFolder(t),
    surfaces.voxels([[[1]]], 3),
    '--seams',
    'sharp=60',
  );
  assertFine(run);
  assert.equal(run.report.charts.length, 6);
  assert.equal(run.report.seams.edges, 36);
  assert.ok(Math.abs(run.report.symmetricDirichlet - 1) < 1e-9);
});

test('less stretch takes more seams', async (t) => {
  const at = tempFolder(t);
  const rows = [];
  for (const stretch of ['1.5', '1.02']) {
    const options = ['--max-stretch', stretch, '--min-utilization', '0'];
    rows.push((await unwrappedSurface(at, surfaces.knot(), ...options)).report);
  }
  assert.ok(rows[0].seams.relativeLength < rows[1].seams.relativeLength);
  assert.ok(rows[0].symmetricDirichlet > rows[1].symmetricDirichlet);
});

test('any number of threads writes the same bytes', async (t) => {
  const at = tempFolder(t);
  const surface = surfaces.isosurface(isInstrumented ? 10 : 24);
  const one = await unwrappedSurface(at, surface, '--threads', '1');
  const three = await unwrappedSurface(at, surface, '--threads', '3');
  assert.equal(three.report.threads, 3);
  assert.equal(three.text, one.text);
});

test('PLY is written in single precision, and is valid as written', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), surfaces.objText(surfaces.knot()));
  const run = await runAbflat(['unwrap', 'in.obj', '-o', 'out.ply'], { cwd: at() });
  assert.deepEqual([run.code, run.stderr], [0, '']);
  const header = readFileSync(at('out.ply'), 'latin1').split('end_header')[0];
  assert.match(header, /property float s\nproperty float t\n/);
});

test('small meshes', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), TRIANGLE);
  assertFine(await unwrapped(at, 'in.obj'));
  writeFileSync(at('in.off'), TETRAHEDRON);
  assertFine(await unwrapped(at, 'in.off'));
});

test('what cannot be done is one sentence', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), surfaces.objText(surfaces.sphere(1)));
  writeFileSync(at('none.obj'), 'v 0 0 0\n');
  writeFileSync(at('flat.obj'), 'v 0 0 0\nv 1 0 0\nf 1 2 2\n');
  writeFileSync(at('bad.txt'), '1 2\n1 2 3\n');
  writeFileSync(at('far.txt'), '0 99\n');
  writeFileSync(at('diagonal.txt'), '# no edge\n0 7\n');
  for (const [args, code, message] of [
    [['none.obj'], 4, /^abflat: none\.obj: the mesh has no faces\.\n$/],
    [['flat.obj'], 4, /^abflat: flat\.obj: every face has fewer than three distinct corners\.\n$/],
    [['in.obj', '--seams', 'file=bad.txt'], 3, /^abflat: bad\.txt:2: expected two vertex numbers/],
    [
      ['in.obj', '--seams', 'file=far.txt'],
      2,
      /seam 0-99 refers to vertex 99, but there are only 8/,
    ],
    [['in.obj', '--seams', 'file=diagonal.txt'], 2, /seam 0-7 is not an edge of any face/],
    [['in.obj', '--seams', 'file=missing.txt'], 3, /missing\.txt/],
    [
      ['in.obj', '--seams', 'sideways'],
      2,
      /--seams: 'sideways' is not auto, hard, uv, material, none or sharp=DEGREES/,
    ],
    [['in.obj', '--seams', 'none,auto'], 2, /--seams: none cannot be combined with other seams/],
    [['in.obj', '--seams', 'sharp=200'], 2, /--seams: 'sharp=200' is not/],
    [['in.obj', '--max-stretch', '1'], 2, /--max-stretch: must be a number above 1, not 1/],
    [['in.obj', '--write-seams', 'in.obj'], 2, /--write-seams: would replace the input/],
  ]) {
    const run = await runAbflat(['unwrap', ...args, '-o', 'out.obj'], { cwd: at() });
    assert.equal(run.code, code, `${args}: ${run.stderr}`);
    assert.match(run.stderr, message);
    assert.throws(() => readFileSync(at('out.obj')));
  }
});
