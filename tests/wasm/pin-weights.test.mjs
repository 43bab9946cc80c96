// Pins that are dragged: one call for all frames, and unwrap to check where they end up.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { torus } from '../support/surfaces.mjs';
import { grid } from './support/meshes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const fan = ([a, ...rest]) => rest.slice(1).flatMap((v, i) => [a, rest[i], v]);

/** The coordinates once the pin has moved by (du, dv). */
const moved = (uv, weights, [du, dv]) =>
  uv.map((x, i) => {
    const [a, b] = [weights[i & ~1], weights[i | 1]];
    return x + (i % 2 === 0 ? a * du - b * dv : b * du + a * dv);
  });

/** One chart of an atlas, with vertices of its own. */
function chartOf({ uv, indices, vertexMap, chartOfTriangle }, positions, chart) {
  const vertices = [];
  const number = new Map();
  const own = [];
  indices.forEach((v, corner) => {
    if (chartOfTriangle[Math.floor(corner / 3)] !== chart) return;
    if (!number.has(v)) number.set(v, vertices.push(v) - 1);
    own.push(number.get(v));
  });
  return {
    vertices,
    layout: {
      positions: vertices.flatMap((v) => [0, 1, 2].map((d) => positions[3 * vertexMap[v] + d])),
      indices: own,
      texcoords: vertices.flatMap((v) => [uv[2 * v], uv[2 * v + 1]]),
    },
  };
}

test('pins of a flat surface give the layout that flatten gives', async () => {
  const mesh = grid(8);
  const flat = { ...mesh, positions: mesh.positions.map((x, i) => (i % 3 === 2 ? 0 : x)) };
  const { uv } = await abflat.flatten(flat);
  const pins = [40, 0, 8, 72, 80];
  const layout = { ...flat, texcoords: uv };
  const { weights } = await abflat.pinWeights(layout, pins);
  const by = [0.3, -0.2];
  const asked = pins.map((vertex, i) => ({
    vertex,
    uv: [0, 1].map((d) => uv[2 * vertex + d] + (i === 0 ? by[d] : 0)),
  }));
  const pinned = await abflat.flatten(flat, { pins: asked });
  moved(uv, weights, by).forEach((x, i) => {
    assert.ok(Math.abs(x - pinned.uv[i]) < 1e-9, `${x} ${pinned.uv[i]}`);
  });
});

test('a chart that is dragged stays where it is put, and is checked there', async () => {
  const surface = torus(16, 12);
  const mesh = {
    positions: surface.positions.flat(),
    indices: surface.faces.flatMap((face) => fan(face)),
  };
  const first = await abflat.unwrap(mesh);
  const { vertices, layout } = chartOf(first, mesh.positions, 0);
  const last = vertices.length - 1;
  const { weights } = await abflat.pinWeights(layout, [0, last, last >> 1, last >> 2]);
  const uv = first.uv.slice();
  const unpacked = first.unpacked.slice();
  moved(layout.texcoords, weights, [0.01, 0.02]).forEach((x, i) => {
    const place = 2 * vertices[i >> 1] + (i % 2);
    uv[place] = unpacked[place] = Math.fround(x);
  });
  const known = { ...first, uv, unpacked };
  const options = { known, keepsPlaces: true, seams: 'none', seamEdges: first.seams };
  const second = await abflat.unwrap(mesh, options);
  assert.deepEqual(second.uv, uv);
  const stretch = ({ report }) => report.charts[0].symmetricDirichlet;
  assert.ok(stretch(second) > stretch(first));
});

test('what cannot be dragged is refused', async () => {
  const mesh = grid(4);
  const layout = { ...mesh, texcoords: new Float64Array(2 * 25).map((_, i) => i) };
  const fails = (call, code, message) =>
    assert.rejects(call, (error) => error.code === code && message.test(error.message));
  await fails(abflat.pinWeights(layout, 7), 'InvalidOption', /pins must be an array of vertex num/);
  await fails(
    abflat.pinWeights(layout, [-1]),
    'InvalidOption',
    /pins\[0\] must be a vertex number/,
  );
  await fails(abflat.pinWeights(layout, []), 'InvalidOption', /no vertex is pinned/);
  await fails(abflat.pinWeights(layout, [25]), 'InvalidOption', /vertex 25 .* 25 vertices/);
  await fails(abflat.pinWeights(mesh, [3]), 'InvalidOption', /uv has 0 numbers/);
  const file = { bytes: new Uint8Array(3), name: 'a.obj' };
  await fails(abflat.pinWeights(file, [3]), 'InvalidMesh', /The layout must be \{ positions/);
  assert.equal((await abflat.pinWeights(layout, [3, 5])).weights.length, 50);
});

test('dragging can be cancelled', async () => {
  const { positions, indices } = grid(60);
  const texcoords = positions.filter((_, i) => i % 3 !== 2);
  const stopped = AbortSignal.abort(new Error('enough'));
  const call = abflat.pinWeights({ positions, indices, texcoords }, [0, 5, 9], { signal: stopped });
  await assert.rejects(call, /enough/);
});
