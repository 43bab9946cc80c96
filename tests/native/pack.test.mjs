// abflat pack: islands keep their shapes, and nothing overlaps that lay apart.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { elementsOf, GlbMaker, parseGltf } from '../support/glb.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { islandsOf } from '../support/islands.mjs';
import { hasTerminals, runAbflat, runOnTerminal } from '../support/run-abflat.mjs';
import { CUBE, CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const ARTIST = join(ROOT, '../shared/artist');
const artistMeshes = existsSync(ARTIST)
  ? readdirSync(ARTIST).filter((name) => name.endsWith('.obj'))
  : [];

/** The uv of each face's corners. */
function facesOf(text) {
  const texcoords = [];
  const faces = [];
  for (const line of text.split(/\r?\n/)) {
    const [key, ...words] = line.trim().split(/\s+/);
    if (key === 'vt') texcoords.push(words.slice(0, 2).map(Number));
    if (key === 'f') faces.push(words.map((word) => texcoords[Number(word.split('/')[1]) - 1]));
  }
  return faces;
}

async function packed(t, text, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), text);
  const args = ['pack', 'in.obj', '-o', 'out.obj', '--report', 'r.json', ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 0, stderr);
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.equal(report.valid, true);
  return { report, text: readFileSync(at('out.obj'), 'utf8') };
}

const lengthOf = ([x, y]) => Math.hypot(x, y);
const minus = ([a, b], [c, d]) => [a - c, b - d];

/** Of each face with area: what multiplies its edges as complex numbers; the same for its island. */
function turnsOf(before, after) {
  return before.map((face, f) => {
    const edges = face.map((_, i) => minus(face[(i + 1) % face.length], face[0]));
    const longest = edges.reduce((a, b) => (lengthOf(a) > lengthOf(b) ? a : b));
    const at = (edges.indexOf(longest) + 1) % face.length;
    const [x, y] = minus(after[f][at], after[f][0]);
    const [a, b] = longest;
    const square = a * a + b * b;
    if (square < 1e-12) return undefined;
    return [(x * a + y * b) / square, (y * a - x * b) / square];
  });
}

/** Throws unless each face is similar to itself, and all faces of an island are moved alike. */
function checkShapes(islands, before, after) {
  const turnOf = new Map();
  for (const [f, turn] of turnsOf(before, after).entries()) {
    if (!turn) continue;
    const first = turnOf.get(islands[f]) ?? turn;
    turnOf.set(islands[f], first);
    for (const [i, corner] of before[f].entries()) {
      const [x, y] = minus(corner, before[f][0]);
      const [u, v] = minus(after[f][i], after[f][0]);
      const [c, s] = first;
      const off = Math.hypot(u - (c * x - s * y), v - (s * x + c * y));
      assert.ok(off < 1e-6, `face ${f} is off by ${off}`);
    }
  }
  return turnOf;
}

const crossOf = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);

function trianglesOf(faces) {
  const out = [];
  for (const [f, face] of faces.entries())
    for (let i = 1; i + 1 < face.length; i++) {
      const points = [face[0], face[i], face[i + 1]];
      const area = crossOf(...points);
      if (area < 0) points.reverse();
      if (area !== 0) out.push({ f, points, box: [0, 1].map((d) => points.map((p) => p[d])) });
    }
  for (const t of out) t.box = t.box.map((xs) => [Math.min(...xs), Math.max(...xs)]);
  return out;
}

const separates = (a, b) =>
  a.some((p, i) => b.every((q) => crossOf(p, a[(i + 1) % 3], q) <= 1e-12));

/** Pairs of islands with overlapping triangles, as "i j". */
function overlapsIn(faces, islands) {
  const triangles = trianglesOf(faces).sort((a, b) => a.box[0][0] - b.box[0][0]);
  const pairs = new Set();
  for (const [i, a] of triangles.entries())
    for (let j = i + 1; j < triangles.length && triangles[j].box[0][0] < a.box[0][1]; j++) {
      const b = triangles[j];
      const key = [islands[a.f], islands[b.f]].sort((x, y) => x - y).join(' ');
      if (islands[a.f] === islands[b.f] || pairs.has(key)) continue;
      if (b.box[1][0] >= a.box[1][1] || a.box[1][0] >= b.box[1][1]) continue;
      if (!separates(a.points, b.points) && !separates(b.points, a.points)) pairs.add(key);
    }
  return pairs;
}

for (const name of artistMeshes)
  test(`${name}: shapes are kept, nothing new overlaps, all lie in the tile`, async (t) => {
    const source = readFileSync(join(ARTIST, name), 'utf8');
    const { report, text } = await packed(t, source);
    const islands = islandsOf(source);
    assert.equal(report.islands, new Set(islands).size);
    assert.deepEqual(islandsOf(text), islands);
    const before = facesOf(source);
    const after = facesOf(text);
    for (const [u, v] of after.flat()) assert.ok(u >= 0 && u <= 1 && v >= 0 && v <= 1);
    for (const [c, s] of checkShapes(islands, before, after).values())
      assert.ok(Math.abs(Math.hypot(c, s) / report.scale - 1) < 1e-6);
    const overlapping = overlapsIn(before, islands);
    for (const pair of overlapsIn(after, islands)) assert.ok(overlapping.has(pair), pair);
  });

test('what stays where it is comes back as it was, and its faces are counted', async (t) => {
  const at = tempFolder(t);
  const text = [
    ...['v 0 0 0', 'v 1 0 0', 'v 0 1 0', 'v 3 0 0', 'v 4 0 0', 'v 3 1 0'],
    ...['vt 0 0', 'vt 0.5 0', 'vt 0 0.5', 'vt -0.25 0.25', 'vt 0.25 0.25', 'vt 0.125 -0.25'],
    ...['f 1/1 2/2 3/3', 'f 4/4 5/5 6/6', ''],
  ].join('\n');
  writeFileSync(at('in.obj'), text);
  const args = ['pack', 'in.obj', '-o', 'out.obj', '--keep-places', '--report', 'r.json'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 1, stderr);
  assert.deepEqual(facesOf(readFileSync(at('out.obj'), 'utf8')), facesOf(text));
  const { islands, faces, scale } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.deepEqual(
    { islands, faces, scale },
    { islands: 2, faces: { overlapping: 2, flipped: 1, empty: 0, outside: 1 }, scale: 1 },
  );
});

const terminalless = hasTerminals() ? false : 'there is no util-linux "script" to make a terminal';

test('the program says what it has found in a layout that is to stay', {
  skip: terminalless,
}, (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n');
  const run = (...options) =>
    runOnTerminal(['pack', at('in.obj'), '-o', at('out.obj'), ...options]).seen;
  const found = run('--keep-places');
  assert.match(found, /faces: 0 overlapping, 0 flipped, 0 without area, 0 outside/);
  assert.doesNotMatch(found, /times what they were/);
  assert.match(run(), /times what they were/);
});

test('without artists, a cube of two islands: turned only as asked, at least as large', async (t) => {
  const islands = islandsOf(CUBE_OF_PARTS);
  for (const [rotate, isRight] of [
    ['none', ([c, s]) => c > 0 && Math.abs(s) < 1e-9],
    ['quarter', ([c, s]) => Math.abs(c * s) < 1e-9],
    ['free', () => true],
  ]) {
    const { report, text } = await packed(t, CUBE_OF_PARTS, '--rotate', rotate);
    const turns = checkShapes(islands, facesOf(CUBE_OF_PARTS), facesOf(text));
    for (const turn of turns.values()) assert.ok(isRight(turn), `${rotate}: ${turn}`);
    assert.ok(report.scale > 1.5, rotate);
  }
});

test('the margin is as asked, and by default half the padding', async (t) => {
  for (const [margin, texels] of [
    ['auto', 3],
    ['0', 0],
    ['40', 40],
  ]) {
    const options = ['--margin', margin, '--padding', '5', '--rotate', 'none'];
    const { report, text } = await packed(t, CUBE_OF_PARTS, ...options);
    assert.equal(report.margin, texels);
    const least = Math.min(...facesOf(text).flat(2));
    assert.ok(least * 1024 >= texels && least * 1024 < texels + 1.5, `${margin}: ${least}`);
  }
});

test('a mesh without texcoords is refused with exit code 4', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), CUBE);
  const { code, stderr } = await runAbflat(['pack', 'in.obj', '-o', 'out.obj'], { cwd: at() });
  assert.equal(code, 4);
  assert.equal(
    stderr,
    'abflat: in.obj: no face has texcoords, so there is no layout to pack. Make one with unwrap.\n',
  );
  assert.equal(existsSync(at('out.obj')), false);
});

test('faces without texcoords have none in the output', async (t) => {
  const source = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvt 0 0\nvt 2 0\nvt 0 2\n';
  const { report, text } = await packed(
    t,
    `${source}f 1/1/1 2/2/1 3/3/1\nf 2//1 4//1 3//1\nf 2 4 3\n`,
  );
  assert.equal(report.unmapped, 2);
  const faces = text.split('\n').filter((line) => line.startsWith('f '));
  assert.deepEqual(faces, ['f 1/1/1 2/2/1 3/3/1', 'f 2//1 4//1 3//1', 'f 2 4 3']);
});

test('glTF: vertices stay, normals do not cut islands, both files are valid', async (t) => {
  const maker = new GlbMaker();
  const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
  const uv = [0, 0, 3, 0, 0, 3, 3, 0, 3, 3, 0, 3];
  const attributes = {
    POSITION: maker.accessor(Float32Array.from(square), 'VEC3', { box: true }),
    TEXCOORD_1: maker.accessor(Float32Array.from(uv), 'VEC2'),
    TEXCOORD_0: maker.accessor(
      Float32Array.from(uv, (x) => x / 7),
      'VEC2',
    ),
  };
  const indices = maker.accessor(Uint16Array.from([0, 1, 2, 3, 4, 5]), 'SCALAR');
  Object.assign(maker.json, { meshes: [{ primitives: [{ attributes, indices }] }] });
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), maker.glb());
  const args = ['pack', 'in.glb', '-o', 'out.glb', '--read-texcoord', '1', '--report', 'r.json'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 0, stderr);
  assert.deepEqual(await errorsIn(at('out.glb'), at), []);
  const { islands, scale, valid } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.deepEqual({ islands, valid }, { islands: 1, valid: true });
  const model = parseGltf(readFileSync(at('out.glb')));
  const [primitive] = model.json.meshes[0].primitives;
  const texcoords = elementsOf(model, primitive.attributes.TEXCOORD_1);
  assert.equal(texcoords.length, 6);
  const side = lengthOf(minus(texcoords[1], texcoords[0]));
  assert.ok(Math.abs(side / (3 * scale) - 1) < 1e-6);
  assert.ok(side > 0.99);
  const other = elementsOf(model, primitive.attributes.TEXCOORD_0);
  assert.ok(Math.abs(other[1][0] - 3 / 7) < 1e-6);
});

test('PLY and pictures', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), CUBE_OF_PARTS);
  for (const picture of ['a.svg', 'a.png']) {
    const args = ['pack', 'in.obj', '-o', 'out.ply', '--layout', picture];
    const { code, stderr } = await runAbflat(args, { cwd: at() });
    assert.equal(code, 0, stderr);
    assert.ok(existsSync(at(picture)));
  }
  const { code } = await runAbflat(['pack', 'out.ply', '-o', 'again.ply'], { cwd: at() });
  assert.equal(code, 0);
});
