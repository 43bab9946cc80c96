// What a brush for faces touches, and what becomes of densities, without a page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PerspectiveCamera } from 'three';
import { randomNumbers } from '../support/disks.mjs';
import { sphere } from '../support/surfaces.mjs';
import { graphOf, identity, plane } from './graphs.mjs';
import { loadModule as load } from './modules.mjs';

const SIZE = [600, 400];

/** A mesh as the brush has it. `faces`: null if each triangle is a face. */
async function surfaceOf(mesh, faces = mesh.faces ?? null) {
  const { FaceSurface } = await load('surface/face-surface');
  const { Solid, withTree } = await load('surface/solid');
  const solid = new Solid(withTree(Float32Array.from(mesh.positions), mesh.indices));
  return new FaceSurface(await graphOf(mesh, faces, identity(mesh)), solid, faces ?? undefined);
}

async function sightFrom(place, at = [0, 0, 0]) {
  const { Sight } = await load('view/sight');
  const camera = new PerspectiveCamera(40, SIZE[0] / SIZE[1], 0.1, 100);
  camera.position.set(...place);
  camera.lookAt(...at);
  camera.updateProjectionMatrix();
  return new Sight(camera, ...SIZE);
}

const middle = { x: SIZE[0] / 2, y: SIZE[1] / 2 };

/** Where the middle of a face of two triangles, or one, is seen. */
function middleOf(surface, sight, face) {
  const pixels = surface
    .trianglesOf(face)
    .flatMap((f) =>
      [0, 1, 2].map((k) => sight.pixel(surface.solid.points, surface.solid.indices[3 * f + k])),
    );
  const mean = (d) => pixels.reduce((sum, pixel) => sum + pixel[d], 0) / pixels.length;
  return { x: mean('x'), y: mean('y') };
}

const away = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

test('a brush touches every face under it, also those smaller than a pixel', async () => {
  const { facesUnder } = await load('tools/faces-under');
  const n = 120;
  const mesh = plane(n);
  const surface = await surfaceOf(mesh, null);
  // Squares of about half a pixel.
  const sight = await sightFrom([n / 2, n / 2, 900], [n / 2, n / 2, 0]);
  const found = facesUnder(surface, sight, middle, 16);
  let inside = 0;
  for (let f = 0; f < mesh.indices.length / 3; ++f) {
    const distance = away(middleOf(surface, sight, f), middle);
    if (distance < 15) {
      assert.ok(found.has(f), `face ${f} is ${distance} pixels away`);
      ++inside;
    }
    if (distance > 18) assert.ok(!found.has(f), `face ${f} is ${distance} pixels away`);
  }
  assert.ok(inside > 1000);
});

test('a brush touches nothing on the far side, and nothing beside the mesh', async () => {
  const { facesUnder } = await load('tools/faces-under');
  const { positions, faces } = sphere(24);
  const indices = Uint32Array.from(
    faces.flatMap((face) => face.slice(2).flatMap((_, i) => [face[0], face[i + 1], face[i + 2]])),
  );
  const mesh = { positions: Float64Array.from(positions.flat()), indices };
  const surface = await surfaceOf(mesh, null);
  const sight = await sightFrom([0, 0, 6]);
  for (const radius of [4, 16, 40, 160]) {
    const found = facesUnder(surface, sight, middle, radius);
    assert.ok(found.size > 0);
    for (const f of found) {
      const z =
        [0, 1, 2].reduce((sum, k) => sum + mesh.positions[3 * indices[3 * f + k] + 2], 0) / 3;
      assert.ok(z > 0, `face ${f} is seen`);
    }
  }
  assert.equal(facesUnder(surface, sight, { x: 5, y: 5 }, 16).size, 0);
});

test('a polygon is touched as one, and the outline of several has no edge between two', async () => {
  const { facesUnder } = await load('tools/faces-under');
  const { FaceOutline } = await load('surface/face-outline');
  const n = 6;
  const surface = await surfaceOf(plane(n));
  const sight = await sightFrom([n / 2, n / 2, 9], [n / 2, n / 2, 0]);
  const found = facesUnder(surface, sight, { x: middle.x + 8, y: middle.y + 8 }, 4);
  assert.deepEqual([...found], [2 * n + 3]);
  assert.equal(surface.trianglesOf(2 * n + 3).length, 2);

  const outline = new FaceOutline(surface);
  const next = randomNumbers(5);
  const faces = new Set();
  const { ends, sides } = surface.graph;
  const name = (a, b) => `${Math.min(a, b)} ${Math.max(a, b)}`;
  for (let i = 0; i < 12; ++i) {
    for (let k = 0; k < 3; ++k) faces.add(Math.floor(next() * n * n));
    const pairs = outline.around(faces);
    const drawn = new Set();
    for (let p = 0; p < pairs.length; p += 2) drawn.add(name(pairs[p], pairs[p + 1]));
    for (let e = 0; e < ends.length / 2; ++e) {
      const isBorder = faces.has(sides[2 * e]) !== faces.has(sides[2 * e + 1]);
      assert.equal(drawn.has(name(ends[2 * e], ends[2 * e + 1])), isBorder);
    }
  }
  assert.equal(outline.around(new Set([0])).length, 8, 'another set begins anew');
});

test('faces ask for densities until all ask for the same', async () => {
  const { sameDensities, withDensity } = await load('model/painted-densities');
  const mesh = plane(2);
  const one = withDensity(undefined, mesh, [1], 2);
  assert.deepEqual([...one], [1, 2, 1, 1]);
  const two = withDensity(one, mesh, [3], 0.5);
  assert.deepEqual([...one], [1, 2, 1, 1], 'what was asked for before stays, for undo');
  assert.deepEqual([...two], [1, 2, 1, 0.5]);
  assert.ok(sameDensities(one, withDensity(two, mesh, [3], 1)));
  assert.ok(!sameDensities(one, two) && !sameDensities(one, undefined));
  assert.ok(sameDensities(undefined, undefined));
  assert.equal(withDensity(one, mesh, [1], 1), undefined);
  const triangles = { indices: mesh.indices };
  assert.equal(withDensity(undefined, triangles, [7], 2).length, 8);
});
