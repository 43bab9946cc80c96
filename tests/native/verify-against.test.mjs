// abflat verify --against: whether a file is still the mesh that it was made from; --picture.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { parsePng } from '../support/png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** A box of quads with a pentagon on it, in two materials that alternate, with normals. */
const MESH = `mtllib in.mtl
v 0 0 0
v 2 0 0
v 2 1 0
v 0 1 0
v 0 0 1
v 2 0 1
v 2 1 1
v 0 1 1
v 1 2 0
v 1 2 1
vn 0 0 -1
vn 0 0 1
vn 0 -1 0
vn 1 0 0
vn -1 0 0
vn 0.707 0.707 0
vn -0.707 0.707 0
usemtl a
f 1//1 4//1 9//1 3//1 2//1
usemtl b
f 5//2 6//2 7//2 10//2 8//2
usemtl a
f 1//3 2//3 6//3 5//3
usemtl b
f 2//4 3//4 7//4 6//4
f 4//5 1//5 5//5 8//5
usemtl a
f 3//6 9//6 10//6 7//6
f 9//7 4//7 8//7 10//7
`;
const MTL = 'newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n';

const setUp = async (t, ...outputs) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), MESH);
  writeFileSync(at('in.mtl'), MTL);
  const run = (...args) => runAbflat(args, { cwd: at() });
  for (const name of outputs) {
    const { code, stderr } = await run('unwrap', 'in.obj', '-o', name, '-q');
    assert.equal(code, 0, stderr);
  }
  const against = async (name, was = 'in.obj') => {
    const { code, stdout, stderr } = await run(
      ...['verify', name, '--against', was, '--report', 'r.json', '-q'],
    );
    assert.equal(stdout + stderr, '');
    const { findings, against } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assert.equal(against, was);
    assert.equal(code, findings.length > 0 ? 1 : 0);
    return findings
      .filter(({ rule }) => ['geometry', 'order', 'attributes'].includes(rule))
      .map(({ rule, message }) => `${rule}: ${message}`);
  };
  return { at, run, against };
};

test('what unwrap writes is the mesh that it read', async (t) => {
  const { run, against } = await setUp(t, 'out.obj', 'out.glb', 'out.ply');
  assert.deepEqual(await against('out.obj'), []);
  assert.deepEqual(await against('out.glb'), []);
  // A PLY that is made from another format has neither.
  assert.deepEqual(await against('out.ply'), [
    'attributes: normals are missing',
    'attributes: materials are missing',
  ]);
  await run('unwrap', 'out.glb', '-o', 'again.glb', '--padding', '9', '-q');
  assert.deepEqual(await against('again.glb', 'out.glb'), []);
  await run('unwrap', 'out.ply', '-o', 'again.ply', '-q');
  assert.deepEqual(await against('again.ply', 'out.ply'), []);
});

test('every change is found, and where it is', async (t) => {
  const { at, against } = await setUp(t, 'out.obj');
  const text = readFileSync(at('out.obj'), 'utf8');
  const changed = async (change) => {
    const now = change(text);
    assert.notEqual(now, text);
    writeFileSync(at('now.obj'), now);
    return against('now.obj');
  };
  const faces = text.split('\n').filter((line) => line.startsWith('f '));
  const swap = (a, b) => (all) => all.replace(a, '@').replace(b, a).replace('@', b);
  assert.deepEqual(await changed((all) => all.replace('v 2 1 1', 'v 2 1 1.001')), [
    'geometry: 3 faces are missing, the first of which was face 1',
    'geometry: 3 faces were not there before, the first of which is face 1',
    'order: vertex 6 is elsewhere, or vertices are in another order',
  ]);
  assert.deepEqual(await changed((all) => all.replace('v 2 1 1', 'v 2 1 1.000000001')), []);
  assert.deepEqual(await changed((all) => all.replace(`${faces[6]}\n`, '')), [
    'geometry: 1 face is missing: it was face 6',
  ]);
  assert.deepEqual(await changed((all) => `${all}${faces[0]}\n`), [
    'geometry: 1 face was not there before: face 7',
  ]);
  assert.deepEqual(await changed(swap(faces[3], faces[4])), [
    'order: faces are in another order: face 4 was face 3',
  ]);
  assert.deepEqual(await changed((all) => all.replace('vn 0 0 1', 'vn 0 1 1')), [
    'attributes: 1 face has other normals: face 1',
  ]);
  assert.deepEqual(await changed((all) => all.replaceAll('usemtl b', 'usemtl c')), [
    'attributes: 3 faces have other materials, the first of which is face 1',
  ]);
  assert.deepEqual(await changed((all) => `${all}v 9 9 9\n`), []);
});

test('the picture shows faults in colour', async (t) => {
  const { at, run } = await setUp(t, 'out.obj');
  const coloursOf = async (...more) => {
    await run('verify', 'now.obj', '--picture', 'p.png', '--resolution', '256', '-q', ...more);
    const picture = parsePng(readFileSync(at('p.png')));
    assert.deepEqual([picture.width, picture.height], [256, 256]);
    const seen = new Set();
    for (let y = 0; y < 256; y++)
      for (let x = 0; x < 256; x++) seen.add([...picture.at(x, y)].slice(0, 3).join());
    return seen;
  };
  const text = readFileSync(at('out.obj'), 'utf8');
  const [vermilion, blue, purple] = ['213,94,0', '0,114,178', '204,121,167'];
  writeFileSync(at('now.obj'), text);
  const good = await coloursOf();
  for (const colour of [vermilion, blue, purple]) assert.ok(!good.has(colour), colour);
  assert.ok((await coloursOf('--min-island-width', '9999')).has(purple));
  const mirrored = text.replace(/^vt (\S+)/gm, (_, u) => `vt ${1 - u}`);
  writeFileSync(at('now.obj'), mirrored);
  assert.ok((await coloursOf()).has(blue));
  assert.ok(!(await coloursOf('--allow-mirrored')).has(blue));
  const half = text.replace(/^vt (\S+) (\S+)/gm, (_, u, v) => `vt ${u % 0.5} ${v % 0.5}`);
  writeFileSync(at('now.obj'), half);
  assert.ok((await coloursOf()).has(vermilion));
  const { code, stderr } = await run('verify', 'now.obj', '--picture', 'p.svg');
  assert.equal(code, 2);
  assert.match(stderr, /\.png/);
});
