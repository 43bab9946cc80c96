// seams: 'hard' in JavaScript cuts what the command line program cuts.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { unwrap } from 'abflat/gltf';
import { unwrapGeometry } from 'abflat/three';
import * as THREE from 'three';
import {
  drum,
  glbBytes,
  objWithGroups,
  objWithNormals,
  plyText,
  split,
} from '../support/drums.mjs';
import { io, primitivesOf } from '../support/gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { objText } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const DRUM = drum();
const keyOf = (a, b) => `${Math.min(a, b)} ${Math.max(a, b)}`;
const RIMS = new Set(DRUM.edges.map(([a, b]) => keyOf(a, b)));

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

function edgesOf(seams, source) {
  const edges = new Set();
  for (let i = 0; i < seams.length; i += 2) {
    const [a, b] = [seams[i], seams[i + 1]].map((v) => source?.[v] ?? v);
    edges.add(keyOf(a, b));
  }
  return edges;
}

/** All rims, and a path of three edges, which opens the side. */
function assertRims({ seams, report }, source) {
  const edges = edgesOf(seams, source);
  for (const rim of RIMS) assert.ok(edges.has(rim), `${rim} is cut`);
  assert.equal(edges.size, RIMS.size + 3);
  assert.equal(report.charts.length, 3);
  assert.equal(report.valid, true);
}

test('files are cut as by the command line program', async (t) => {
  const at = tempFolder(t);
  for (const [name, text] of [
    ['normals.obj', objWithNormals(DRUM)],
    ['groups.obj', objWithGroups(DRUM)],
    ['split.ply', plyText(DRUM)],
  ])
    for (const seams of ['hard', 'auto,hard', 'hard,sharp=10', 'auto']) {
      writeFileSync(at(name), text);
      const files = ['-o', 'out.obj', '--write-seams', 'cut.txt', '-q'];
      const args = ['unwrap', name, ...files, '--seams', seams];
      assert.equal((await runAbflat(args, { cwd: at() })).code, 0);
      const bytes = new TextEncoder().encode(text);
      const result = await abflat.unwrap({ bytes, name }, { seams, obj: true });
      const rows = readFileSync(at('cut.txt'), 'utf8').match(/^\d+ \d+$/gm) ?? [];
      assert.deepEqual([...edgesOf(result.seams)].sort(), rows.sort(), `${name} ${seams}`);
      assert.equal(new TextDecoder().decode(result.obj), readFileSync(at('out.obj'), 'utf8'));
    }
});

test('arrays have normals per vertex, or per corner', async () => {
  const { positions, indices, normals, source } = split(DRUM);
  const apart = { positions: positions.flat(), indices, normals: normals.flat() };
  assertRims(await abflat.unwrap(apart, { seams: 'hard' }), source);
  const welded = {
    positions: DRUM.positions.flat(),
    indices: DRUM.faces.flat(),
    cornerNormals: Float32Array.from(indices.flatMap((v) => normals[v])),
  };
  assertRims(await abflat.unwrap(welded, { seams: 'hard' }));
  assert.equal((await abflat.inspect(apart)).normals, positions.length);
  // A vertex without a normal has those of its triangles, which differ along the side.
  const lost = positions.findIndex(([, , z]) => z > 0 && z < 2);
  const none = { ...apart, normals: normals.flatMap((n, v) => (v === lost ? [0, 0, 0] : n)) };
  const { seams } = await abflat.unwrap(none, { seams: 'hard' });
  const edges = edgesOf(seams, source);
  const middle = source[lost];
  for (const other of [middle - 24, middle + 24]) assert.ok(edges.has(keyOf(middle, other)));
});

test('a mesh that does not say which edges are hard', async () => {
  const file = { bytes: new TextEncoder().encode(objText(DRUM)), name: 'a.obj' };
  const { normals, smoothingGroups } = await abflat.inspect(file);
  assert.deepEqual([normals, smoothingGroups], [0, 0]);
  const refused = { code: 'InvalidOption', message: /neither normals nor smoothing groups/ };
  await assert.rejects(abflat.unwrap(file, { seams: 'hard' }), refused);
  const arrays = { positions: DRUM.positions.flat(), indices: DRUM.faces.flat() };
  await assert.rejects(abflat.unwrap(arrays, { seams: 'hard,auto' }), refused);
});

test('unwrapGeometry takes the normals of the geometry', async () => {
  const cylinder = new THREE.CylinderGeometry(1, 1, 2, 24, 3);
  const chartsOf = async (geometry, seams) =>
    (await unwrapGeometry(abflat, geometry, { seams })).result.report.charts.length;
  assert.equal(await chartsOf(cylinder, 'hard'), 3);
  assert.equal(await chartsOf(new THREE.BoxGeometry(), 'hard'), 6);
  // Without an index.
  assert.equal(await chartsOf(cylinder.toNonIndexed(), 'hard'), 3);
  cylinder.computeVertexNormals(); // its vertices stay apart, also along the side
  cylinder.deleteAttribute('normal');
  await assert.rejects(chartsOf(cylinder, 'hard'), { code: 'InvalidOption' });
});

test('a document is cut as by the command line program', async (t) => {
  const at = tempFolder(t);
  const uvOf = (document) =>
    primitivesOf(document).map((each) => [...each.getAttribute('TEXCOORD_0').getArray()]);
  for (const node of [
    {},
    { scale: [1, 3, 0.5], rotation: [0, 0.6, 0, 0.8] },
    { scale: [1, -2, 1], translation: [5, 0, 1] },
  ]) {
    const bytes = glbBytes(DRUM, node);
    writeFileSync(at('in.glb'), bytes);
    const args = ['unwrap', 'in.glb', '-o', 'out.glb', '-q', '--seams', 'hard'];
    assert.equal((await runAbflat(args, { cwd: at() })).code, 0);
    const document = await io.readBinary(bytes);
    let atlas;
    const onAtlas = (made) => {
      atlas = made;
    };
    await document.transform(unwrap(abflat, { seams: 'hard', onAtlas }));
    assertRims(atlas.result, split(DRUM).source);
    assert.deepEqual(uvOf(document), uvOf(await io.readBinary(readFileSync(at('out.glb')))));
  }
});
