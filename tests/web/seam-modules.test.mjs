// Seams on a surface, without a page: its edges, shortest paths, runs, what is under the pointer.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PerspectiveCamera, Ray, Vector3 } from 'three';
import { randomNumbers } from '../support/disks.mjs';
import { graphOf, plane } from './graphs.mjs';
import { loadModule as load } from './modules.mjs';

test('the edges are those of faces: no diagonals, each once, inner ones told apart', async () => {
  const n = 4;
  const mesh = plane(n);
  const quads = await graphOf(mesh);
  assert.equal(quads.lengths.length, 2 * n * (n + 1));
  assert.equal(
    quads.isInner.reduce((sum, x) => sum + x, 0),
    2 * n * (n - 1),
  );
  assert.ok(quads.lengths.every((length) => length === 1));
  const triangles = await graphOf(mesh, null);
  assert.equal(triangles.lengths.length, 2 * n * (n + 1) + n * n);
  const keys = new Set();
  for (let e = 0; e < triangles.lengths.length; ++e)
    keys.add(`${triangles.ends[2 * e]} ${triangles.ends[2 * e + 1]}`);
  assert.equal(keys.size, triangles.lengths.length);
});

test('vertices at one place are one, in triangles without area as well', async () => {
  const { weld } = await load('mesh/weld');
  const { edgeBetween } = await load('surface/surface-graph');
  // Two triangles that share no vertices, and a collapsed one.
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
  const indices = Uint32Array.of(0, 1, 2, 4, 3, 5, 1, 3, 2);
  const graph = await graphOf({ positions, indices }, null, weld(positions, 3));
  assert.equal(graph.lengths.length, 5);
  assert.equal(edgeBetween(graph, 3, 4), edgeBetween(graph, 2, 1));
  assert.equal(graph.isInner[edgeBetween(graph, 1, 2)], 1);
  assert.equal(edgeBetween(graph, 0, 5), -1);
});

test('shortest paths are as short as Bellman and Ford find, and lead where they should', async () => {
  const { ShortestPaths } = await load('surface/shortest-paths');
  const { otherEnd } = await load('surface/surface-graph');
  const next = randomNumbers(7);
  const mesh = plane(7);
  for (let i = 0; i < mesh.positions.length; ++i) mesh.positions[i] += 0.6 * next();
  const graph = await graphOf(mesh, null);
  const start = 11;
  const paths = new ShortestPaths(graph, start);
  const expected = new Float64Array(graph.places.length).fill(Infinity);
  expected[start] = 0;
  for (let round = 0; round < expected.length; ++round)
    graph.lengths.forEach((length, e) => {
      const [a, b] = [graph.ends[2 * e], graph.ends[2 * e + 1]];
      expected[a] = Math.min(expected[a], expected[b] + length);
      expected[b] = Math.min(expected[b], expected[a] + length);
    });
  for (let place = 0; place < expected.length; ++place) {
    assert.ok(Math.abs(paths.distanceTo(place) - expected[place]) < 1e-12);
    const path = paths.to(place);
    let at = start;
    let length = 0;
    for (const edge of path) {
      assert.ok([graph.ends[2 * edge], graph.ends[2 * edge + 1]].includes(at), 'connected');
      at = otherEnd(graph, edge, at);
      length += graph.lengths[edge];
    }
    assert.equal(at, place);
    assert.ok(Math.abs(length - expected[place]) < 1e-12);
  }
});

test('paths that are found part by part are those that are found at once', async () => {
  const { ShortestPaths } = await load('surface/shortest-paths');
  const next = randomNumbers(3);
  const mesh = plane(9);
  for (let i = 0; i < mesh.positions.length; ++i) mesh.positions[i] += 0.6 * next();
  const graph = await graphOf(mesh, null);
  const [parts, whole] = [new ShortestPaths(graph, 5), new ShortestPaths(graph, 5)];
  assert.ok(whole.grow(Infinity));
  let rounds = 0;
  while (!parts.grow(7)) {
    ++rounds;
    const reached = graph.places.filter((place) => parts.hasReached(place));
    assert.equal(reached.length, 7 * rounds);
    for (const place of reached) assert.equal(parts.distanceTo(place), whole.distanceTo(place));
    assert.equal(
      graph.places.filter((place) => parts.hasReached(place)).length,
      7 * rounds,
      'none is sought that is there',
    );
  }
  for (const place of graph.places) assert.deepEqual(parts.to(place), whole.to(place));
});

test('a ray meets the triangle that is first of all, from either side', async () => {
  const { Solid, withTree } = await load('surface/solid');
  const next = randomNumbers(11);
  const vector = () => new Vector3(next() - 0.5, next() - 0.5, next() - 0.5);
  const count = 300;
  const points = Float32Array.from({ length: 9 * count }, () => 2 * next() - 1);
  const indices = Uint32Array.from({ length: 3 * count }, (_, i) => i);
  const solid = new Solid(withTree(points, indices));
  const corner = (v) => new Vector3().fromArray(points, 3 * v);
  let hits = 0;
  for (let i = 0; i < 200; ++i) {
    const ray = new Ray(vector().multiplyScalar(6), vector().normalize());
    if (i % 2) ray.lookAt(vector());
    let [triangle, nearest] = [-1, Infinity];
    for (let f = 0; f < count; ++f) {
      const point = ray.intersectTriangle(
        ...[0, 1, 2].map((c) => corner(3 * f + c)),
        false,
        new Vector3(),
      );
      const distance = point?.distanceTo(ray.origin) ?? Infinity;
      if (distance < nearest) [triangle, nearest] = [f, distance];
    }
    const hit = solid.firstHit(ray);
    assert.equal(hit?.triangle ?? -1, triangle);
    if (hit) assert.ok(Math.abs(hit.distance - nearest) < 1e-9);
    hits += Number(hit !== null);
  }
  assert.ok(hits > 100 && hits < 200, `${hits} of 200 rays meet something`);
});

test('there is no path to another component', async () => {
  const { ShortestPaths } = await load('surface/shortest-paths');
  const positions = Float64Array.from({ length: 18 }, (_, i) => (i * i) % 7);
  const graph = await graphOf({ positions, indices: Uint32Array.of(0, 1, 2, 3, 4, 5) }, null);
  assert.deepEqual(new ShortestPaths(graph, 0).to(4), []);
  assert.equal(new ShortestPaths(graph, 0).distanceTo(4), Infinity);
});

test('a run of a seam ends at junctions and at the boundary; a loop is one run', async () => {
  const { flagsOf, pairsOf, seamRun } = await load('seams/seam-edges');
  const graph = await graphOf(plane(6));
  const at = (x, y) => 7 * y + x;
  const line = (from, to) => {
    const pairs = [];
    for (let [x, y] = from; x !== to[0] || y !== to[1]; ) {
      const before = at(x, y);
      x += Math.sign(to[0] - x);
      y += Math.sign(to[1] - y);
      pairs.push(before, at(x, y));
    }
    return pairs;
  };
  const edge = (flags, a, b) => {
    const pairs = pairsOf(graph, flags);
    const only = flagsOf(graph, Uint32Array.of(a, b));
    assert.ok(pairs.length > 0);
    return only.indexOf(1);
  };
  // A T: across from boundary to boundary, and upwards from the middle.
  const tee = flagsOf(graph, Uint32Array.from([...line([0, 3], [6, 3]), ...line([3, 3], [3, 5])]));
  assert.equal(seamRun(graph, tee, edge(tee, at(1, 3), at(2, 3))).length, 3);
  assert.equal(seamRun(graph, tee, edge(tee, at(4, 3), at(5, 3))).length, 3);
  assert.equal(seamRun(graph, tee, edge(tee, at(3, 4), at(3, 5))).length, 2);
  const square = [
    [1, 1],
    [4, 1],
    [4, 4],
    [1, 4],
    [1, 1],
  ];
  const loop = flagsOf(
    graph,
    Uint32Array.from(square.slice(1).flatMap((corner, i) => line(square[i], corner))),
  );
  const run = seamRun(graph, loop, edge(loop, at(2, 1), at(3, 1)));
  assert.equal(run.length, 12);
  assert.equal(new Set(run).size, 12);
});

test('seams are cut and joined from those on screen, and every choice can be taken again', async () => {
  const { SeamModel } = await load('seams/seam-model');
  const { ShortestPaths } = await load('surface/shortest-paths');
  const graph = await graphOf(plane(6));
  const model = new SeamModel(() => ({ graph }));
  assert.equal(model.choice.edges, null);
  model.show(Uint32Array.of(8, 9, 9, 10));
  const first = model.choice;
  const path = new ShortestPaths(graph, 22).to(25);
  assert.equal(model.cut(path), 3);
  assert.equal(model.choice.edges.length, 2 * (2 + 3), 'those on screen stay');
  assert.equal(model.cut(path), 0, 'nothing is cut twice');
  const boundary = new ShortestPaths(graph, 0).to(3);
  assert.equal(model.cut(boundary), 0, 'the boundary is no seam');
  assert.equal(model.join(path.slice(0, 1)), 1);
  const joined = model.choice;
  assert.equal(joined.edges.length, 2 * 4);
  // Seams that the atlas has beyond those asked for are needed: they are shown, but cannot be
  // joined.
  model.show(Uint32Array.of(...joined.edges, 30, 31));
  assert.equal(
    model.all.reduce((sum, x) => sum + x, 0),
    5,
  );
  assert.equal(
    model.own.reduce((sum, x) => sum + x, 0),
    4,
  );
  model.restore(first);
  assert.equal(model.choice.edges, null);
  model.restore(joined);
  assert.equal(model.choice.edges.length, 2 * 4);
  model.setSources({ auto: false, uv: true, material: false, sharp: 30 });
  assert.equal(model.choice.edges, null);
});

test('when a choice is taken again, seams are edited from those that were found before, though others are on screen yet', async () => {
  const { SeamModel } = await load('seams/seam-model');
  const graph = await graphOf(plane(6));
  const { edgeBetween } = await load('surface/surface-graph');
  const edge = (from, to) => [edgeBetween(graph, from, to)];
  const model = new SeamModel(() => ({ graph }));
  const automatic = Uint32Array.of(8, 9, 9, 10);
  model.show(automatic);
  const first = model.choice;
  model.cut(edge(22, 23));
  const edited = model.choice.edges;
  model.show(edited);
  model.restore(first);
  model.cut(edge(30, 31));
  assert.deepEqual([...model.choice.edges].sort(), [...automatic, 30, 31].sort());
  // A late result of an earlier choice does not count as found for this one.
  model.restore(first);
  model.show(edited, false);
  model.join(edge(8, 9));
  assert.deepEqual([...model.choice.edges], [9, 10]);
  // Nothing is known yet about the new sources, so the seams on screen are edited.
  model.setSources({ auto: false, uv: true, material: false, sharp: null });
  model.cut(edge(30, 31));
  assert.equal(model.choice.edges.length, edited.length + 2);
});

test('sources are the words of the command line', async () => {
  const { AUTOMATIC, seamOptions, seamWords } = await load('seams/seam-choice');
  const none = { auto: false, hard: false, uv: false, material: false, sharp: null };
  assert.equal(seamWords(none), 'none');
  assert.equal(seamWords(AUTOMATIC.sources), 'auto');
  assert.equal(
    seamWords({ auto: true, hard: true, uv: true, material: true, sharp: 42.5 }),
    'auto,hard,uv,material,sharp=42.5',
  );
  const edges = Uint32Array.of(1, 2);
  assert.deepEqual(seamOptions({ sources: AUTOMATIC.sources, edges }), {
    seams: 'none',
    seamEdges: edges,
  });
});

test('a choice of seams is found from its options', async () => {
  const { AUTOMATIC, choiceOf, seamOptions } = await load('seams/seam-choice');
  const edges = Uint32Array.of(1, 2);
  const sources = { auto: false, hard: true, uv: true, material: false, sharp: 42.5 };
  const all = [
    AUTOMATIC,
    { sources, edges: null },
    { sources: { ...sources, sharp: null, uv: false }, edges: null },
    { sources: AUTOMATIC.sources, edges },
    { sources: AUTOMATIC.sources, edges, isCutFurther: true },
  ];
  for (const choice of all) {
    const { isCutFurther = false, ...found } = choiceOf(seamOptions(choice));
    assert.deepEqual({ isCutFurther, ...found }, { isCutFurther: false, ...choice });
  }
});

test('what is under a pixel: the vertex or seam in front, seams from further away', async () => {
  const { edgeAt, vertexAt } = await load('seams/pick');
  const { Sight } = await load('view/sight');
  const { positions, indices } = plane(4, (x) => x);
  // A second sheet behind the first.
  const points = Float32Array.from([
    ...positions,
    ...positions.map((x, i) => (i % 3 === 2 ? -1 : x)),
  ]);
  const { Solid, withTree } = await load('surface/solid');
  const both = Uint32Array.from([...indices, ...indices.map((v) => v + 25)]);
  const solid = new Solid(withTree(points, both));
  const camera = new PerspectiveCamera(40, 1.5, 0.1, 100);
  camera.position.set(2, 2, 9);
  camera.lookAt(2, 2, 0);
  camera.updateProjectionMatrix();
  const sight = new Sight(camera, 600, 400);
  for (const v of [0, 7, 12, 24]) {
    const { x, y } = sight.pixel(points, v);
    const inside = { x: x + Math.sign(300.5 - x), y: y + Math.sign(200.5 - y) };
    assert.equal(vertexAt(solid, sight, inside, []), v);
    // A vertex behind is hidden if there is something in front.
    if (v === 12) assert.equal(vertexAt(solid, sight, { x, y }, [v + 25]), v);
  }
  const middle = sight.pixel(points, 12);
  const beside = { x: middle.x + 30, y: middle.y };
  assert.equal(vertexAt(solid, sight, { x: beside.x - 19, y: beside.y }, [13]), 12);
  assert.equal(vertexAt(solid, sight, { x: 2, y: 2 }, []), -1);
  const ends = Uint32Array.of(12, 13, 12 + 25, 13 + 25, 6, 7);
  const half = { x: (middle.x + sight.pixel(points, 13).x) / 2, y: middle.y + 4 };
  assert.equal(edgeAt(solid, sight, half, ends, [0, 1, 2]), 0);
  assert.equal(edgeAt(solid, sight, half, ends, [1, 2]), -1, 'hidden');
});

test('seam files are those of the command line, and are checked', async () => {
  const { readSeams, seamText } = await load('seams/seam-file');
  const graph = await graphOf(plane(3));
  const pairs = Uint32Array.of(5, 6, 6, 10);
  assert.equal(seamText(pairs), '5 6\n6 10\n');
  assert.deepEqual(readSeams(graph, seamText(pairs), 'a.txt'), pairs);
  assert.deepEqual(readSeams(graph, '# seams\r\n\r\n 5\t6 # one\r\n6 10', 'a.txt'), pairs);
  for (const [text, message] of [
    ['5 6\n5', "a.txt:2: expected two vertex numbers, such as '17 42'."],
    ['5 -6', "a.txt:1: expected two vertex numbers, such as '17 42'."],
    ['5 16', 'a.txt:1: there is no vertex 16; the last one is 15.'],
    ['\n0 5', 'a.txt:2: 0-5 is not an edge of any face.'],
  ])
    assert.throws(() => readSeams(graph, text, 'a.txt'), { message });
});

test('islands are sorted by any measure, equal ones by number, what is no number last', async () => {
  const { chartRows, COLUMNS, sortedRows } = await load('details/chart-rows');
  const chart = (faces, area, symmetricDirichlet) => ({
    faces,
    area,
    symmetricDirichlet,
    angularDistortion: 0,
    valid: true,
  });
  const rows = chartRows({ charts: [chart(5, 1, 1.2), chart(9, 2, null), chart(5, 1, 1.1)] });
  assert.deepEqual(
    rows.map(({ share }) => share),
    [0.25, 0.5, 0.25],
  );
  const order = (name, descending) =>
    sortedRows(rows, {
      column: COLUMNS.findIndex((column) => column.name === name),
      descending,
    }).map(({ index }) => index);
  assert.deepEqual(order('Faces', true), [1, 0, 2]);
  assert.deepEqual(order('Faces', false), [0, 2, 1]);
  assert.deepEqual(order('Stretch', true), [0, 2, 1]);
  assert.deepEqual(order('Stretch', false), [2, 0, 1]);
  assert.deepEqual(order('Island', false), [0, 1, 2]);
});
