// Several atlases for a scene, at one texel density: `pages` of unwrapScene and of abflat/gltf.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { unwrap } from 'abflat/gltf';
import { unwrapScene } from 'abflat/three';
import * as THREE from 'three';
import { accessor, assertValidFile, emptyDocument } from '../support/gltf.mjs';
import { complaintsAbout } from '../support/scene-atlas.mjs';
import { meshesBelow, trianglesOf, yard } from '../support/three-scenes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const box = () => new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshStandardMaterial());

/** A scene of boxes whose sides are these. */
function boxes(sides) {
  const scene = new THREE.Scene();
  for (const [i, side] of sides.entries()) {
    const mesh = box();
    mesh.name = `box ${i}`;
    mesh.scale.setScalar(side);
    mesh.position.x = 20 * i;
    scene.add(mesh);
  }
  return scene;
}

/** The triangles that lie on each page. */
const onPages = (meshes, pages) =>
  Array.from({ length: pages }, (_, page) =>
    meshes.filter((each) => each.page === page).flatMap(({ mesh }) => trianglesOf(mesh)),
  );

for (const [pages, resolution] of [
  [1, 512],
  [4, 256],
  [3, 256],
])
  test(`30 meshes on ${pages} pages of ${resolution}: whole, apart, one density, filled alike`, async () => {
    const scene = yard();
    const options = { preset: 'lightmap', resolution, pages };
    const { result, results, meshes } = await unwrapScene(abflat, scene, options);
    assert.equal(results.length, pages);
    assert.equal(result, results[0]);
    assert.equal(meshes.length, 30);
    assert.deepEqual(new Set(meshes.map(({ mesh }) => mesh)), new Set(meshesBelow(scene)));
    const { texelDensity } = result.report.atlas;
    for (const [page, triangles] of onPages(meshes, pages).entries()) {
      const { report } = results[page];
      assert.ok(report.valid);
      assert.equal(report.atlas.tiles, 1);
      assert.equal(report.atlas.texelDensity, texelDensity);
      const wanted = { resolution, padding: 5, texelDensity, snapToTexels: true };
      assert.deepEqual(complaintsAbout(triangles, wanted), [], `page ${page}`);
    }
    const shares = results.map(({ report }) => report.atlas.utilization);
    assert.ok(Math.min(...shares) > 0.8 * Math.max(...shares), `${shares}`);
    for (const { mesh, page, firstTriangle, triangleCount } of meshes) {
      assert.equal(mesh.geometry.index.count, 3 * triangleCount);
      assert.ok(3 * (firstTriangle + triangleCount) <= results[page].indices.length);
    }
  });

test('one page has the layout that no pages have', async () => {
  const [one, other] = [yard(), yard()];
  const options = { preset: 'lightmap', resolution: 512 };
  const plain = await unwrapScene(abflat, one, options);
  const paged = await unwrapScene(abflat, other, { ...options, pages: 1 });
  assert.deepEqual(paged.result.uv, plain.result.uv);
  assert.deepEqual(plain.results, [plain.result]);
  assert.ok(plain.meshes.every(({ page }) => page === 0));
});

test('a mesh larger than all others together has a page alone; weights count', async () => {
  const scene = boxes([1, 1, 5, 1]);
  const { meshes, results } = await unwrapScene(abflat, scene, {
    resolution: 256,
    ownTexels: true,
    pages: 2,
  });
  const pageOf = (all) =>
    all
      .map(({ mesh, page }) => [mesh.name, page])
      .sort()
      .map(([, page]) => page);
  const [a, b, large, d] = pageOf(meshes);
  assert.deepEqual([a, b, d], [a, a, a]);
  assert.notEqual(large, a);
  const density = results[0].report.atlas.texelDensity;
  assert.equal(results[1].report.atlas.texelDensity, density);
  assert.ok(
    Math.abs(
      results[large].report.atlas.utilization / results[a].report.atlas.utilization / (25 / 3) - 1,
    ) < 0.1,
  );
  const weights = ({ name }) => (name === 'box 2' ? 0.2 : 1);
  const even = await unwrapScene(abflat, boxes([1, 1, 5, 1]), {
    resolution: 256,
    ownTexels: true,
    pages: 2,
    weights,
  });
  const counts = [0, 1].map((page) => even.meshes.filter((each) => each.page === page).length);
  assert.deepEqual(counts, [2, 2]);
});

test('the geometries of a BatchedMesh are on one page, as they have one material', async () => {
  const scene = boxes([1, 1, 1]);
  const batched = new THREE.BatchedMesh(4, 400, 400, new THREE.MeshStandardMaterial());
  for (const geometry of [new THREE.BoxGeometry(), new THREE.PlaneGeometry()])
    batched.addInstance(batched.addGeometry(geometry, 100, 100));
  batched.position.y = 20;
  scene.add(batched);
  const { meshes } = await unwrapScene(abflat, scene, {
    resolution: 128,
    ownTexels: true,
    pages: 2,
  });
  const own = meshes.filter(({ mesh }) => mesh === batched);
  assert.equal(own.length, 2);
  assert.equal(own[0].page, own[1].page);
  assert.equal(meshes.length, 5);
});

test('no more pages than meshes, and a note says so', async () => {
  const { results, meshes } = await unwrapScene(abflat, boxes([1, 2]), {
    ownTexels: true,
    resolution: 128,
    pages: 5,
  });
  assert.equal(results.length, 2);
  assert.deepEqual(meshes.map(({ page }) => page).sort(), [0, 1]);
  assert.match(results[0].report.notes[0], /2 of 5 pages are used/);
});

test('a texel density that is given holds on every page, or is refused', async () => {
  const options = { ownTexels: true, resolution: 128, pages: 2 };
  const { results } = await unwrapScene(abflat, boxes([1, 1, 1, 1]), {
    ...options,
    texelDensity: 20,
  });
  assert.deepEqual(
    results.map(({ report }) => report.atlas.texelDensity),
    [20, 20],
  );
  const scene = boxes([1, 1, 1, 1]);
  const before = scene.children.map(({ geometry }) => geometry);
  await assert.rejects(unwrapScene(abflat, scene, { ...options, texelDensity: 500 }), {
    code: 'AtlasTooSmall',
  });
  assert.deepEqual(
    scene.children.map(({ geometry }) => geometry),
    before,
  );
});

test('progress rises from 0 to 1 over all pages, and a call can be cancelled', async () => {
  const told = [];
  const onProgress = ({ fraction }) => told.push(fraction);
  await unwrapScene(abflat, yard(), { preset: 'lightmap', resolution: 256, pages: 3, onProgress });
  assert.ok(told.length > 3);
  assert.deepEqual(
    told,
    [...told].sort((a, b) => a - b),
  );
  assert.ok(told.at(-1) <= 1);
  const scene = yard();
  const before = meshesBelow(scene).map(({ geometry }) => geometry);
  const controller = new AbortController();
  const call = unwrapScene(abflat, scene, {
    ...{ preset: 'lightmap', pages: 3, signal: controller.signal },
    onProgress: ({ fraction }) => fraction > 0.3 && controller.abort(new Error('enough')),
  });
  await assert.rejects(call, /enough/);
  assert.deepEqual(
    meshesBelow(scene).map(({ geometry }) => geometry),
    before,
  );
});

test('what pages cannot be is refused in one sentence', async () => {
  for (const pages of [0, -1, 1.5, '2', Number.NaN, 5000, null, [2]])
    await assert.rejects(unwrapScene(abflat, boxes([1]), { pages }), {
      code: 'InvalidOption',
      message: /^pages must be a whole number from 1 to 1024, not .*\.$/,
    });
  for (const more of [{ udim: true, texelDensity: 10 }, { fixedFaces: 'uv' }])
    await assert.rejects(unwrapScene(abflat, boxes([1]), { pages: 2, ...more }), {
      code: 'InvalidOption',
      message: /^pages does not go with (udim|fixedFaces)/,
    });
  assert.throws(() => unwrap(abflat, { pages: 2, groupBy: 'mesh' }), {
    code: 'InvalidOption',
    message: /groupBy must be 'scene', not 'mesh'/,
  });
});

/** Boxes as meshes of a document, some at several nodes. */
function documentOf(sides) {
  const document = emptyDocument();
  const { position, normal } = new THREE.BoxGeometry().attributes;
  const { index } = new THREE.BoxGeometry();
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor(document, 'VEC3', position.array.slice()))
    .setAttribute('NORMAL', accessor(document, 'VEC3', normal.array.slice()))
    .setIndices(accessor(document, 'SCALAR', Uint16Array.from(index.array)));
  const mesh = document.createMesh('box').addPrimitive(primitive);
  for (const [i, side] of sides.entries())
    document
      .getRoot()
      .listScenes()[0]
      .addChild(
        document
          .createNode(`node ${i}`)
          .setMesh(mesh)
          .setScale([side, side, side])
          .setTranslation([20 * i, 0, 0]),
      );
  return document;
}

test('a document on pages: an atlas for each, in order, with its number', async () => {
  const document = documentOf([1, 2, 1, 2, 1, 2, 1, 2]);
  const atlases = [];
  await document.transform(
    unwrap(abflat, {
      preset: 'lightmap',
      resolution: 128,
      pages: 3,
      onAtlas: (atlas) => atlases.push(atlas),
    }),
  );
  await assertValidFile(document);
  assert.deepEqual(
    atlases.map(({ page }) => page),
    [0, 1, 2],
  );
  assert.ok(atlases.every(({ texcoord, result }) => texcoord === 1 && result.report.valid));
  const densities = atlases.map(({ result }) => result.report.atlas.texelDensity);
  assert.equal(new Set(densities).size, 1);
  const meshes = atlases.flatMap(({ parts }) => parts.map(({ mesh }) => mesh));
  assert.equal(new Set(meshes).size, 8);
  assert.equal(meshes.length, 8);
  for (const { parts, result } of atlases)
    for (const { primitive, triangleCount } of parts) {
      assert.equal(primitive.getIndices().getCount(), 3 * triangleCount);
      const uv = primitive.getAttribute('TEXCOORD_1').getArray();
      assert.ok(uv.every((x) => x >= 0 && x <= 1));
      assert.ok(result.report.atlas.utilization > 0);
    }
});
