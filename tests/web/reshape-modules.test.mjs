// Charts that get another shape in their place, and the mirror images of edges.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { loadModule as load } from './modules.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** A sheet of quads, bent around the y axis; its layout is a part of a ring. */
function bentStrip(columns, rows) {
  const [positions, uv, indices, faces] = [[], [], [], []];
  for (let j = 0; j <= rows; ++j)
    for (let i = 0; i <= columns; ++i) {
      const angle = (i / columns) * 2;
      positions.push(Math.sin(angle), j / rows, Math.cos(angle));
      const radius = 0.6 - 0.3 * (j / rows);
      uv.push(0.5 - radius * Math.cos(angle), 0.1 + radius * Math.sin(angle));
    }
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      const a = j * (columns + 1) + i;
      const d = a + columns + 1;
      indices.push(a, d, d + 1, a, d + 1, a + 1);
      faces.push(faces.length / 2, faces.length / 2);
    }
  return {
    positions: Float64Array.from(positions),
    texcoords: Float64Array.from(uv),
    indices: Uint32Array.from(indices),
    vertices: Uint32Array.from({ length: uv.length / 2 }, (_, v) => v),
    corners: Uint32Array.from(indices, (_, c) => c),
    faces: Uint32Array.from(faces),
  };
}

/** An atlas of that chart alone, and how it is reshaped. */
async function reshaped(strip, how, { faces = strip.faces, pins = [] } = {}) {
  const { reshapeCharts } = await load('tools/reshaping');
  const { texcoords: uv, indices, positions } = strip;
  const result = {
    uv,
    unpacked: uv,
    indices,
    chartOfTriangle: new Uint32Array(indices.length / 3),
  };
  const outcome = { result, mesh: { positions, indices, faces } };
  return reshapeCharts(outcome, [0], how, Uint32Array.from(pins), {
    charts: async () => [strip],
    aside: (work) => work(abflat),
  });
}

const boxOf = (uv) =>
  [0, 1].map((d) => {
    const along = [...uv].filter((_, i) => i % 2 === d);
    return [Math.min(...along), Math.max(...along)];
  });

const areaOf = (uv, indices) => {
  let sum = 0;
  for (let c = 0; c < indices.length; c += 3) {
    const [i, j, k] = indices.subarray(c, c + 3);
    const [x1, y1] = [uv[2 * j] - uv[2 * i], uv[2 * j + 1] - uv[2 * i + 1]];
    const [x2, y2] = [uv[2 * k] - uv[2 * i], uv[2 * k + 1] - uv[2 * i + 1]];
    assert.ok(x1 * y2 > x2 * y1, 'no triangle is flipped');
    sum += (x1 * y2 - x2 * y1) / 2;
  }
  return sum;
};

/** It fills its box, which has these sides, in the place of the strip. */
function assertRectangle(uv, strip, ratio) {
  const [[left, right], [bottom, top]] = boxOf(uv);
  const [width, height] = [right - left, top - bottom];
  const area = areaOf(uv, strip.indices);
  assert.ok(Math.abs(area / (width * height) - 1) < 1e-4, 'it fills its box');
  assert.ok(Math.abs(Math.max(width / height, height / width) / ratio - 1) < 0.02);
  assert.ok(
    Math.abs(area / areaOf(strip.texcoords, strip.indices) - 1) < 1e-4,
    'as large as before',
  );
  const before = boxOf(strip.texcoords);
  [left + right, bottom + top].forEach((sum, d) => {
    assert.ok(Math.abs(sum - before[d][0] - before[d][1]) < 1e-6, 'in its place');
  });
}

test('a grid of quads becomes a rectangle as on the surface, however bent it was', async () => {
  const strip = bentStrip(8, 3);
  const { coordinates, done, failed } = await reshaped(strip, 'rectified');
  assert.deepEqual([done, failed], [[0], []]);
  assertRectangle(coordinates.uv, strip, 8 * 2 * Math.sin(1 / 8));
  // Each row is level, or upright.
  const { uv } = coordinates;
  const row = Array.from({ length: 9 }, (_, i) => [uv[2 * i], uv[2 * i + 1]]);
  const isStraight = [0, 1].some((d) => row.every((p) => Math.abs(p[d] - row[0][d]) < 1e-6));
  assert.ok(isStraight);
});

test('triangles with four corners become a rectangle, too', async () => {
  const strip = bentStrip(8, 3);
  const faces = Uint32Array.from({ length: strip.indices.length / 3 }, (_, f) => f);
  const { coordinates, failed } = await reshaped(strip, 'rectified', { faces });
  assert.deepEqual(failed, []);
  assertRectangle(coordinates.uv, strip, 8 * 2 * Math.sin(1 / 8));
});

test('a wall with windows becomes a rectangle, and its windows stay open', async () => {
  const strip = bentStrip(7, 5);
  strip.indices = strip.indices.filter((_, c) => ![15, 16, 18].includes(Math.floor(c / 6)));
  strip.corners = Uint32Array.from(strip.indices, (_, c) => c);
  const faces = Uint32Array.from({ length: strip.indices.length / 3 }, (_, f) => f);
  for (const how of ['rectified', 'relaxed']) {
    const { coordinates, failed } = await reshaped(strip, how, { faces });
    assert.deepEqual(failed, []);
    const [[left, right], [bottom, top]] = boxOf(coordinates.uv);
    const share = areaOf(coordinates.uv, strip.indices) / ((right - left) * (top - bottom));
    if (how === 'rectified') assert.ok(Math.abs(share - 32 / 35) < 0.03, String(share));
  }
});

test('what is no rectangle, or touches itself, stays as it is, and why is said', async () => {
  // A round outline.
  const count = 24;
  const around = Array.from({ length: count }, (_, i) => (i * 2 * Math.PI) / count);
  const texcoords = Float64Array.from([
    0.5,
    0.5,
    ...around.flatMap((a) => [0.5 + 0.4 * Math.cos(a), 0.5 + 0.4 * Math.sin(a)]),
  ]);
  const indices = Uint32Array.from(around.flatMap((_, i) => [0, 1 + i, 1 + ((i + 1) % count)]));
  const disc = {
    positions: Float64Array.from({ length: 3 * (count + 1) }, (_, i) =>
      i % 3 < 2 ? texcoords[2 * Math.floor(i / 3) + (i % 3)] : 0,
    ),
    ...{ texcoords, indices, faces: undefined },
    vertices: Uint32Array.from({ length: count + 1 }, (_, v) => v),
    corners: Uint32Array.from(indices, (_, c) => c),
  };
  const { coordinates, done, failed } = await reshaped(disc, 'rectified');
  assert.deepEqual(done, []);
  assert.match(failed[0][1], /not nearly a rectangle/);
  assert.deepEqual(coordinates.uv, texcoords);
  // Two triangles that share a point only.
  const bow = {
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0),
    texcoords: Float64Array.of(0, 0, 1, 0, 0, 1, -1, 0, 0, -1),
    indices: Uint32Array.of(0, 1, 2, 0, 3, 4),
    vertices: Uint32Array.of(0, 1, 2, 3, 4),
    corners: Uint32Array.of(0, 1, 2, 3, 4, 5),
  };
  const { failed: why } = await reshaped(bow, 'relaxed');
  assert.match(why[0][1], /touches itself/);
});

test('relaxing keeps lengths better, in the same place, and pins where they are', async () => {
  const { distortionsOf } = await load('mesh/distortion');
  const strip = bentStrip(10, 4);
  const stretch = (uv) => {
    const found = distortionsOf({ ...strip, uv }).stretch;
    return found.reduce((sum, each) => sum + each, 0) / found.length;
  };
  const { coordinates } = await reshaped(strip, 'relaxed');
  assert.ok(stretch(coordinates.uv) < 1.001 && stretch(strip.texcoords) > 1.05);
  assert.ok(
    Math.abs(areaOf(coordinates.uv, strip.indices) / areaOf(strip.texcoords, strip.indices) - 1) <
      1e-4,
  );
  // Corners of triangles; the vertices are those of two corners of the strip.
  const pins = [0, strip.indices.indexOf(10)];
  const pinned = await reshaped(strip, 'relaxed', { pins });
  assert.deepEqual(pinned.failed, []);
  for (const corner of pins)
    for (const d of [0, 1]) {
      const i = 2 * strip.indices[corner] + d;
      assert.ok(Math.abs(pinned.coordinates.uv[i] - strip.texcoords[i]) < 1e-6);
    }
});

test('edges have their mirror images, across the middle or the origin; those without stay alone', async () => {
  const { mirrorOf, withImages } = await load('surface/mirror');
  const { edgeBetween, surfaceGraph } = await load('surface/surface-graph');
  /** 5 x 3 squares from x = -2.5, with a tail on the right. */
  const positions = [];
  for (let y = 0; y <= 3; ++y) for (let x = 0; x <= 5; ++x) positions.push(x - 2.5, y, 0);
  positions.push(9, 0, 0.5);
  const indices = [];
  for (let y = 0; y < 3; ++y)
    for (let x = 0; x < 5; ++x) {
      const a = 6 * y + x;
      indices.push(a, a + 1, a + 7, a, a + 7, a + 6);
    }
  indices.push(5, 24, 11);
  const faces = Uint32Array.from({ length: indices.length / 3 }, (_, f) => f >> 1);
  const mesh = { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
  const places = Uint32Array.from({ length: 25 }, (_, v) => v);
  const graph = surfaceGraph(mesh, places, faces);
  const mirror = mirrorOf(graph, mesh.positions);
  assert.equal(mirror(6), 11);
  assert.equal(mirror(24), -1);
  const edge = (a, b) => edgeBetween(graph, a, b);
  assert.deepEqual(withImages(graph, mirror, [edge(6, 7)]), [edge(6, 7), edge(10, 11)]);
  assert.deepEqual(withImages(graph, mirror, [edge(8, 9)]), [edge(8, 9)], 'its own image');
  assert.deepEqual(withImages(graph, mirror, [edge(5, 24)]), [edge(5, 24)], 'no image');
  const scattered = mesh.positions.map((_, i) => Math.sin(i * i));
  assert.equal(mirrorOf(graph, scattered), null);
});
