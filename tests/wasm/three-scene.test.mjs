// unwrapScene of abflat/three: the meshes of a scene in one atlas.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { unwrapScene } from 'abflat/three';
import * as THREE from 'three';
import { complaintsAbout, densitiesOf } from '../support/scene-atlas.mjs';
import { meshesBelow, trianglesOf, yard } from '../support/three-scenes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const material = new THREE.MeshStandardMaterial();

/** A mesh with a name at a place. */
function meshOf(geometry, name, x = 0, made = new THREE.Mesh(geometry, material)) {
  made.name = name;
  made.position.x = x;
  return made;
}

const sceneOf = (...objects) => new THREE.Scene().add(...objects);

const atlasOf = (scene, attribute) =>
  meshesBelow(scene).flatMap((mesh) => trianglesOf(mesh, attribute));

/** What must hold for all scenes whose meshes have texels of their own. */
function assertGood(scene, { report }, padding) {
  const { resolution, texelDensity } = report.atlas;
  const { snapToTexels } = report.options;
  assert.ok(report.valid);
  assert.equal(report.atlas.padding, padding);
  const wanted = { resolution, padding, texelDensity, snapToTexels };
  assert.deepEqual(complaintsAbout(atlasOf(scene), wanted), []);
}

test('30 meshes, shared, scaled, turned, mirrored and in touch: one density in the world', async () => {
  const scene = yard();
  const before = meshesBelow(scene).map((mesh) => trianglesOf(mesh));
  const options = { preset: 'lightmap', resolution: 512 };
  const { result, meshes } = await unwrapScene(abflat, scene, options);
  assert.equal(meshes.length, 30);
  assertGood(scene, result, 5);
  // Every mesh shows the triangles that it did.
  for (const [i, mesh] of meshesBelow(scene).entries())
    assert.deepEqual(
      trianglesOf(mesh).map(({ places }) => places),
      before[i].map(({ places }) => places),
    );
  assert.equal(new Set(meshes.map(({ geometry }) => geometry)).size, 30);
  for (const { mesh, geometry, previous, worldScale, triangleCount } of meshes) {
    assert.equal(mesh.geometry, geometry);
    assert.notEqual(previous, geometry);
    assert.ok(worldScale > 0);
    assert.equal(geometry.index.count, 3 * triangleCount);
  }
});

test('charts begin at borders of texels, and most, which are level, also end there', async () => {
  const { result } = await unwrapScene(abflat, yard(), { preset: 'lightmap', resolution: 512 });
  const { uv, indices, chartOfTriangle, report } = result;
  const ends = report.charts.map(() => [[], []]);
  indices.forEach((vertex, c) => {
    const of = ends[chartOfTriangle[Math.floor(c / 3)]];
    for (const d of [0, 1]) of?.[d].push(512 * uv[2 * vertex + d]);
  });
  let snapped = 0;
  const offBorder = (x) => Math.abs(x - Math.round(x));
  for (const values of ends.flat()) {
    const sides = [Math.min(...values), Math.max(...values)];
    const off = sides.map(offBorder);
    assert.ok(Math.min(...off) < 0.01, `${sides}`);
    snapped += Math.max(...off) < 0.01;
  }
  assert.ok(snapped > 0.8 * 2 * ends.length, `${snapped} of ${2 * ends.length}`);
});

test('without texels of their own, meshes go on sharing a geometry, sized for the largest', async () => {
  const scene = yard();
  const { result, meshes } = await unwrapScene(abflat, scene, { resolution: 512 });
  assert.equal(new Set(meshes.map(({ geometry }) => geometry)).size, 8);
  assert.match(result.report.notes[0], /30 meshes and instances share 8 geometries.*largest/);
  const { resolution, texelDensity } = result.report.atlas;
  const densities = densitiesOf(atlasOf(scene), resolution);
  const most = Math.max(...densities.values());
  assert.ok(texelDensity > 0 && most > texelDensity);
  for (const [name, density] of densities)
    assert.ok(density > 0.99 * texelDensity, `${name}: ${density}, ${texelDensity}`);
});

test('instances share texels, sized for the largest of them, and a note says so', async () => {
  const instances = new THREE.InstancedMesh(new THREE.BoxGeometry(), material, 3);
  for (const [i, size] of [1, 3, 2].entries())
    instances.setMatrixAt(
      i,
      new THREE.Matrix4().makeScale(size, size, size).setPosition(5 * i, 0, 0),
    );
  const scene = sceneOf(
    meshOf(undefined, 'instances', 0, instances),
    meshOf(new THREE.BoxGeometry(), 'box', -5),
  );
  const { result, meshes } = await unwrapScene(abflat, scene, {
    preset: 'lightmap',
    resolution: 256,
  });
  assert.match(
    result.report.notes[0],
    /3 instances share 1 geometry.*largest.*separate meshes can have texels of their own/,
  );
  assert.equal(meshes.length, 2);
  assert.ok(Math.abs(meshes[0].worldScale - 3) < 1e-6, 'as the largest');
  const { texelDensity, resolution } = result.report.atlas;
  const densities = densitiesOf(atlasOf(scene), resolution);
  const ratio = (name) => densities.get(name) / texelDensity;
  for (const [name, wanted] of [
    ['instances 0', 3],
    ['instances 1', 1],
    ['instances 2', 1.5],
    ['box', 1],
  ])
    assert.ok(Math.abs(ratio(name) / wanted - 1) < 0.01, `${name}: ${ratio(name)}`);
});

test('weights: more texels for some, none for others', async () => {
  const names = ['one', 'twice', 'half', 'none'];
  const weights = { twice: 2, half: 0.5, none: 0 };
  const make = () =>
    sceneOf(...names.map((name, i) => meshOf(new THREE.BoxGeometry(), name, 3 * i)));
  const scene = make();
  const before = scene.children[3].geometry;
  const options = { resolution: 256, weights: ({ name }) => weights[name] };
  const { result, meshes } = await unwrapScene(abflat, scene, options);
  assert.deepEqual(
    meshes.map(({ mesh }) => mesh.name),
    names.slice(0, 3),
  );
  assert.equal(scene.children[3].geometry, before);
  const triangles = scene.children.slice(0, 3).flatMap((mesh) => trianglesOf(mesh));
  const densities = densitiesOf(triangles, 256);
  for (const name of names.slice(0, 3)) {
    const wanted = (weights[name] ?? 1) * result.report.atlas.texelDensity;
    assert.ok(Math.abs(densities.get(name) / wanted - 1) < 0.01, name);
  }
  const other = make();
  const map = new Map(other.children.map((mesh) => [mesh, weights[mesh.name] ?? 1]));
  const again = await unwrapScene(abflat, other, { resolution: 256, weights: map });
  assert.deepEqual(again.result.uv, result.uv, 'a Map says the same');
});

test('what is not drawn gets no texels: ranges, hidden objects, lines and points', async () => {
  const half = new THREE.SphereGeometry(1, 16, 8);
  half.setDrawRange(half.index.count / 2 - 3, 30);
  const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints([new THREE.Vector3()]));
  const points = new THREE.Points(new THREE.BoxGeometry());
  const hidden = new THREE.Group().add(meshOf(new THREE.BoxGeometry(), 'hidden'));
  hidden.visible = false;
  const scene = sceneOf(meshOf(half, 'half'), line, points, hidden);
  const before = trianglesOf(scene.children[0]);
  const { result, meshes } = await unwrapScene(abflat, scene, { resolution: 256 });
  assert.equal(result.indices.length, 30);
  assert.deepEqual(
    meshes.map(({ mesh }) => mesh.name),
    ['half'],
  );
  assertGood(scene, result, 2);
  const [{ geometry, previous }] = meshes;
  assert.deepEqual(geometry.drawRange, previous.drawRange);
  assert.equal(geometry.index.count, previous.index.count);
  assert.deepEqual(
    trianglesOf(scene.children[0]).map(({ places }) => places),
    before.map(({ places }) => places),
  );
  // The others stay as well.
  geometry.setDrawRange(0, Infinity);
  previous.setDrawRange(0, Infinity);
  const shown = (of) => trianglesOf(scene.children[0], 'uv1', of).map(({ places }) => places);
  assert.deepEqual(shown(geometry), shown(previous));
});

test('skins, morph targets, groups and materials', async () => {
  const box = new THREE.BoxGeometry(1, 1, 1, 2, 2, 2);
  const { count } = box.attributes.position;
  box.setAttribute('skinIndex', new THREE.BufferAttribute(new Uint16Array(4 * count), 4));
  box.setAttribute(
    'skinWeight',
    new THREE.BufferAttribute(new Float32Array(4 * count).fill(0.25), 4),
  );
  const skinned = meshOf(undefined, 'skin', 0, new THREE.SkinnedMesh(box, material));
  skinned.scale.setScalar(9); // bones place it
  const morphing = new THREE.BoxGeometry();
  morphing.morphAttributes.position = [morphing.attributes.position.clone()];
  const several = meshOf(
    undefined,
    'several',
    3,
    new THREE.Mesh(
      morphing,
      Array.from({ length: 6 }, () => new THREE.MeshBasicMaterial()),
    ),
  );
  several.morphTargetInfluences[0] = 0.7;
  const scene = sceneOf(skinned, several);
  const options = { resolution: 256, seams: 'auto,material' };
  const { result } = await unwrapScene(abflat, scene, options);
  assertGood(scene, result, 2);
  assert.equal(several.geometry.morphAttributes.position.length, 1);
  assert.equal(several.morphTargetInfluences[0], 0.7);
  assert.deepEqual(several.geometry.groups, morphing.groups);
  const ofBox = new Set([...result.chartOfTriangle].slice(-12));
  assert.equal(ofBox.size, 6, 'a chart for each material');
});

test('objects that touch are as apart as if they were far from each other', async () => {
  const at = async (distance) => {
    // A stack of boxes without lids would be one surface.
    const boxes = [0, 1, 2].map((i) => meshOf(new THREE.BoxGeometry(), `box ${i}`, i * distance));
    const scene = sceneOf(...boxes);
    const { result } = await unwrapScene(abflat, scene, { resolution: 256 });
    assertGood(scene, result, 2);
    return result.report;
  };
  const [near, far] = [await at(1), await at(10)];
  assert.equal(near.charts.length, far.charts.length);
  assert.equal(near.repair.mergedVertices, far.repair.mergedVertices);
  assert.equal(near.repair.mergedVertices, 3 * 16);
});

test('assign: false leaves the scene as it is', async () => {
  const scene = yard();
  const before = meshesBelow(scene).map(({ geometry }) => geometry);
  const { meshes } = await unwrapScene(abflat, scene, { resolution: 256, assign: false });
  assert.deepEqual(
    meshesBelow(scene).map(({ geometry }) => geometry),
    before,
  );
  assert.ok(meshes.every(({ geometry }) => geometry.attributes.uv1));
  assert.ok(before.every(({ attributes }) => !attributes.uv1));
});

/** With corners in common, so that any seam needs more vertices. */
function cubeOfEight() {
  const { attributes, index } = new THREE.BoxGeometry();
  const placeOf = (v) => ['getX', 'getY', 'getZ'].map((get) => attributes.position[get](v));
  const keys = [...new Set([...Array(24).keys()].map((v) => placeOf(v).join()))];
  const cube = new THREE.BufferGeometry();
  cube.setAttribute(
    'position',
    new THREE.Float32BufferAttribute(
      keys.flatMap((key) => key.split(',').map(Number)),
      3,
    ),
  );
  return cube.setIndex([...index.array].map((v) => keys.indexOf(placeOf(v).join())));
}

/** An instance of each geometry, side by side, with room for so many vertices each. */
function batchOf(geometries, room) {
  const batch = new THREE.BatchedMesh(20, 20_000, 60_000, material);
  for (const [i, geometry] of geometries.entries()) {
    const id = batch.addGeometry(geometry, room);
    batch.setMatrixAt(batch.addInstance(id), new THREE.Matrix4().makeTranslation(3 * i, 0, 0));
  }
  return batch;
}

/** The triangles that an instance of a BatchedMesh draws: three vertices each, `size` numbers of each. */
function drawnOf(batch, geometryId, name, size) {
  const { start, count } = batch.getGeometryRangeAt(geometryId);
  const attribute = batch.geometry.getAttribute(name);
  const { index } = batch.geometry;
  return Array.from({ length: count }, (_, i) => {
    const vertex = index ? index.getX(start + i) : start + i;
    return Array.from({ length: size }, (_, d) => attribute.getComponent(vertex, d));
  });
}

for (const kind of ['with an index', 'without'])
  test(`the geometries of a BatchedMesh stay in their ranges, ${kind}`, async () => {
    const shapes = [cubeOfEight(), new THREE.TorusGeometry(1, 0.4, 8, 16), cubeOfEight()].map(
      (shape) => {
        const bare = new THREE.BufferGeometry();
        bare.setAttribute('position', shape.attributes.position);
        bare.setIndex(shape.index);
        return kind === 'without' ? bare.toNonIndexed() : bare;
      },
    );
    const batch = batchOf(shapes, kind === 'without' ? undefined : 800);
    // Twice as large, and one that nobody sees.
    batch.setMatrixAt(batch.addInstance(0), new THREE.Matrix4().makeScale(2, 2, -2));
    batch.setVisibleAt(2, false);
    batch.deleteInstance(batch.addInstance(1));
    const ranges = () =>
      shapes.map((_, id) => {
        const { vertexStart, reservedVertexCount } = batch.getGeometryRangeAt(id);
        return [vertexStart, reservedVertexCount];
      });
    const before = {
      ranges: ranges(),
      places: [0, 1, 2].map((id) => drawnOf(batch, id, 'position', 3)),
    };
    const scene = sceneOf(batch, meshOf(new THREE.BoxGeometry(), 'box', 20));
    const { result, meshes } = await unwrapScene(abflat, scene, { resolution: 512 });
    assert.ok(result.report.valid);
    assert.deepEqual(
      meshes.map(({ mesh, geometryId }) => [mesh === batch, geometryId]),
      [
        [true, 0],
        [true, 1],
        [false, undefined],
      ],
    );
    assert.ok(Math.abs(meshes[0].worldScale - 2) < 1e-9);
    assert.match(result.report.notes.join(), /2 meshes and instances share 1 geometry/);
    assert.deepEqual(ranges(), before.ranges);
    for (const id of [0, 1, 2])
      assert.deepEqual(drawnOf(batch, id, 'position', 3), before.places[id]);
    // What is drawn has the texcoords of the result.
    for (const { geometryId, firstTriangle, triangleCount } of meshes.slice(0, 2)) {
      const uv = drawnOf(batch, geometryId, 'uv1', 2);
      const corners = result.indices.subarray(
        3 * firstTriangle,
        3 * (firstTriangle + triangleCount),
      );
      const wanted = [...corners].map((v) =>
        [...result.uv.subarray(2 * v, 2 * v + 2)].map(Math.fround),
      );
      // The largest cube is mirrored, so its triangles were turned over.
      const sorted = (list) => list.map((each) => each.join()).sort();
      assert.deepEqual(sorted(uv), sorted(wanted));
    }
    assert.ok(
      drawnOf(batch, 2, 'uv1', 2)
        .flat()
        .every((x) => x === 0),
    );
  });

test('what goes wrong leaves the scene as it was, and is said with its place', async () => {
  const wrong = new THREE.BoxGeometry();
  wrong.attributes.position.setX(3, Number.NaN);
  const beyond = new THREE.BoxGeometry();
  beyond.setIndex([0, 1, 99]);
  const batched = batchOf([cubeOfEight()]);
  const box = () => meshOf(new THREE.BoxGeometry(), 'box');
  for (const [object, options, code, pattern] of [
    [sceneOf(box(), meshOf(wrong, 'wrong')), {}, 'InvalidMesh', /"wrong": vertex 3 .* not finite/],
    [sceneOf(box(), meshOf(beyond, 'far')), {}, 'InvalidMesh', /"far": triangle 0 .* vertex 99/],
    [
      sceneOf(box(), meshOf(undefined, 'batch', 0, batched)),
      {},
      'InvalidMesh',
      /"batch".*geometry 0 of the BatchedMesh has \d+ vertices, and there is room for 8/,
    ],
    [sceneOf(box()), { resolution: 64, texelDensity: 1000 }, 'AtlasTooSmall', /./],
    [new THREE.Scene(), {}, 'EmptyMesh', /No visible mesh/],
    [new THREE.BoxGeometry(), {}, 'InvalidMesh', /Object3D/],
    [sceneOf(box()), { weights: () => -1 }, 'InvalidOption', /weight of the mesh "box".*-1/],
    [sceneOf(box()), { weights: [1] }, 'InvalidOption', /weights must be a Map/],
    [sceneOf(box()), { preset: 'light' }, 'InvalidOption', /preset.*lightmap/],
    [sceneOf(box()), { mipLevels: 1 }, 'InvalidOption', /mipLevels belongs/],
    [sceneOf(box()), { preset: 'lightmap', mipLevels: 1.5 }, 'InvalidOption', /mipLevels.*whole/],
    [sceneOf(box()), { preset: 'lightmap', mipLevels: 1, padding: 2 }, 'InvalidOption', /both/],
    [sceneOf(box()), { faceDensities: new Float32Array(12) }, 'InvalidOption', /faceDensities/],
    [sceneOf(box()), { fixedFaces: new Uint32Array(1) }, 'InvalidOption', /fixedFaces/],
    [sceneOf(box()), { colour: 1 }, 'InvalidOption', /"colour"/],
  ]) {
    const geometry = object.children?.[0]?.geometry;
    await assert.rejects(unwrapScene(abflat, object, options), (error) => {
      assert.equal(error.code, code, error.message);
      assert.match(error.message, pattern);
      return true;
    });
    assert.equal(object.children?.[0]?.geometry, geometry);
  }
  const rest = sceneOf(box(), meshOf(undefined, 'batch', 0, batched));
  const { meshes } = await unwrapScene(abflat, rest, { weights: new Map([[batched, 0]]) });
  assert.equal(meshes.length, 1);
});

test('mip levels: two free texels are left in each of them', async () => {
  const scene = yard();
  const options = { preset: 'lightmap', mipLevels: 2, resolution: 1024 };
  const { result } = await unwrapScene(abflat, scene, options);
  assertGood(scene, result, 11);
  const { texelDensity } = result.report.atlas;
  for (const level of [1, 2]) {
    const resolution = 1024 / 2 ** level;
    const smaller = { padding: 2, texelDensity: texelDensity / 2 ** level, snapToTexels: true };
    const wanted = { resolution, ...smaller };
    assert.deepEqual(complaintsAbout(atlasOf(scene), wanted), [], `level ${level}`);
  }
});

test('what geometries have in an attribute stays, and the rest goes around it', async () => {
  const scene = sceneOf(...[0, 1].map((i) => meshOf(new THREE.BoxGeometry(), `box ${i}`, 3 * i)));
  const [first] = scene.children;
  await unwrapScene(abflat, first, { resolution: 512, texelDensity: 20 });
  const kept = [...first.geometry.attributes.uv1.array];
  const { result } = await unwrapScene(abflat, scene, { resolution: 512, fixedFaces: 'uv' });
  assert.deepEqual([...first.geometry.attributes.uv1.array], kept);
  assertGood(scene, result, 2);
});
