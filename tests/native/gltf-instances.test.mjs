// A mesh that several nodes use has one layout, sized for the node that makes it largest.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { elementsOf, GlbMaker, glbOf, parseGltf, trianglesOf } from '../support/glb.mjs';
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

async function unwrapped(t, bytes, ...more) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), bytes);
  const args = ['unwrap', 'in.glb', '-o', 'out.glb', '--report', 'r.json', ...more];
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
  return { model, areas, notes: JSON.parse(readFileSync(at('r.json'))).notes };
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
      '3 nodes share 1 mesh and its texels. Their scales differ, so each layout is sized for the largest node. With the option own-texels each node gets texels of its own',
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
    '5 nodes share 2 meshes and their texels. With the option own-texels each node gets texels of its own',
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

test('with texels of its own, each node has them at its size', async (t) => {
  const sizes = [1, 3, -2];
  const nodes = sizes.map((size) => ({ mesh: 0, scale: scaled(size) }));
  const bytes = balls(2, [...nodes, { mesh: 1 }]);
  const { model, areas, notes } = await unwrapped(t, bytes, '--own-texels');
  assert.deepEqual(notes, []);
  assert.deepEqual(
    model.json.nodes.map(({ mesh }) => mesh),
    [0, 2, 3, 1],
  );
  const [least, , larger, mirrored] = areas;
  assert.ok(Math.abs(larger / least - 9) < 0.1, `${areas}`);
  assert.ok(Math.abs(mirrored / least - 4) < 0.1, `${areas}`);
  const normals = model.json.meshes.map((mesh) => mesh.primitives[0].attributes.TEXCOORD_0);
  assert.equal(new Set(normals).size, 4, 'each mesh has texcoords of its own');
});

test('nodes outside the scene and below others, with texels of their own', async (t) => {
  const bytes = balls(1, [{ mesh: 0, children: [1] }, { mesh: 0 }, { mesh: 0 }]);
  const input = parseGltf(bytes);
  input.json.scenes = [{ nodes: [0] }];
  const { model } = await unwrapped(t, glbOf(input.json, input.buffer), '--own-texels');
  assert.deepEqual(
    model.json.nodes.map(({ mesh }) => mesh),
    [0, 1, 0],
  );
});

test('a small file may place a mesh some hundred times', async (t) => {
  const nodes = Array.from({ length: 300 }, () => ({ mesh: 0 }));
  const maker = balls(1, nodes);
  const { areas } = await unwrapped(t, maker, '--own-texels', '--resolution', '2048');
  assert.equal(areas.length, 300);
});
