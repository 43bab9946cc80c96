// Seams that the input already has: between its uv islands, and between its materials.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { islandsOf } from '../support/islands.mjs';
import { parsePly, plyToObj } from '../support/ply.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import * as surfaces from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const count = (islands) => new Set(islands).size;

/** Unwraps a file to an OBJ text, and says how. */
async function unwrapped(at, input, seams) {
  const args = ['unwrap', input, '-o', 'out.obj', '--report', 'r.json', '--seams', seams];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  if (code !== 0) return { code, stderr };
  return {
    code,
    stderr,
    text: readFileSync(at('out.obj'), 'utf8'),
    report: JSON.parse(readFileSync(at('r.json'), 'utf8')),
  };
}

/** A text whose faces the program has cut into charts: its islands are disks. */
async function withIslands(at, surface, name) {
  writeFileSync(at('plain.obj'), surfaces.objText(surface));
  const { code, stderr } = await runAbflat(['unwrap', 'plain.obj', '-o', name], { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
}

test('uv keeps the islands of a real mesh', { skip: withoutShared }, async (t) => {
  const at = tempFolder(t);
  const input = sharedMesh('spot-uv.obj');
  const before = islandsOf(readFileSync(input, 'utf8'));
  assert.ok(count(before) > 1);
  const { text, report } = await unwrapped(at, input, 'uv');
  assert.deepEqual(islandsOf(text), before);
  assert.equal(report.charts.length, count(before));
  assert.equal(report.valid, true);
});

test('uv keeps the islands of atlases of our own, from OBJ and PLY', async (t) => {
  const at = tempFolder(t);
  for (const [name, surface] of Object.entries({
    torus: isInstrumented ? surfaces.torus(14, 8) : surfaces.torus(),
    knot: isInstrumented ? surfaces.knot(40, 6) : surfaces.knot(80, 8),
    isosurface: surfaces.isosurface(isInstrumented ? 6 : 12),
  })) {
    await withIslands(at, surface, 'atlas.obj');
    const before = islandsOf(readFileSync(at('atlas.obj'), 'utf8'));
    const { text } = await unwrapped(at, 'atlas.obj', 'uv');
    assert.deepEqual(islandsOf(text), before, name);
    await withIslands(at, surface, 'atlas.ply');
    const ply = parsePly(readFileSync(at('atlas.ply')));
    const fromPly = await unwrapped(at, 'atlas.ply', 'uv');
    assert.deepEqual(islandsOf(fromPly.text), islandsOf(plyToObj(ply)), `${name} as PLY`);
  }
});

/** A cube whose sides are three pairs of quads; uv of each corner, or none. */
const CUBE = {
  positions: [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]),
  faces: [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ],
};

test('corners without texcoords, or with unusable ones, are an island of their own', async (t) => {
  const at = tempFolder(t);
  const v = CUBE.positions.map((p) => `v ${p.join(' ')}`).join('\n');
  // Side 0 has texcoords; the others have none, texcoords that are not numbers, or indices of
  // nothing.
  const uv = 'vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt nan nan\nvt x\n';
  const corners = [
    [1, 2, 3, 4],
    null,
    [5, 5, 5, 5],
    [99, 99, 99, 99],
    [6, 6, 6, 6],
    [-99, 0, 0, 7],
  ];
  const f = CUBE.faces.map(
    (face, i) =>
      `f ${face.map((p, k) => (corners[i] ? `${p + 1}/${corners[i][k]}` : p + 1)).join(' ')}`,
  );
  writeFileSync(at('in.obj'), `${v}\n${uv}${f.join('\n')}\n`);
  const { text, report } = await unwrapped(at, 'in.obj', 'uv');
  assert.equal(report.valid, true);
  assert.deepEqual(islandsOf(text), [0, 1, 1, 1, 1, 1]);
});

test('texcoords are compared by value, per end of an edge', async (t) => {
  const at = tempFolder(t);
  const text = (uv, f) =>
    `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n${uv.map((x) => `vt ${x}`).join('\n')}\n${f}`;
  const quad = ['0 0', '1 0', '1 1', '0 1'];
  for (const [uv, f, islands] of [
    [quad, 'f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n', [0, 0]],
    [[...quad, '-0 0.0', '1e0 1'], 'f 1/1 2/2 3/3\nf 1/5 3/6 4/4\n', [0, 0]],
    [[...quad, '0.5 0'], 'f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n', [0, 1]],
    [[...quad, '0.5 0'], 'f 1/1 2/2 3/3\nf 1/1 3/5 4/4\n', [0, 1]],
  ]) {
    writeFileSync(at('in.obj'), text(uv, f));
    assert.deepEqual(islandsOf((await unwrapped(at, 'in.obj', 'uv')).text), islands);
  }
});

test('PLY: texcoords of corners, as MeshLab writes them, and of vertices under all their names', async (t) => {
  const at = tempFolder(t);
  const head = (vertex, face) =>
    `ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n${vertex}element face 2\nproperty list uchar int vertex_indices\n${face}end_header\n`;
  const xy = ['0 0', '1 0', '1 1', '0 1'];
  const corners = (b) => `3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 ${b}\n`;
  const list = head('', 'property list uchar float texcoord\n');
  const vertices = xy.map((p) => `${p} 0\n`).join('');
  for (const [b, islands] of [
    ['0 0 1 1 0 1', [0, 0]],
    ['0.5 0 1 1 0 1', [0, 1]],
  ]) {
    writeFileSync(at('in.ply'), list + vertices + corners(b));
    assert.deepEqual(islandsOf((await unwrapped(at, 'in.ply', 'uv')).text), islands);
  }
  for (const [u, v] of [
    ['s', 't'],
    ['u', 'v'],
    ['texture_u', 'texture_v'],
  ]) {
    const properties = `property float ${u}\nproperty float ${v}\n`;
    // Six vertices: those of the diagonal occur twice, with different texcoords.
    const text = head(properties, '').replace('vertex 4', 'vertex 6');
    const rows = [...xy, xy[0], xy[2]].map((p, i) => `${p} 0 ${i < 4 ? p : '7 7'}\n`).join('');
    writeFileSync(at('in.ply'), `${text}${rows}3 0 1 2\n3 4 5 3\n`);
    const { text: out } = await unwrapped(at, 'in.ply', 'uv');
    assert.deepEqual(islandsOf(out), [0, 1]);
  }
});

test('material cuts where materials meet, and nowhere else', async (t) => {
  const at = tempFolder(t);
  const { positions, faces } = surfaces.sphere(6);
  const isUpper = (face) => face.reduce((sum, v) => sum + positions[v][2], 0) > 0;
  const v = positions.map((p) => `v ${p.join(' ')}\n`).join('');
  // Names may contain # and blanks; repeating the same name changes nothing.
  const names = ['skin #1', 'skin #2'];
  const f = faces
    .map(
      (face) => `usemtl ${names[Number(isUpper(face))]}\nf ${face.map((i) => i + 1).join(' ')}\n`,
    )
    .join('');
  writeFileSync(at('in.obj'), v + f);
  const { text, report } = await unwrapped(at, 'in.obj', 'material');
  const first = Number(isUpper(faces[0]));
  assert.deepEqual(
    islandsOf(text),
    faces.map((face) => Number(Number(isUpper(face)) !== first)),
  );
  assert.equal(report.valid, true);
  // Faces before the first name share a material too.
  const half = faces.map((face, i) => [i === 40 ? 'usemtl a\n' : '', face]);
  writeFileSync(
    at('in.obj'),
    v + half.map(([use, face]) => `${use}f ${face.map((i) => i + 1).join(' ')}\n`).join(''),
  );
  const islands = islandsOf((await unwrapped(at, 'in.obj', 'material')).text);
  assert.ok(islands.slice(0, 40).every((island) => !islands.slice(40).includes(island)));
});

test('sources go together, and say what they miss', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), surfaces.objText(CUBE));
  for (const [seams, missing] of [
    ['uv', /^abflat: in\.obj: the mesh has no texcoords.*Leave uv out/],
    ['auto,uv', /no texcoords/],
    ['material', /^abflat: in\.obj: the mesh has no materials.*Leave material out/],
  ]) {
    const { code, stderr } = await unwrapped(at, 'in.obj', seams);
    assert.deepEqual([code, missing.test(stderr)], [2, true], stderr);
  }
  const text = surfaces.objText(CUBE, 'vt 0 0\nusemtl a\n');
  writeFileSync(at('in.obj'), text.replace('f 1 3 4 2', 'f 1/1 3/1 4/1 2/1'));
  const count = async (seams) =>
    new Set(islandsOf((await unwrapped(at, 'in.obj', seams)).text)).size;
  assert.equal(await count('uv,material'), 2);
  assert.equal(await count('uv,sharp=60'), 6);
  assert.equal(await count('material,sharp=60'), 6);
});
