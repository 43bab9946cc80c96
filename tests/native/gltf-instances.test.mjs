// A mesh that several nodes use has one layout, sized for the node that makes it largest.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { elementsOf, GlbMaker, parseGltf, trianglesOf } from '../support/glb.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { sphere } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** Balls, each a mesh of its own; `nodes` say which mesh they use. */
function balls(count, nodes) {
  const maker = new GlbMaker();
  const { positions, faces } = sphere(4);
  const primitive = () => ({
    attributes: {
      POSITION: maker.accessor(Float32Array.from(positions.flat()), 'VEC3', {
        box: true,
        target: 34962,
      }),
    },
    indices: maker.accessor(Uint16Array.from(faces.flat()), 'SCALAR', { target: 34963 }),
  });
  Object.assign(maker.json, {
    meshes: Array.from({ length: count }, () => ({ primitives: [primitive()] })),
    nodes: nodes.map((node, i) => ({ translation: [10 * i, 0, 0], ...node })),
    scenes: [{ nodes: nodes.map((_, i) => i) }],
    scene: 0,
  });
  return maker.glb();
}

async function unwrapped(t, bytes) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), bytes);
  const args = ['unwrap', 'in.glb', '-o', 'out.glb', '--report', 'r.json'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  const model = parseGltf(readFileSync(at('out.glb')));
  const areas = model.json.meshes.map(({ primitives: [primitive] }) => {
    const uv = elementsOf(model, primitive.attributes.TEXCOORD_0);
    return trianglesOf(model, primitive)
      .map((triangle) => triangle.map((v) => uv[v]))
      .map(([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
      .reduce((sum, area) => sum + Math.abs(area) / 2, 0);
  });
  return { areas, notes: JSON.parse(readFileSync(at('r.json'))).notes };
}

const scaled = (x) => [x, x, x];

test('the largest node counts, whatever the order', async (t) => {
  const sizes = [1, 3, 2];
  for (const order of [
    [0, 1, 2],
    [1, 2, 0],
    [2, 0, 1],
  ]) {
    const nodes = order.map((i) => ({ mesh: 0, scale: scaled(sizes[i]) }));
    const { areas, notes } = await unwrapped(t, balls(2, [...nodes, { mesh: 1 }]));
    assert.ok(Math.abs(areas[0] / areas[1] - 9) < 0.1, `${areas}`);
    assert.deepEqual(notes, [
      '3 nodes share 1 mesh and its texels. Their scales differ, so each layout is sized for the largest node. Give a node a mesh of its own for texels of its own',
    ]);
  }
});

test('large is what has most surface: a sheet counts more than a cube of the same volume', async (t) => {
  const nodes = [
    { mesh: 0, scale: scaled(1) },
    { mesh: 0, scale: [10, 0.01, 10] },
  ];
  const { areas } = await unwrapped(t, balls(2, [...nodes, { mesh: 1 }]));
  assert.ok(areas[0] > 10 * areas[1], `${areas}`);
});

test('equally large nodes share, and the first of them counts', async (t) => {
  const turn = [0, Math.sin(0.3), 0, Math.cos(0.3)];
  const { notes } = await unwrapped(
    t,
    balls(2, [{ mesh: 0 }, { mesh: 0, rotation: turn }, { mesh: 1 }, { mesh: 1 }, { mesh: 1 }]),
  );
  assert.deepEqual(notes, [
    '5 nodes share 2 meshes and their texels. Give a node a mesh of its own for texels of its own',
  ]);
  const alone = await unwrapped(t, balls(1, [{ mesh: 0 }]));
  assert.deepEqual(alone.notes, []);
});

test('a node that squeezes a mesh flat does not count while another does', async (t) => {
  const nodes = [
    { mesh: 0, scale: [50, 0, 50] },
    { mesh: 0, scale: scaled(2) },
  ];
  const { areas } = await unwrapped(t, balls(2, [...nodes, { mesh: 1 }]));
  assert.ok(Math.abs(areas[0] / areas[1] - 4) < 0.1, `${areas}`);
});
