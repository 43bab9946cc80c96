// What other unwrappers write, verified: xatlas through watlas, and Blender's Smart UV Project
// where there is a Blender. Exact integers say what should be found.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import * as watlas from 'watlas';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { readAtlas } from '../support/exact-atlas.mjs';
import { ordinaryShapes } from '../support/ordinary-shapes.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { expectedFaces } from '../support/verify-agreement.mjs';

const SCRIPT = fileURLToPath(new URL('../support/smart-uv.py', import.meta.url));
const skip = spawnSync('blender', ['--version']).status === 0 ? false : 'there is no Blender';

/** Names and texts of meshes: ordinary shapes, and real ones where they are. */
function meshes() {
  const out = ordinaryShapes().map(({ name, points, faces }) => [
    name.replaceAll(/\W+/g, '-'),
    [
      ...points.map((p) => `v ${p.join(' ')}`),
      ...faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}`),
      '',
    ].join('\n'),
  ]);
  for (const folder of ['artist', 'meshes2'].map((name) => join(ROOT, '../shared', name)))
    if (existsSync(folder))
      for (const file of readdirSync(folder).filter((name) => name.endsWith('.obj')))
        out.push([file.slice(0, -4), readFileSync(join(folder, file), 'utf8')]);
  // xatlas takes minutes for larger ones.
  return out.filter(([, text]) => text.match(/^f /gm).length < 15000);
}

async function verified(at, file) {
  const { stderr } = await runAbflat(['verify', file, '-q', '--report', 'r.json'], { cwd: at() });
  assert.equal(stderr, '');
  return JSON.parse(readFileSync(at('r.json'), 'utf8'));
}

/** Faces as fans of triangles, so that all cut polygons alike. */
function asTriangles(at, text) {
  writeFileSync(at('polygons.obj'), text);
  return readAtlas(at('polygons.obj')).faces.flatMap(([first, ...rest]) =>
    rest.slice(1).map((corner, i) => [first, rest[i], corner]),
  );
}

const objOf = (faces, uvOf) => {
  const lines = faces.flatMap((face, f) => [
    ...face.map(({ place }) => `v ${place.join(' ')}`),
    ...(uvOf ? face.map((_, k) => `vt ${uvOf(f, k).join(' ')}`) : []),
    `f ${[1, 2, 3].map((k) => (uvOf ? `${3 * f + k}/${3 * f + k}` : 3 * f + k)).join(' ')}`,
  ]);
  return `${lines.join('\n')}\n`;
};

function byWatlas(faces) {
  const atlas = new watlas.Atlas();
  const positions = new Float32Array(faces.flat().flatMap(({ place }) => place));
  atlas.addMesh({
    vertexPositionData: positions,
    vertexCount: positions.length / 3,
    vertexPositionStride: 12,
    indexData: Uint32Array.from({ length: positions.length / 3 }, (_, i) => i),
  });
  atlas.generate({}, { padding: 2 });
  const mesh = atlas.getMesh(0);
  const index = new Uint32Array(mesh.indexCount);
  mesh.getIndexArray(index);
  const size = [atlas.width, atlas.height];
  const uv = Array.from({ length: mesh.vertexCount }, (_, v) => mesh.getVertex(v).uv);
  atlas.delete();
  return (f, k) => uv[index[3 * f + k]].map((x, d) => x / size[d]);
}

test('layouts of xatlas', async (t) => {
  await watlas.Initialize();
  const at = tempFolder(t);
  let overlapping = 0;
  const all = meshes();
  for (const [name, text] of all) {
    const faces = asTriangles(at, text);
    const uvOf = byWatlas(faces);
    writeFileSync(at('out.obj'), objOf(faces, uvOf));
    const report = await verified(at, 'out.obj');
    assert.deepEqual(
      report.faces,
      expectedFaces(faces.map((_, f) => [0, 1, 2].map((k) => uvOf(f, k)))),
      name,
    );
    overlapping += report.faces.overlapping > 0;
  }
  t.diagnostic(`${overlapping} of ${all.length} overlap`);
});

test("layouts of Blender's Smart UV Project", { skip }, async (t) => {
  const at = tempFolder(t);
  const names = [];
  for (const [name, text] of meshes()) {
    writeFileSync(at(`${name}.obj`), objOf(asTriangles(at, text)));
    names.push(name);
  }
  const files = names.flatMap((name) => [at(`${name}.obj`), at(`${name}-uv.obj`)]);
  const args = ['-b', '--factory-startup', '--python-exit-code', '1', '--python', SCRIPT, '--'];
  const { status, stderr } = spawnSync('blender', [...args, ...files], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  const crossing = [];
  for (const name of names) {
    const { faces } = readAtlas(at(`${name}-uv.obj`));
    const report = await verified(at, `${name}-uv.obj`);
    const triangles = faces.map((face) => face.map(({ uv }) => uv));
    assert.deepEqual(report.faces, expectedFaces(triangles), name);
    if (report.faces.overlapping > 0) crossing.push(name);
  }
  t.diagnostic(`${crossing.length} of ${names.length} overlap: ${crossing.join(', ')}`);
});
