// Faces whose winding is mixed: a note without --orient, and with it neighbours that run alike in the layout and in the file.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { complaints, parseObj } from '../support/atlas.mjs';
import { randomNumbers } from '../support/disks.mjs';
import { elementsOf, GlbMaker, parseGltf, trianglesOf } from '../support/glb.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { column, elementOf, PLY_FORMATS, parsePly, plyBytes, plyToObj } from '../support/ply.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { binaryStl } from '../support/stl.mjs';
import { knot, moebius, objText, sphere, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const reversed = ([first, ...rest]) => [first, ...rest.reverse()];

/** Some faces the other way round; `turned` are their numbers. */
function mixed({ positions, faces }, seed = 1) {
  const random = randomNumbers(seed);
  const turned = faces.map((_, f) => f).filter(() => random() < 0.5);
  const isTurned = new Set(turned);
  return {
    positions,
    faces: faces.map((face, f) => (isTurned.has(f) ? reversed(face) : face)),
    turned,
  };
}

async function unwrapped(at, input, output, ...options) {
  const args = ['unwrap', input, '-o', output, '--report', 'r.json', ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  return JSON.parse(readFileSync(at('r.json')));
}

/** How many edges lie between faces that run in opposite directions. */
function conflicts(faces) {
  const from = new Map();
  for (const face of faces)
    for (const [k, v] of face.entries()) {
      const edge = `${v} ${face[(k + 1) % face.length]}`;
      from.set(edge, (from.get(edge) ?? 0) + 1);
    }
  return [...from.values()].filter((count) => count > 1).length;
}

const facesOf = (text) => parseObj(text).faces.map((face) => face.map(([v]) => v));

for (const [name, surface] of [
  ['sphere', sphere(6)],
  ['torus', torus(16, 8)],
  ['knot', knot(60, 6)],
])
  test(`${name}: an OBJ is unwrapped as if its faces ran alike`, async (t) => {
    const at = tempFolder(t);
    const { faces, turned } = mixed(surface);
    writeFileSync(at('straight.obj'), objText(surface));
    writeFileSync(at('in.obj'), objText({ ...surface, faces }));
    const straight = await unwrapped(at, 'straight.obj', 'straight-uv.obj', '--orient');
    const report = await unwrapped(at, 'in.obj', 'out.obj', '--orient');
    assert.deepEqual(straight.repair.turnedFaces, []);
    assert.deepEqual(report.repair.turnedFaces, turned);
    assert.deepEqual(report.repair.orientationConflicts, []);
    assert.equal(report.charts.length, straight.charts.length);
    const text = readFileSync(at('out.obj'), 'utf8');
    assert.deepEqual(complaints(text), []);
    assert.deepEqual(facesOf(text), surface.faces);
    assert.deepEqual(parseObj(text).positions, surface.positions);
  });

test('without the option faces stay as they are, and a note names it', async (t) => {
  const at = tempFolder(t);
  const { positions, faces } = mixed(torus(12, 6));
  writeFileSync(at('in.obj'), objText({ positions, faces }));
  const report = await unwrapped(at, 'in.obj', 'out.obj');
  assert.deepEqual(facesOf(readFileSync(at('out.obj'), 'utf8')), faces);
  const edges = conflicts(faces);
  assert.equal(report.repair.orientationConflicts.length, edges);
  assert.deepEqual(
    report.notes.filter((note) => /orient/.test(note)),
    [
      `${edges} edges became seams because the two faces there run in opposite directions. Turn faces alike with the option orient`,
    ],
  );
  writeFileSync(at('straight.obj'), objText(torus(12, 6)));
  const straight = await unwrapped(at, 'straight.obj', 'out.obj');
  assert.deepEqual(
    straight.notes.filter((note) => /orient/.test(note)),
    [],
  );
});

test('words of an OBJ stay with their corner', async (t) => {
  const at = tempFolder(t);
  const { positions, faces, turned } = mixed(sphere(3));
  const normals = positions.map((p) => `vn ${p.join(' ')}\n`).join('');
  const text = `${objText({ positions, faces }, normals)
    .replaceAll(/^f (.*)/gm, (_, words) => `f ${words.replaceAll(/(\d+)/g, '$1//$1')} # face`)
    .replace(/\nf /, '\nusemtl a\nf ')}`;
  writeFileSync(at('in.obj'), text);
  await unwrapped(at, 'in.obj', 'out.obj', '--orient');
  const lines = (content) => content.split('\n').filter((line) => !/^(vt|$)/.test(line));
  const [before, after] = [lines(text), lines(readFileSync(at('out.obj'), 'utf8'))];
  assert.equal(after.length, before.length);
  let f = 0;
  for (const [i, line] of after.entries()) {
    if (!line.startsWith('f ')) {
      assert.equal(line, before[i]);
      continue;
    }
    const words = line.replaceAll(/\/\d+\//g, '//').split(' ');
    const corners = before[i].split(' ').slice(1, -2);
    const wanted = turned.includes(f++) ? reversed(corners) : corners;
    assert.deepEqual(words, ['f', ...wanted, '#', 'face']);
  }
});

test('a surface with one side says that one edge remains', async (t) => {
  const at = tempFolder(t);
  const { positions, faces } = mixed(moebius(24, 1));
  writeFileSync(at('in.obj'), objText({ positions, faces }));
  const report = await unwrapped(at, 'in.obj', 'out.obj', '--orient');
  assert.equal(report.repair.orientationConflicts.length, 1);
  assert.match(
    report.notes.join('\n'),
    /^1 edge became a seam because .*, which no turning of faces changes, as on a Moebius strip$/m,
  );
  assert.deepEqual(complaints(readFileSync(at('out.obj'), 'utf8')), []);
});

for (const format of PLY_FORMATS)
  test(`PLY: rows and their order stay, faces are turned, ${format}`, async (t) => {
    const at = tempFolder(t);
    const { faces } = mixed(torus(12, 6));
    const vertices = torus(12, 6).positions.map((p, v) => [v % 256, ...p.map(Math.fround)]);
    const file = {
      format,
      elements: [
        {
          name: 'vertex',
          properties: [
            { name: 'red', type: 'uchar' },
            ...['x', 'y', 'z'].map((name) => ({ name, type: 'float' })),
          ],
          rows: vertices,
        },
        {
          name: 'face',
          properties: [
            { name: 'id', type: 'int' },
            { name: 'vertex_indices', type: 'int', countType: 'uchar' },
            { name: 'texcoord', type: 'float', countType: 'uchar' },
          ],
          rows: faces.map((face, f) => [f, face, [0, 0, 1, 0, 0, 1]]),
        },
      ],
    };
    writeFileSync(at('in.ply'), plyBytes(file));
    await unwrapped(at, 'in.ply', 'out.ply', '--orient');
    const out = parsePly(readFileSync(at('out.ply')));
    assert.deepEqual(complaints(plyToObj(out)), []);
    const [vertex, face] = ['vertex', 'face'].map((name) => elementOf(out, name));
    const points = column(vertex, 'x', 'y', 'z');
    const uv = column(vertex, 's', 't');
    const corners = column(face, 'vertex_indices');
    assert.deepEqual(
      column(face, 'id'),
      faces.map((_, f) => f),
    );
    assert.deepEqual(
      corners.map((list) => list.map((v) => points[v])),
      torus(12, 6).faces.map((list) => list.map((v) => vertices[v].slice(1))),
    );
    assert.deepEqual(
      column(face, 'texcoord'),
      corners.map((list) => list.flatMap((v) => uv[v])),
    );
  });

test('STL and OFF: what is written runs alike', async (t) => {
  const at = tempFolder(t);
  const { positions, faces } = mixed(torus(12, 6));
  writeFileSync(at('in.stl'), binaryStl(faces.map((face) => face.map((v) => positions[v]))));
  const count = `${positions.length} ${faces.length} 0`;
  const rows = [...positions, ...faces.map((face) => [3, ...face])].map((row) => row.join(' '));
  writeFileSync(at('in.off'), `OFF\n${count}\n${rows.join('\n')}\n`);
  for (const input of ['in.stl', 'in.off']) {
    await unwrapped(at, input, 'out.obj', '--orient');
    const text = readFileSync(at('out.obj'), 'utf8');
    assert.deepEqual(complaints(text), []);
    assert.equal(conflicts(facesOf(text)), 0);
    await unwrapped(at, input, 'out.ply', '--orient');
    assert.deepEqual(complaints(plyToObj(parsePly(readFileSync(at('out.ply'))))), []);
    await unwrapped(at, input, 'out.glb', '--orient');
    assert.deepEqual(await errorsIn(at('out.glb'), at), []);
    assertUpright(parseGltf(readFileSync(at('out.glb'))), 2 * 12 * 6);
  }
});

/** All triangles of a glTF run alike and are not mirrored in the layout; v points down. */
function assertUpright(model, count) {
  const found = [];
  for (const { primitives } of model.json.meshes)
    for (const primitive of primitives) {
      const points = elementsOf(model, primitive.attributes.POSITION);
      const uv = elementsOf(model, primitive.attributes.TEXCOORD_0);
      for (const triangle of trianglesOf(model, primitive)) {
        const [a, b, c] = triangle.map((v) => uv[v]);
        const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        assert.ok(area < 0, `${triangle}`);
        found.push(triangle.map((v) => points[v].join()));
      }
    }
  assert.equal(conflicts(found), 0);
  assert.equal(found.length, count);
}

test('OBJ to glTF: normals stay with their corner', async (t) => {
  const at = tempFolder(t);
  const { positions, faces } = mixed(sphere(4));
  const normals = positions.map((p) => `vn ${p.join(' ')}\n`).join('');
  const text = objText({ positions, faces }, normals);
  writeFileSync(
    at('in.obj'),
    text.replaceAll(/^f (.*)/gm, (line) => line.replaceAll(/(\d+)/g, '$1//$1')),
  );
  await unwrapped(at, 'in.obj', 'out.glb', '--orient');
  const model = parseGltf(readFileSync(at('out.glb')));
  assertUpright(model, 2 * faces.length);
  const [{ attributes }] = model.json.meshes[0].primitives;
  const points = elementsOf(model, attributes.POSITION);
  for (const [v, normal] of elementsOf(model, attributes.NORMAL).entries())
    assert.ok(Math.hypot(...normal.map((x, d) => x - points[v][d])) < 1e-6);
});

for (const [kind, Indices] of [
  ['indices', Uint16Array],
  ['no indices', null],
])
  test(`glTF with ${kind}: triangles are turned, everything else stays`, async (t) => {
    const at = tempFolder(t);
    const { positions, faces } = mixed(torus(12, 6));
    const maker = new GlbMaker();
    const points = Indices ? positions : faces.flat().map((v) => positions[v]);
    const colors = Uint8Array.from(points.flatMap((_, v) => [v % 256, 0, 0, 255]));
    const primitive = {
      attributes: {
        POSITION: maker.accessor(Float32Array.from(points.flat()), 'VEC3', {
          box: true,
          target: 34962,
        }),
        COLOR_0: maker.accessor(colors, 'VEC4', { normalized: true, target: 34962 }),
      },
    };
    if (Indices)
      primitive.indices = maker.accessor(Indices.from(faces.flat()), 'SCALAR', { target: 34963 });
    // Mirrored, so that the triangles that abflat sees are turned already.
    Object.assign(maker.json, {
      meshes: [{ primitives: [primitive] }],
      nodes: [{ mesh: 0, scale: [-1, 1, 1] }],
      scenes: [{ nodes: [0] }],
      scene: 0,
    });
    writeFileSync(at('in.glb'), maker.glb());
    await unwrapped(at, 'in.glb', 'out.glb', '--orient');
    assert.deepEqual(await errorsIn(at('out.glb'), at), []);
    const model = parseGltf(readFileSync(at('out.glb')));
    const [{ attributes }] = model.json.meshes[0].primitives;
    assert.deepEqual(elementsOf(model, attributes.POSITION).slice(0, points.length), [
      ...points.map((p) => p.map(Math.fround)),
    ]);
    assert.deepEqual(
      elementsOf(model, attributes.COLOR_0).slice(0, points.length),
      points.map((_, v) => [v % 256, 0, 0, 255]),
    );
    const found = trianglesOf(model, model.json.meshes[0].primitives[0]).map((triangle) => {
      const at = triangle.map((v) => elementsOf(model, attributes.POSITION)[v].join());
      return at;
    });
    assert.equal(conflicts(found), 0);
    // A mirrored node is seen the other way round.
    const uv = elementsOf(model, attributes.TEXCOORD_0);
    for (const [a, b, c] of trianglesOf(model, model.json.meshes[0].primitives[0]))
      assert.ok(
        (uv[b][0] - uv[a][0]) * (uv[c][1] - uv[a][1]) >
          (uv[b][1] - uv[a][1]) * (uv[c][0] - uv[a][0]),
      );
  });
