// Seams that are painted, without a page: the path that a stroke leaves, nearby paths, and pixels.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PerspectiveCamera } from 'three';
import { randomNumbers } from '../support/disks.mjs';
import { graphOf, plane } from './graphs.mjs';
import { loadModule as load } from './modules.mjs';

const N = 8;
const at = (x, y) => (N + 1) * y + x;

/** A trail on a grid, which is led from place to place by shortest paths. */
async function trailFrom(start, graph) {
  const { NearbyPaths } = await load('surface/nearby-paths');
  const { Trail } = await load('seams/trail');
  const paths = new NearbyPaths(graph);
  const trail = new Trail(graph, start);
  const lead = (...places) => {
    for (const place of places) trail.follow(paths.between(trail.end, place, 1000));
  };
  return { trail, lead };
}

/** Each edge leads from one of its places to the next one. */
async function assertConnected({ places, edges }, graph) {
  const { otherEnd } = await load('surface/surface-graph');
  assert.equal(places.length, edges.length + 1);
  edges.forEach((edge, i) => {
    assert.equal(otherEnd(graph, edge, places[i]), places[i + 1]);
  });
}

test('a trail goes where it is led, not straight to its end', async () => {
  const graph = await graphOf(plane(N));
  const { trail, lead } = await trailFrom(at(0, 0), graph);
  lead(at(4, 0), at(4, 4), at(0, 4));
  assert.equal(trail.edges.length, 12);
  assert.ok(trail.places.includes(at(4, 2)));
  await assertConnected(trail, graph);
});

test('a trail that goes back is taken back, step by step or at once', async () => {
  const graph = await graphOf(plane(N));
  for (const back of [[at(4, 0), at(3, 0), at(2, 0)], [at(2, 0)]]) {
    const { trail, lead } = await trailFrom(at(0, 0), graph);
    lead(at(5, 0), ...back);
    assert.deepEqual(trail.places, [at(0, 0), at(1, 0), at(2, 0)]);
    // From there to the side, beginning behind the place that it has gone back to.
    lead(at(4, 0), at(1, 1));
    assert.ok(trail.edges.length <= 3);
    await assertConnected(trail, graph);
    lead(at(0, 0));
    assert.deepEqual(trail.edges, []);
  }
});

test('a trail closes a loop, and is not taken back by that', async () => {
  const graph = await graphOf(plane(N));
  const { trail, lead } = await trailFrom(at(2, 2), graph);
  // Around one square.
  lead(at(3, 2), at(3, 3), at(2, 3), at(2, 2));
  assert.equal(trail.edges.length, 4);
  assert.equal(trail.end, trail.places[0]);
  await assertConnected(trail, graph);
  // Back along it from its end.
  lead(at(2, 3), at(3, 3));
  assert.equal(trail.edges.length, 2);
});

test('nearby paths are as short as those of a search everywhere, one after another', async () => {
  const { NearbyPaths } = await load('surface/nearby-paths');
  const { ShortestPaths } = await load('surface/shortest-paths');
  const next = randomNumbers(3);
  const mesh = plane(N);
  for (let i = 0; i < mesh.positions.length; ++i) mesh.positions[i] += 0.5 * next();
  const graph = await graphOf(mesh, null);
  const nearby = new NearbyPaths(graph);
  const { length } = graph.places;
  for (let i = 0; i < 200; ++i) {
    const [from, to] = [Math.floor(next() * length), Math.floor(next() * length)];
    const all = new ShortestPaths(graph, from);
    const found = nearby.between(from, to, length);
    const sum = found.reduce((total, edge) => total + graph.lengths[edge], 0);
    assert.ok(Math.abs(sum - all.distanceTo(to)) < 1e-12);
  }
});

test('a nearby path is not looked for farther than asked, nor where there is none', async () => {
  const { NearbyPaths } = await load('surface/nearby-paths');
  const mesh = plane(N);
  const nearby = new NearbyPaths(await graphOf(mesh));
  assert.equal(nearby.between(at(0, 0), at(N, N), 20), null);
  assert.equal(nearby.between(at(0, 0), at(2, 0), 20).length, 2);
  assert.deepEqual(nearby.between(at(0, 0), at(0, 0), 20), []);
  const apart = { positions: [...mesh.positions, 9, 9, 9], indices: mesh.indices };
  const alone = new NearbyPaths(await graphOf({ ...apart, faces: mesh.faces }));
  assert.equal(alone.between(at(0, 0), at(N, N) + 1, Infinity), null);
});

test('the places of a stroke are evenly apart, and not too many of them', async () => {
  const { pixelsAlong } = await load('view/strokes');
  assert.deepEqual(
    pixelsAlong([
      { x: 0, y: 0 },
      { x: 20, y: 0 },
      { x: 20, y: 20 },
    ]),
    [
      { x: 8, y: 0 },
      { x: 16, y: 0 },
      { x: 20, y: 4 },
      { x: 20, y: 12 },
      { x: 20, y: 20 },
    ],
  );
  const here = { x: 3, y: 4 };
  assert.deepEqual(pixelsAlong([here, here, here]), [here]);
  const far = pixelsAlong([here, { x: 5000, y: 4000 }]);
  assert.ok(far.length > 10 && far.length < 50, `${far.length}`);
});

test('a brush meets the edges that it goes over: at a junction only those it goes along', async () => {
  const { edgesUnder } = await load('seams/brush');
  const { Sight } = await load('view/sight');
  const graph = await graphOf(plane(2));
  const camera = new PerspectiveCamera(50, 1, 0.1, 100);
  camera.position.set(1, 1, 4);
  camera.lookAt(1, 1, 0);
  const sight = new Sight(camera, 400, 400);
  const points = plane(2).positions;
  const solid = { points, firstHit: () => null };
  const every = [...graph.lengths.keys()];
  const under = (pixel, view = solid) => edgesUnder(view, sight, pixel, graph.ends, every);
  const [middle, right] = [4, 5].map((v) => sight.pixel(points, v));
  assert.deepEqual(under(middle), [], 'four edges meet here');
  const { edgeBetween } = await load('surface/surface-graph');
  const between = { x: (middle.x + right.x) / 2, y: middle.y + 5 };
  assert.deepEqual(under(between), [edgeBetween(graph, 4, 5)]);
  assert.deepEqual(under({ ...between, y: middle.y + 20 }), []);
  assert.deepEqual(under(between, { points, firstHit: () => ({ distance: 1 }) }), [], 'hidden');
  // From afar all edges are short, and the brush takes all that it covers.
  camera.position.set(1, 1, 200);
  camera.far = 1000;
  camera.updateProjectionMatrix();
  const far = new Sight(camera, 400, 400);
  const all = edgesUnder(solid, far, far.pixel(points, 4), graph.ends, every);
  assert.equal(all.length, every.length);
});
