// unwrap of abflat/gltf for whole scenes: one density in the world, and meshes stay apart.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { unwrap } from 'abflat/gltf';
import * as THREE from 'three';
import {
  accessor,
  addMesh,
  assertValidFile,
  emptyDocument,
  io,
  primitiveOf,
  reread,
  trianglesOf,
} from '../support/gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { complaintsAbout, densitiesOf } from '../support/scene-atlas.mjs';
import { voxels } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { meshesBelow, yard } from '../support/three-scenes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

/** The meshes of a scene of three.js as nodes, which share what they share there. */
function documentOf(scene) {
  const document = emptyDocument();
  const made = new Map();
  scene.updateMatrixWorld(true);
  for (const { name, geometry, matrixWorld } of meshesBelow(scene)) {
    if (!made.has(geometry)) {
      const { position, normal } = geometry.attributes;
      const primitive = document
        .createPrimitive()
        .setAttribute('POSITION', accessor(document, 'VEC3', position.array.slice()))
        .setAttribute('NORMAL', accessor(document, 'VEC3', normal.array.slice()));
      if (geometry.index)
        primitive.setIndices(accessor(document, 'SCALAR', Uint16Array.from(geometry.index.array)));
      made.set(geometry, document.createMesh(name).addPrimitive(primitive));
    }
    const node = document
      .createNode(name)
      .setMesh(made.get(geometry))
      .setMatrix(matrixWorld.elements);
    document.getRoot().listScenes()[0].addChild(node);
  }
  return document;
}

/** Triangles `{ object, places, uv }` of all nodes of a document, as they are seen. */
function atlasOf(document, texcoord) {
  return document
    .getRoot()
    .listNodes()
    .flatMap((node) => {
      const matrix = new THREE.Matrix4().fromArray(node.getWorldMatrix());
      return node
        .getMesh()
        .listPrimitives()
        .flatMap((primitive) => {
          const [position, uv] = ['POSITION', `TEXCOORD_${texcoord}`].map((name) =>
            primitive.getAttribute(name),
          );
          return trianglesOf(primitive).map((corners) => {
            const seen = matrix.determinant() < 0 ? [...corners].reverse() : corners;
            const place = (v) =>
              new THREE.Vector3(...position.getElement(v, [])).applyMatrix4(matrix).toArray();
            const point = (v) => {
              const [x, y] = uv.getElement(v, []);
              return [x, 1 - y];
            };
            return { object: node.getName(), places: seen.map(place), uv: seen.map(point) };
          });
        });
    });
}

async function unwrapped(document, options) {
  const atlases = [];
  const onAtlas = (atlas) => atlases.push(atlas);
  await document.transform(unwrap(abflat, { ...options, onAtlas }));
  assert.equal(atlases.length, 1);
  await assertValidFile(document);
  return { after: await reread(document), report: atlases[0].result.report };
}

test('a light map of 30 nodes, scaled, turned, mirrored and in touch: one density in the world', async () => {
  const document = documentOf(yard());
  const { after, report } = await unwrapped(document, { preset: 'lightmap', resolution: 512 });
  assert.ok(report.valid);
  assert.equal(after.getRoot().listMeshes().length, 30);
  assert.equal(report.atlas.padding, 5);
  const { resolution, texelDensity } = report.atlas;
  const wanted = { resolution, padding: 5, texelDensity };
  assert.deepEqual(complaintsAbout(atlasOf(after, 1), wanted), []);
});

test('weights: more texels for some meshes, none for others', async () => {
  const document = emptyDocument();
  for (const [i, name] of ['one', 'twice', 'none'].entries())
    addMesh(document, name, primitiveOf(document, voxels([[[1]]], 1))).node.setTranslation([
      3 * i,
      0,
      0,
    ]);
  const [, twice] = document.getRoot().listNodes();
  const again = document.createNode('again').setMesh(twice.getMesh()).setTranslation([0, 9, 0]);
  document.getRoot().listScenes()[0].addChild(again);
  const weights = { twice: 2, none: 0 };
  const options = {
    preset: 'lightmap',
    resolution: 256,
    weights: (mesh) => weights[mesh.getName()],
  };
  const { after, report } = await unwrapped(document, options);
  const nodes = after.getRoot().listNodes();
  const none = nodes.find((node) => node.getName() === 'none');
  assert.equal(none.getMesh().listPrimitives()[0].getAttribute('TEXCOORD_1'), null);
  none.dispose();
  const densities = densitiesOf(atlasOf(after, 1), 256);
  assert.equal(densities.size, 3);
  for (const [name, weight] of [
    ['one', 1],
    ['twice', 2],
    ['again', 2],
  ]) {
    const ratio = densities.get(name) / report.atlas.texelDensity;
    assert.ok(Math.abs(ratio / weight - 1) < 0.01, `${name}: ${ratio}`);
  }
  const run = (given) => document.transform(unwrap(abflat, { ...given }));
  await assert.rejects(run({ weights: new Map([[twice.getMesh(), 1e6]]) }), /weight of mesh 1/);
  assert.throws(() => unwrap(abflat, { weights: {} }), /weights must be a Map/);
  assert.throws(() => unwrap(abflat, { preset: 'lightmaps' }), /preset must be/);
});

/** Two cubes with a face in common. */
function touchingCubes() {
  const document = emptyDocument();
  for (const x of [0, 1])
    addMesh(document, `cube ${x}`, primitiveOf(document, voxels([[[1]]], 1))).node.setTranslation([
      x,
      0,
      0,
    ]);
  return document;
}

test('meshes that touch stay apart, and the program gives the same atlas', async (t) => {
  const document = touchingCubes();
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), await io.writeBinary(document));
  const { after, report } = await unwrapped(document, { groupBy: 'scene', resolution: 256 });
  const wanted = { resolution: 256, padding: 2, texelDensity: report.atlas.texelDensity };
  assert.deepEqual(complaintsAbout(atlasOf(after, 0), wanted), []);
  const args = ['unwrap', 'in.glb', '-o', 'out.glb', '--resolution', '256', '-q'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  const native = await io.readBinary(readFileSync(at('out.glb')));
  assert.deepEqual(atlasOf(native, 0), atlasOf(after, 0));
});
