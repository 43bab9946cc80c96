// PLY and STL through the program, checked by independent readers and writers.

import assert from 'node:assert/strict';
import { readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { column, elementOf, PLY_FORMATS, parsePly, plyBytes, plyToObj } from '../support/ply.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { judge, sharedMesh, withoutShared } from '../support/shared.mjs';
import { grid, TRIANGLE } from '../support/small-meshes.mjs';
import { binaryStl, textStl, trianglesOf } from '../support/stl.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const float = Math.fround;

/** A wavy sheet of quads and triangles with attributes of all kinds. */
function attributedPly(format) {
  const n = 7;
  const vertices = [];
  const faces = [];
  for (let y = 0; y <= n; y++)
    for (let x = 0; x <= n; x++)
      vertices.push([
        (37 * x + 11 * y) % 256,
        float(x + 0.1 * y),
        float(y),
        float(Math.sin(x) * Math.cos(y)) + 0, // join writes -0 as 0
        0.1 * x,
        Array.from({ length: x % 3 }, (_, i) => x - i),
        9,
        9,
      ]);
  for (let y = 0; y < n; y++)
    for (let x = 0; x < n; x++) {
      const a = y * (n + 1) + x;
      const quad = [a, a + 1, a + n + 2, a + n + 1];
      const rows = (x + y) % 2 ? [quad] : [quad.slice(0, 3), [quad[0], quad[2], quad[3]]];
      for (const corners of rows) faces.push([x % 2, corners, [9, 9], y]);
    }
  return {
    format,
    comments: ['TextureFile skin.png', 'by hand'],
    elements: [
      { name: 'camera', properties: [{ name: 'a', type: 'double' }], rows: [[0.1]] },
      {
        name: 'vertex',
        properties: [
          { name: 'red', type: 'uchar' },
          { name: 'x', type: 'float' },
          { name: 'y', type: 'float' },
          { name: 'z', type: 'float' },
          { name: 'heat', type: 'double' },
          { name: 'bones', type: 'short', countType: 'uchar' },
          { name: 'texture_u', type: 'float' },
          { name: 'texture_v', type: 'float' },
        ],
        rows: vertices,
      },
      {
        name: 'face',
        properties: [
          { name: 'flags', type: 'int' },
          { name: 'vertex_indices', type: 'int', countType: 'uchar' },
          { name: 'texcoord', type: 'float', countType: 'uchar' },
          { name: 'group', type: 'ushort' },
        ],
        rows: faces,
      },
      {
        name: 'edge',
        properties: [
          { name: 'vertex1', type: 'int' },
          { name: 'vertex2', type: 'int' },
        ],
        rows: [
          [0, 1],
          [3, 4],
        ],
      },
    ],
  };
}

const KEPT = ['red', 'x', 'y', 'z', 'heat', 'bones'];

/** Asserts that every row of every element is unchanged, except for texcoords. */
function checkKept(before, after) {
  assert.deepEqual(
    [after.format, after.comments, after.elements.map(({ name }) => name)],
    [before.format, before.comments, before.elements.map(({ name }) => name)],
  );
  for (const name of ['camera', 'edge'])
    assert.deepEqual(elementOf(after, name), elementOf(before, name));
  const [oldRows, newRows] = [before, after].map((file) =>
    column(elementOf(file, 'vertex'), ...KEPT),
  );
  assert.deepEqual(newRows.slice(0, oldRows.length), oldRows);
  const [oldFaces, newFaces] = [before, after].map((file) => elementOf(file, 'face'));
  for (const name of ['flags', 'group'])
    assert.deepEqual(column(newFaces, name), column(oldFaces, name));
  const at = (rows, face) => face.map((v) => rows[v]);
  assert.deepEqual(
    column(newFaces, 'vertex_indices').map((face) => at(newRows, face)),
    column(oldFaces, 'vertex_indices').map((face) => at(oldRows, face)),
  );
  const uv = column(elementOf(after, 'vertex'), 's', 't');
  assert.deepEqual(
    column(newFaces, 'texcoord'),
    column(newFaces, 'vertex_indices').map((face) => at(uv, face).flat()),
  );
}

for (const format of PLY_FORMATS)
  test(`flatten keeps every row and property of a PLY file (${format})`, async (t) => {
    const at = tempFolder(t);
    const before = attributedPly(format);
    writeFileSync(at('in.ply'), plyBytes(before));
    for (const bound of ['auto', '1']) {
      const args = ['flatten', 'in.ply', '-o', 'out.ply', '--t', bound, '--report', 'r.json'];
      const run = await runAbflat(args, { cwd: at() });
      assert.equal(run.code, 0, run.stderr);
      const after = parsePly(readFileSync(at('out.ply')));
      checkKept(before, after);
      const names = elementOf(after, 'vertex').properties.map(({ name }) => name);
      assert.deepEqual(names, [...KEPT, 's', 't']);
      if (withoutShared) continue;
      writeFileSync(at('in.obj'), plyToObj(before));
      writeFileSync(at('out.obj'), plyToObj(after));
      assert.equal(judge(at('in.obj'), at('out.obj'), bound === '1' ? 1.00001 : 2).valid, true);
    }
  });

for (const format of PLY_FORMATS)
  test(`a PLY file can be replaced by its own result, again and again (${format})`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('a.ply'), plyBytes(attributedPly(format)));
    const results = [];
    for (let i = 0; i < 2; i++) {
      const run = await runAbflat(['flatten', 'a.ply', '-o', 'a.ply'], { cwd: at() });
      assert.equal(run.code, 0, run.stderr);
      results.push(readFileSync(at('a.ply')));
    }
    assert.deepEqual(results[1], results[0]);
  });

test('a file is not replaced by another format, whatever it is called', async (t) => {
  const at = tempFolder(t);
  const ply = plyBytes(attributedPly('ascii'));
  writeFileSync(at('mesh'), ply);
  symlinkSync('mesh', at('link.obj'));
  for (const output of ['mesh', 'link.obj']) {
    const run = await runAbflat(['flatten', 'mesh', '-o', output], { cwd: at() });
    assert.equal(run.code, 2);
    assert.match(run.stderr, /mesh: the result is OBJ and would replace this PLY file/);
    assert.deepEqual(readFileSync(at('mesh')), ply);
  }
});

test('a surface that touches itself at a vertex gets that vertex twice', async (t) => {
  const at = tempFolder(t);
  // A band around a square hole; its ends share a corner, but no edge.
  const points = [
    [0, 0],
    [3, 0],
    [3, 3],
    [0, 3],
    [1, 1],
    [2, 1],
    [2, 2],
    [0, 1.5],
  ];
  const faces = [
    [0, 1, 5],
    [0, 5, 4],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 6],
    [3, 4, 6],
    [3, 7, 4],
  ];
  const file = {
    format: 'binary_little_endian',
    elements: [
      {
        name: 'vertex',
        properties: ['x', 'y', 'z'].map((name) => ({ name, type: 'float' })),
        rows: points.map(([x, y]) => [x, y, 0]),
      },
      {
        name: 'face',
        properties: [{ name: 'vertex_indices', type: 'int', countType: 'uchar' }],
        rows: faces.map((face) => [face]),
      },
    ],
  };
  writeFileSync(at('in.ply'), plyBytes(file));
  const run = await runAbflat(['flatten', 'in.ply', '-o', 'out.ply'], { cwd: at() });
  assert.equal(run.code, 0, run.stderr);
  const after = parsePly(readFileSync(at('out.ply')));
  const rows = column(elementOf(after, 'vertex'), 'x', 'y', 'z');
  const before = elementOf(file, 'vertex').rows;
  assert.deepEqual(rows, [...before, before[4]]);
});

test('the report is about the coordinates as they are written', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  // At that scale, single precision has hardly any numbers left.
  const scaled = (_, x, y, z) => `v ${[x, y, z].map((c) => Number(c) * 1e-45).join(' ')}`;
  writeFileSync(at('tiny.obj'), grid(6).replaceAll(/^v (\S+) (\S+) (\S+)/gm, scaled));
  const type = (file) => elementOf(file, 'vertex').properties.find(({ name }) => name === 's').type;
  const flattened = async (name) => {
    const args = ['flatten', `${name}.obj`, '-o', 'out.ply', '--report', 'r.json'];
    const run = await runAbflat(args, { cwd: at() });
    assert.equal(run.code, 0, run.stderr);
    const file = parsePly(readFileSync(at('out.ply')));
    return { file, chart: JSON.parse(readFileSync(at('r.json'))).charts[0] };
  };
  const usual = await flattened('in');
  assert.equal(type(usual.file), 'float');
  assert.deepEqual(usual.chart.fallbacks, []);
  const obj = await runAbflat(['flatten', 'in.obj', '-o', 'o.obj', '--report', 'o.json'], {
    cwd: at(),
  });
  assert.equal(obj.code, 0);
  const inDouble = JSON.parse(readFileSync(at('o.json'))).charts[0].angularDistortion;
  assert.notEqual(usual.chart.angularDistortion, inDouble);
  assert.ok(Math.abs(usual.chart.angularDistortion - inDouble) < 1e-6);
  const tiny = await flattened('tiny');
  assert.equal(type(tiny.file), 'double');
  assert.match(
    tiny.chart.fallbacks.join(),
    /double precision: rounded to single precision, \d+ triangle/,
  );
});

test('any input is written as OBJ or PLY, with the same layout', async (t) => {
  const at = tempFolder(t);
  const triangles = trianglesOf(grid(5)).map((points) => points.map((p) => p.map(float)));
  writeFileSync(at('a.stl'), binaryStl(triangles, 'solid'));
  writeFileSync(at('b.stl'), textStl(triangles));
  const files = [];
  for (const input of ['a.stl', 'b.stl'])
    for (const output of ['out.obj', 'out.ply']) {
      const run = await runAbflat(['flatten', input, '-o', output], { cwd: at() });
      assert.equal(run.code, 0, run.stderr);
      files.push(readFileSync(at(output)));
    }
  assert.deepEqual(files[0], files[2]);
  assert.deepEqual(files[1], files[3]);
  const { rows } = elementOf(parsePly(files[1]), 'face');
  assert.equal(rows.length, triangles.length);
  const { stdout } = await runAbflat(['inspect', 'a.stl', '--json'], { cwd: at() });
  assert.equal(JSON.parse(stdout).vertices, 36);
  const piped = await runAbflat(['flatten', '-', '-o', '-'], { input: binaryStl(triangles) });
  assert.deepEqual(piped.bytes, files[0]);
  for (const command of ['sweep', 'compare']) {
    const run = await runAbflat([command, 'a.stl'], { cwd: at() });
    assert.equal(run.code, 0, run.stderr);
  }
});

test('a name that promises another format is refused with those that are known', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), TRIANGLE);
  for (const output of ['out.off', 'out.stl', 'out.vrml', 'out.txt']) {
    const run = await runAbflat(['flatten', 'in.obj', '-o', output], { cwd: at() });
    assert.equal(run.code, 2);
    assert.match(run.stderr, /cannot write \.\w+ files\. Use \.obj, \.ply, \.glb or \.gltf\./);
  }
});

test('a sample is written as PLY', async (t) => {
  const at = tempFolder(t);
  assert.equal((await runAbflat(['sample', 'head', '-o', 'a.ply'], { cwd: at() })).code, 0);
  assert.equal((await runAbflat(['sample', 'head', '-o', 'a.obj'], { cwd: at() })).code, 0);
  const numbers = (text) => text.match(/[-\d.e]+/g).map(Number);
  const ply = plyToObj(parsePly(readFileSync(at('a.ply'))));
  assert.deepEqual(numbers(ply), numbers(readFileSync(at('a.obj'), 'utf8')));
});

for (const mesh of ['nefertiti.off', 'cathead.obj', 'hemisphere.obj'])
  test(`PLY of ${mesh} is valid as it is written`, { skip: withoutShared }, async (t) => {
    const at = tempFolder(t);
    for (const bound of ['2', '1']) {
      const args = ['flatten', sharedMesh(mesh), '-o', 'out.ply', '--t', bound];
      const run = await runAbflat(args, { cwd: at() });
      assert.equal(run.code, 0, run.stderr);
      writeFileSync(at('out.obj'), plyToObj(parsePly(readFileSync(at('out.ply')))));
      const verdict = judge(sharedMesh(mesh), at('out.obj'), 2);
      assert.deepEqual(verdict.failures, []);
    }
  });
