// verify: what a layout does not keep to, as the command line program says it.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { createAbflat, UV_FAULT } from 'abflat';
import { verifyDocument } from 'abflat/gltf';
import { createAbflatSync } from 'abflat/sync';
import { verifyGeometry } from 'abflat/three';
import * as THREE from 'three';
import { readSchema } from '../../scripts/lib/read-schema.mjs';
import { addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { CUBE, CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { bytesOf } from './support/meshes.mjs';
import { ROOT } from './support/paths.mjs';
import { assertSameShape, withoutSeconds } from './support/same.mjs';
import { assertFails } from './support/unwrapping.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const NO_ISLAND = 2 ** 32 - 1;

/** A square of two triangles, a triangle that runs clockwise in uv, and one without texcoords. */
const PARTS = () => ({
  positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 4, 0, 0, 5, 0, 0, 4, 1, 0, 9, 9, 9],
  indices: [0, 1, 2, 1, 3, 2, 4, 5, 6, 4, 7, 6],
  texcoords: [0.1, 0.1, 0.3, 0.1, 0.1, 0.3, 0.3, 0.3, 0.6, 0.6, 0.5, 0.6, 0.6, 0.8, Number.NaN, 0],
});
const ALL_ALLOWED = { allowMirrored: true, allowUnmapped: true };

/** Two squares that overlap, each one face of a file. */
const FACES = `${[0, 1]
  .flatMap((i) => [
    ...['0 0', '1 0', '1 1', '0 1'].map((corner) => `v ${corner} ${i}`),
    ...['0.1 0.1', '0.4 0.1', '0.4 0.4', '0.1 0.4'].map((corner) => {
      const [u, v] = corner.split(' ').map(Number);
      return `vt ${u + i / 10} ${v + i / 10}`;
    }),
    `f ${[1, 2, 3, 4].map((c) => `${4 * i + c}/${4 * i + c}`).join(' ')}`,
  ])
  .join('\n')}\n`;

const rulesOf = ({ report }) => report.findings.map(({ rule }) => rule);

test('a report says what was found, with its faces and islands; arrays say it of each triangle', async () => {
  const { report, islandOfFace, faces, faults } = await abflat.verify(PARTS());
  assert.equal(report.valid, false);
  assert.deepEqual([report.islands, report.mirrored, report.unmapped], [2, 1, 1]);
  assert.deepEqual([...islandOfFace], [0, 0, 1, NO_ISLAND]);
  assert.deepEqual([...faces], [0, 1, 2, 3]);
  assert.deepEqual([...faults], [0, 0, UV_FAULT.flipped, 0]);
  const [unmapped, flipped] = report.findings;
  assert.deepEqual([flipped.rule, flipped.faces, flipped.islands], ['flipped', [2], [1]]);
  assert.deepEqual([unmapped.rule, unmapped.faces], ['unmapped', [3]]);
  const allowed = await abflat.verify(PARTS(), ALL_ALLOWED);
  assert.deepEqual([allowed.report.valid, rulesOf(allowed)], [true, []]);
  const usual = Object.fromEntries(readSchema(ROOT).verifyOptions.map((o) => [o.name, o.default]));
  assert.deepEqual(allowed.report.options, { ...usual, ...ALL_ALLOWED });
});

test('faces of a file are its polygons', async () => {
  const file = { bytes: bytesOf(FACES), name: 'squares.obj' };
  const { report, islandOfFace, faces, faults } = await abflat.verify(file);
  assert.deepEqual([...islandOfFace], [0, 1]);
  assert.deepEqual([...faces], [0, 0, 1, 1]);
  assert.equal(faults.length, 4);
  assert.ok(faults.includes(UV_FAULT.overlapping));
  assert.deepEqual(
    report.findings.map(({ rule, faces, islands }) => [rule, faces, islands]),
    [['overlapBetween', [0, 1], [0, 1]]],
  );
  assert.equal(report.input.path, 'squares.obj');
});

test('rules are those of the program: distances, sizes and limits of the mesh', async () => {
  const rules = async (options) =>
    rulesOf(await abflat.verify(PARTS(), { ...ALL_ALLOWED, resolution: 100, ...options }));
  assert.deepEqual(await rules({ padding: 20 }), []);
  assert.deepEqual(await rules({ padding: 40 }), ['padding']);
  assert.deepEqual(await rules({ margin: 11 }), ['margin']);
  assert.deepEqual(await rules({ margin: 9, mipLevels: 1 }), ['margin']);
  assert.deepEqual(await rules({ minIslandWidth: 15 }), ['thin']);
  assert.deepEqual(await rules({ maxIslands: 1, minUtilization: 0.5 }), ['utilization', 'islands']);
  assert.deepEqual(await rules({ maxStretch: 1.01 }), ['stretch']);
});

test('other coordinates take the place of those of the mesh, in a file, too', async () => {
  const file = { bytes: bytesOf(FACES), name: 'squares.obj' };
  const apart = [0, 0.5].flatMap((u) =>
    [0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1].map((x, i) => (i % 2 === 0 ? u : 0) + 0.4 * x),
  );
  const uv = Float64Array.from(apart);
  assert.equal((await abflat.verify(file, { uv })).report.valid, true);
  assert.equal(uv.length, 24, 'it stays with the caller');
  await assertFails(
    abflat,
    abflat.verify(file, { uv: uv.slice(2) }),
    'InvalidMesh',
    /corners of triangles, not 2 for each/,
  );
});

test('wrong options, meshes without a layout and glTF are refused in a sentence', async () => {
  const { texcoords, ...bare } = PARTS();
  assert.ok(texcoords);
  await assertFails(abflat, abflat.verify(bare), 'NoTexcoords', /no layout to verify/);
  const cube = { bytes: bytesOf(CUBE), name: 'cube.obj' };
  await assertFails(abflat, abflat.verify(cube), 'NoTexcoords', /no face has texcoords/);
  const glb = { bytes: bytesOf('glTF'), name: 'mesh.glb' };
  await assertFails(abflat, abflat.verify(glb), 'UnreadableFile', /verifyDocument/);
  for (const [options, pattern] of [
    [{ maxStretches: 2 }, /no option "maxStretches".*maxStretch/],
    [{ maxStretch: 1 }, /maxStretch must be a number above 1, or none, not 1/],
    [{ padding: -1 }, /padding must be/],
    [{ resolution: [512] }, /resolution/],
    [{ allowStacked: 1 }, /allowStacked must be true or false/],
    [{ uv: [0, 0] }, /uv must be a Float/],
    [{ onProgress: 1 }, /onProgress must be a function/],
    [{ signal: {} }, /signal must be an AbortSignal/],
    [{ obj: true }, /no option "obj"/],
  ])
    await assertFails(abflat, abflat.verify(PARTS(), options), 'InvalidOption', pattern);
});

test('progress has the stages of verify, and a signal ends the call', async () => {
  const stages = new Set();
  await abflat.verify(PARTS(), {
    onProgress: ({ stage, fraction }) => stages.add(stage) && assert.ok(fraction <= 1),
  });
  assert.deepEqual([...stages], ['read', 'check']);
  const controller = new AbortController();
  const call = abflat.verify(PARTS(), { signal: controller.signal });
  controller.abort();
  await assert.rejects(call, { name: 'AbortError' });
  const { signal } = controller;
  await assert.rejects(abflat.verify(PARTS(), { signal }), { name: 'AbortError' });
  assert.equal((await abflat.verify(PARTS(), ALL_ALLOWED)).report.valid, true);
});

test('with transfer the buffers go to the worker; a call after the end is refused', async () => {
  const own = await createAbflat({ workers: 2, queue: 1 });
  const positions = Float64Array.from(PARTS().positions);
  const mesh = { ...PARTS(), positions };
  const calls = [own.verify(mesh, { transfer: true }), own.verify(PARTS()), own.pack(PARTS())];
  const [first, second] = await Promise.all(calls);
  assert.equal(positions.length, 0);
  assert.deepEqual(first.faults, second.faults);
  own.terminate();
  await assert.rejects(own.verify(PARTS()), { name: 'AbortError' });
});

test('in the calling thread it is the same, if its module is there', async () => {
  const sync = await createAbflatSync({ also: ['pack'] });
  const { timings, ...report } = sync.verify(PARTS()).report;
  const { timings: others, ...expected } = (await abflat.verify(PARTS())).report;
  assert.deepEqual(report, expected);
  assert.deepEqual(Object.keys(timings), Object.keys(others));
  sync.terminate();
  const bare = await createAbflatSync();
  assert.throws(() => bare.verify(PARTS()), /verify needs a module.*also: \['pack'\]/);
  bare.terminate();
});

const ARTIST = join(ROOT, '../shared/artist');
const artistMeshes = existsSync(ARTIST)
  ? readdirSync(ARTIST).filter((name) => name.endsWith('.obj'))
  : [];
const MESHES = [
  ['cube.obj', CUBE_OF_PARTS],
  ['squares.obj', FACES],
  ...artistMeshes.map((name) => [name, readFileSync(join(ARTIST, name), 'utf8')]),
];
const comparable = ({ timings, path, ...report }) => withoutSeconds(report);

for (const [name, text] of MESHES)
  test(`${name}: the same report as from the program`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at(name), text);
    const options = { padding: 3, resolution: [512, 256], maxStretch: 1.2, allowMirrored: true };
    const { report } = await abflat.verify({ bytes: bytesOf(text), name }, options);
    const args = ['verify', name, '--padding', '3', '--resolution', '512x256'];
    const more = ['--max-stretch', '1.2', '--allow-mirrored', '--report', 'r.json', '-q'];
    const { code, stderr } = await runAbflat([...args, ...more], { cwd: at() });
    assert.equal(code, report.valid ? 0 : 1, stderr);
    const native = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assertSameShape(report, native, 'report');
    assert.deepEqual(comparable(report), comparable(native));
  });

/** Two meshes with layouts that lie on each other, and one without. */
function documentOfThree() {
  const document = emptyDocument();
  for (const [name, mesh] of [
    ['ring', torus(8, 6)],
    ['ball', sphere(3)],
    ['bare', sphere(2)],
  ]) {
    const primitive = primitiveOf(document, mesh);
    const positions = primitive.getAttribute('POSITION');
    const { node } = addMesh(document, name, primitive);
    node.setTranslation([name.length, 0, 0]);
    if (name === 'bare') continue;
    const uv = Float32Array.from({ length: 2 * positions.getCount() }, (_, i) => (i % 7) / 7);
    const buffer = document.getRoot().listBuffers()[0];
    const accessor = document.createAccessor().setType('VEC2').setArray(uv).setBuffer(buffer);
    primitive.setAttribute('TEXCOORD_0', accessor);
  }
  return document;
}

test('the atlas of a document has the report that the program gives its file', async (t) => {
  const at = tempFolder(t);
  const document = documentOfThree();
  const before = await io.writeBinary(document);
  writeFileSync(at('in.glb'), before);
  const [{ parts, result }, ...others] = await verifyDocument(abflat, document);
  assert.equal(others.length, 0);
  assert.deepEqual(await io.writeBinary(document), before, 'the document stays as it is');
  assert.deepEqual(
    parts.map(({ mesh }) => mesh.getName()),
    ['ring', 'ball', 'bare'],
  );
  const { code } = await runAbflat(['verify', 'in.glb', '--report', 'r.json', '-q'], { cwd: at() });
  assert.equal(code, 1);
  const native = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  const { report } = result;
  for (const key of ['islands', 'mirrored', 'unmapped', 'faces', 'tiles', 'overlapping'])
    assert.deepEqual(report[key], native[key], key);
  assert.deepEqual(rulesOf(result), rulesOf({ report: native }));
});

test('meshes of a document may have atlases of their own; a set that none has is refused', async () => {
  const document = documentOfThree();
  const fractions = [];
  const atlases = await verifyDocument(abflat, document, {
    groupBy: 'mesh',
    allowOverlaps: true,
    onProgress: ({ fraction }) => fractions.push(fraction),
  });
  assert.deepEqual(
    atlases.map(({ parts }) => parts.map(({ mesh }) => mesh.getName())),
    [['ring'], ['ball']],
  );
  assert.deepEqual(
    fractions,
    [...fractions].sort((a, b) => a - b),
  );
  assert.equal(fractions.at(-1), 1);
  await assert.rejects(verifyDocument(abflat, document, { texcoord: 1 }), {
    code: 'NoTexcoords',
    message: /TEXCOORD_1/,
  });
  await assert.rejects(verifyDocument(abflat, document, { groupBy: 'all' }), /groupBy must be/);
  await assert.rejects(verifyDocument(abflat, document, { uv: [] }), /uv must be a Float/);
  await assert.rejects(verifyDocument({}, document), /await createAbflat/);
});

test('a geometry of three.js: its sides lie on each other until they are packed', async () => {
  const box = new THREE.BoxGeometry(1, 2, 3);
  const { report, islandOfFace } = await verifyGeometry(abflat, box);
  assert.equal(report.overlapping.stacked, 5);
  assert.equal(islandOfFace.length, 12);
  const allowed = await verifyGeometry(abflat, box, { allowStacked: true });
  assert.equal(allowed.report.valid, true);
  await assert.rejects(verifyGeometry(abflat, box, { attribute: 'uv1' }), {
    code: 'NoTexcoords',
    message: /no attribute uv1/,
  });
  await assert.rejects(
    verifyGeometry(abflat, new THREE.Mesh(box)),
    /verifyGeometry.*mesh\.geometry/,
  );
});
