// The meshes of benchmarks that need neither a download nor a folder beside the repository.

import assert from 'node:assert/strict';
import { readFileSync, rmSync } from 'node:fs';
import { test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { MESH_NAMES, meshName, writeMesh } from './support/mesh_files.mjs';

/** Edges that only one face has. */
function boundaryEdges(faces) {
  const edges = new Set();
  for (const face of faces)
    for (const [i, [v]] of face.entries()) {
      const [w] = face[(i + 1) % face.length];
      if (!edges.delete(`${w},${v}`)) edges.add(`${v},${w}`);
    }
  return edges.size;
}

async function written(name) {
  const { path, faces } = await writeMesh(name);
  const mesh = parseObj(readFileSync(path, 'utf8'));
  rmSync(path);
  assert.equal(mesh.faces.length, faces);
  return mesh;
}

test('a mesh is written as its name says, and refined', async () => {
  const coarse = await written('cut-sphere');
  const fine = await written('cut-sphere+1');
  assert.equal(fine.faces.length, 4 * coarse.faces.length);
  assert.ok(boundaryEdges(coarse.faces) > 0);
  assert.equal(boundaryEdges(fine.faces), 2 * boundaryEdges(coarse.faces));
  assert.equal(boundaryEdges((await written('knot-90k')).faces), 0);
});

test('names of meshes are known, and others are refused with the list of them', async () => {
  for (const name of MESH_NAMES) assert.ok(meshName(name) && meshName(`${name}+2`), name);
  for (const name of ['nose', 'bunny-4k+', 'constructor', '']) {
    assert.ok(!meshName(name), name);
    await assert.rejects(writeMesh(name), /there is no mesh .*known are .*bunny-4k/);
  }
});
