// Loops of edges, edges that bend, and the edge under a pixel, without a page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PerspectiveCamera } from 'three';
import { graphOf, plane } from './graphs.mjs';
import { loadModule as load } from './modules.mjs';

/** The edges of a loop as sets of two vertices. */
async function loopBetween(graph, a, b) {
  const { edgeLoop } = await load('surface/edge-loop');
  const { edgeBetween } = await load('surface/surface-graph');
  return edgeLoop(graph, edgeBetween(graph, a, b));
}

/** The vertices that edges meet, each once. */
const metBy = ({ ends }, edges) => [
  ...new Set(edges.flatMap((e) => [ends[2 * e], ends[2 * e + 1]])),
];

test('a loop of edges goes straight through quads, from boundary to boundary', async () => {
  const n = 5;
  const graph = await graphOf(plane(n));
  const at = (x, y) => (n + 1) * y + x;
  for (let y = 1; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      const loop = await loopBetween(graph, at(x, y), at(x + 1, y));
      assert.equal(loop.length, n);
      const row = Array.from({ length: n + 1 }, (_, i) => at(i, y));
      assert.deepEqual(
        metBy(graph, loop).sort((a, b) => a - b),
        row,
      );
    }
  assert.deepEqual(await loopBetween(graph, at(0, 0), at(1, 0)), [], 'the boundary is not cut');
});

test('in triangles a loop takes the opposite one of six edges', async () => {
  const n = 5;
  const graph = await graphOf(plane(n), null);
  const at = (x, y) => (n + 1) * y + x;
  assert.equal((await loopBetween(graph, at(1, 2), at(2, 2))).length, n);
  assert.equal((await loopBetween(graph, at(2, 1), at(2, 2))).length, n);
  const diagonal = await loopBetween(graph, at(2, 1), at(3, 2));
  assert.deepEqual(
    metBy(graph, diagonal).sort((a, b) => a - b),
    Array.from({ length: n }, (_, i) => at(i + 1, i)),
  );
});

test('a loop of edges closes around a tube, whichever edge it is taken from', async () => {
  const [around, rows] = [8, 3];
  const mesh = tube(around, rows);
  const graph = await graphOf(mesh);
  const ring = Array.from({ length: around }, (_, i) => around + i);
  const loops = [];
  for (let i = 0; i < around; ++i)
    loops.push(await loopBetween(graph, ring[i], ring[(i + 1) % around]));
  for (const loop of loops) {
    assert.deepEqual(
      metBy(graph, loop).sort((a, b) => a - b),
      ring,
    );
    assert.deepEqual([...loop].sort(), [...loops[0]].sort());
  }
  assert.equal((await loopBetween(graph, 0, around)).length, rows);
});

/** A tube of quads, open at both ends. */
function tube(around, rows) {
  const positions = [];
  for (let j = 0; j <= rows; ++j)
    for (let i = 0; i < around; ++i) {
      const angle = (2 * Math.PI * i) / around;
      positions.push(Math.cos(angle), Math.sin(angle), j);
    }
  const indices = [];
  const faces = [];
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < around; ++i) {
      const [a, b] = [around * j + i, around * j + ((i + 1) % around)];
      indices.push(a, b, b + around, a, b + around, a + around);
      faces.push(around * j + i, around * j + i);
    }
  return {
    positions: Float64Array.from(positions),
    indices: Uint32Array.from(indices),
    faces: Uint32Array.from(faces),
  };
}

test('a loop of edges ends where a vertex is not regular', async () => {
  // Three quads around vertex 0: each of its edges ends there.
  const corner = {
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 1),
    indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1),
    faces: Uint32Array.of(0, 0, 1, 1, 2, 2),
  };
  const graph = await graphOf(corner);
  for (const end of [1, 3, 5]) assert.equal((await loopBetween(graph, 0, end)).length, 1);
  // Four triangles meet at 0, which is no plane grid either.
  const pyramid = {
    positions: Float64Array.of(0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0),
    indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1),
  };
  assert.equal((await loopBetween(await graphOf(pyramid), 0, 1)).length, 1);
});

test('edges bend by the angle between their faces, and not at all inside of them', async () => {
  const { edgeBetween } = await load('surface/surface-graph');
  const n = 4;
  const folded = plane(n);
  const angle = 70;
  // Folded along the column x = 2.
  for (let v = 0; v < folded.positions.length; v += 3) {
    const over = Math.max(0, folded.positions[v] - 2);
    folded.positions[v] -= over * (1 - Math.cos((angle * Math.PI) / 180));
    folded.positions[v + 2] = over * Math.sin((angle * Math.PI) / 180);
  }
  const bent = async (mesh) => {
    const graph = await graphOf(mesh);
    assert.ok(graph.bends.every((bend) => bend < 1e-3 || Math.abs(bend - angle) < 1e-3));
    return [...graph.bends.keys()].filter((e) => graph.bends[e] > 1);
  };
  const graph = await graphOf(folded);
  const fold = Array.from({ length: n }, (_, y) =>
    edgeBetween(graph, (n + 1) * y + 2, (n + 1) * (y + 1) + 2),
  );
  assert.deepEqual((await bent(folded)).sort(), fold.sort());
  // A face that looks the other way bends no edge.
  const { indices } = folded;
  [indices[0], indices[1]] = [indices[1], indices[0]];
  [indices[3], indices[4]] = [indices[4], indices[3]];
  assert.deepEqual((await bent(folded)).sort(), fold.sort());
});

test('a loop and sharp edges leave out what is cut already', async () => {
  const { SeamModel } = await load('seams/seam-model');
  const { edgeBetween } = await load('surface/surface-graph');
  const graph = await graphOf(tube(8, 3));
  const model = new SeamModel(() => ({ graph }));
  assert.equal(model.sharpEdges(44).length, 8 * 3, 'all edges along the tube');
  assert.equal(model.sharpEdges(46).length, 0);
  const along = edgeBetween(graph, 8, 16);
  assert.equal(model.cut([along]), 1);
  assert.equal(model.sharpEdges(44).length, 8 * 3 - 1);
  assert.equal(model.loop(along).length, 2);
  assert.equal(model.cut(model.loop(along)), 2);
  assert.deepEqual(model.loop(along), []);
});

test('the edge under a pixel, but not near its ends', async () => {
  const { edgeAwayFromEnds } = await load('seams/pick');
  const { Sight } = await load('view/sight');
  const { Solid, withTree } = await load('surface/solid');
  const { edgeBetween } = await load('surface/surface-graph');
  const mesh = plane(4);
  const graph = await graphOf(mesh);
  const solid = new Solid(withTree(Float32Array.from(mesh.positions), mesh.indices));
  for (const distance of [9, 60]) {
    const camera = new PerspectiveCamera(40, 1.5, 0.1, 100);
    camera.position.set(2, 2, distance);
    camera.lookAt(2, 2, 0);
    camera.updateProjectionMatrix();
    const sight = new Sight(camera, 600, 400);
    const at = (x, y) => edgeAwayFromEnds(solid, graph, sight, sight.pixel([x, y, 0], 0));
    assert.equal(at(1.5, 2.02), edgeBetween(graph, 11, 12), 'in the middle');
    assert.equal(at(2.02, 2.98), -1, 'at a vertex');
    assert.equal(at(9, 9), -1, 'beside the mesh');
    if (distance < 10)
      assert.equal(at(1.5, 1.5), -1, 'on the diagonal of a face, which is no edge');
  }
});
