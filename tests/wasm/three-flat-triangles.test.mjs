// Triangles without area of three.js' own geometries: at poles, where profiles touch the axis.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { unwrapGeometry, unwrapScene } from 'abflat/three';
import * as THREE from 'three';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

/** A letter with two holes. */
function letter() {
  const shape = new THREE.Shape().moveTo(0, 0).lineTo(0, 2).lineTo(0.8, 2);
  shape
    .bezierCurveTo(1.6, 2, 1.6, 1.1, 0.9, 1.05)
    .bezierCurveTo(1.9, 1, 1.8, 0, 0.9, 0)
    .lineTo(0, 0);
  for (const y of [0.5, 1.5])
    shape.holes.push(new THREE.Path().absellipse(0.6, y, 0.3, 0.22, 0, 2 * Math.PI, true, 0));
  return new THREE.ShapeGeometry(shape, 12);
}

const onAxis = (...points) =>
  new THREE.LatheGeometry(
    points.map(([x, y]) => new THREE.Vector2(x, y)),
    16,
  );

/** With the number of triangles without area that each has. */
const GEOMETRIES = {
  sphere: [new THREE.SphereGeometry(1, 16, 8), 0],
  capsule: [new THREE.CapsuleGeometry(0.5, 1, 8, 16), 32],
  'capsule without a middle': [new THREE.CapsuleGeometry(1, 0, 6, 12), 48],
  cone: [new THREE.ConeGeometry(1, 2, 12, 2), 0],
  torus: [new THREE.TorusGeometry(1, 0.4, 8, 16), 0],
  disc: [new THREE.RingGeometry(0, 1, 16, 2), 16],
  spinning: [onAxis([0, 0], [0, 0.5], [1, 0.5], [1, 1], [0, 1]), 64],
  letter: [letter(), 0],
  tetrahedra: [new THREE.TetrahedronGeometry(1, 1), 0],
};

/** Longest sides of triangles without area: { onSurface, inAtlas } in the unit of the surface. */
function flatSides({ uv, indices, vertexMap, report }, { position }) {
  const { resolution, texelDensity } = report.atlas;
  const place = (v) => new THREE.Vector3().fromBufferAttribute(position, vertexMap[v]);
  const point = (v) => new THREE.Vector3(uv[2 * v], uv[2 * v + 1], 0);
  const longest = ([a, b, c]) => Math.max(a.distanceTo(b), b.distanceTo(c), c.distanceTo(a));
  const found = [];
  for (let c = 0; c < indices.length; c += 3) {
    const corners = [...indices.subarray(c, c + 3)];
    const places = corners.map(place);
    if (new THREE.Triangle(...places).getArea() > 1e-7 * longest(places) ** 2) continue;
    const inAtlas = (longest(corners.map(point)) * resolution) / texelDensity;
    found.push({ onSurface: longest(places), inAtlas });
  }
  return found;
}

test('triangles without area lie beside their neighbours, no longer than they are', async () => {
  for (const [name, [geometry, count]] of Object.entries(GEOMETRIES)) {
    const { result } = await unwrapGeometry(abflat, geometry, { attribute: 'uv1' });
    assert.ok(result.report.valid, name);
    const flat = flatSides(result, geometry.attributes);
    assert.equal(flat.length, count, name);
    for (const { onSurface, inAtlas } of flat)
      assert.ok(inAtlas <= 1.5 * onSurface, `${name}: ${inAtlas} for ${onSurface}`);
  }
});

test('so they do in a scene', async () => {
  const scene = new THREE.Scene();
  for (const [geometry] of Object.values(GEOMETRIES)) {
    const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial());
    mesh.position.x = 3 * scene.children.length;
    scene.add(mesh);
  }
  const { result, meshes } = await unwrapScene(abflat, scene, { resolution: 512 });
  const { resolution, texelDensity } = result.report.atlas;
  for (const { geometry, previous } of meshes) {
    const { array } = geometry.attributes.uv1;
    const layout = { uv: array, indices: geometry.index.array, report: result.report };
    const vertexMap = Uint32Array.from(array, (_, i) => i);
    for (const { onSurface, inAtlas } of flatSides({ ...layout, vertexMap }, geometry.attributes))
      assert.ok(inAtlas <= 1.5 * onSurface + 1e-3, `${previous.type}: ${inAtlas}`);
  }
  assert.ok(resolution === 512 && texelDensity > 0);
});
