// The inspect and sample commands.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { runAbflat } from '../support/run-abflat.mjs';
import { grid, TETRAHEDRON, TRIANGLE } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const NAMES = ['hemisphere', 'wavy-strip', 'head', 'alpha-band', 'three-balls'];

const inspectJson = async (args, options) =>
  JSON.parse((await runAbflat(['inspect', '--json', ...args], options)).stdout);

test('inspect prints an aligned table, exit code 0', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(4));
  const run = await runAbflat(['inspect', 'in.obj'], { cwd: at() });
  assert.deepEqual([run.code, run.stderr], [0, '']);
  const [title, ...rows] = run.stdout.trimEnd().split('\n');
  assert.equal(title, 'in.obj');
  assert.equal(new Set(rows.map((row) => row.length)).size, 1, 'values end in one column');
  assert.match(run.stdout, /^ +vertices +25$/m);
  assert.match(run.stdout, /^ +faces +32$/m);
  assert.match(run.stdout, /^ +boundary edges +16$/m);
  assert.match(run.stdout, /^ +disk +yes$/m);
});

test('inspect says what stands in the way, exit code 0 all the same', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('closed.off'), TETRAHEDRON);
  const run = await runAbflat(['inspect', 'closed.off'], { cwd: at() });
  assert.equal(run.code, 0);
  assert.match(run.stdout, /^ +disk +no$/m);
  assert.match(run.stdout, /closed surface/);
  const json = await inspectJson(['closed.off'], { cwd: at() });
  assert.equal(json.disk.ok, false);
  assert.equal(json.disk.code, 'ClosedSurface');
  assert.match(json.disk.message, /closed surface/);
});

test('inspect --json gives the same counts, from a file and from a pipe', async () => {
  const { disk, ...counts } = await inspectJson(['-'], { input: TRIANGLE });
  assert.deepEqual(counts, {
    path: '-',
    vertices: 3,
    unreferencedVertices: 0,
    faces: 1,
    triangles: 1,
    components: 1,
    boundaryLoops: 1,
    boundaryEdges: 3,
    nonManifoldEdges: 0,
    orientationConflicts: 0,
    degenerateFaces: 0,
    eulerCharacteristic: 1,
    genus: 0,
    texcoords: 0,
    normals: 0,
    smoothingGroups: 0,
    materials: 0,
  });
  assert.deepEqual(disk, { ok: true, code: 'Ok', message: '' });
});

test('inspect of a mesh that is not orientable as given has no genus', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('a.obj'), `${TRIANGLE}v 1 1 0\nf 2 3 4\n`);
  const run = await runAbflat(['inspect', 'a.obj'], { cwd: at() });
  assert.equal(run.code, 0);
  assert.match(run.stdout, /^ +orientation conflicts +1$/m);
  assert.match(run.stdout, /^ +genus +undefined$/m);
});

for (const name of NAMES)
  test(`sample ${name} is a disk that flattens`, async (t) => {
    const at = tempFolder(t);
    const made = await runAbflat(['sample', name, '-o', 'a.obj'], { cwd: at() });
    assert.deepEqual([made.code, made.stdout, made.stderr], [0, '', '']);
    const summary = await inspectJson(['a.obj'], { cwd: at() });
    assert.equal(summary.disk.ok, true, summary.disk.message);
    assert.equal(summary.degenerateFaces, 0);
    const flat = await runAbflat(['flatten', 'a.obj', '-o', 'b.obj'], { cwd: at() });
    assert.equal(flat.code, 0, flat.stderr);
  });

test('samples have no texcoords and are the same every time', async (t) => {
  const at = tempFolder(t);
  await runAbflat(['sample', 'head', '-o', 'a.obj'], { cwd: at() });
  const { stdout } = await runAbflat(['sample', 'head', '-o', '-']);
  assert.equal(readFileSync(at('a.obj'), 'utf8'), stdout);
  assert.doesNotMatch(stdout, /^vt /m);
});

test('--detail multiplies the faces', async () => {
  const faces = async (detail) => {
    const { stdout } = await runAbflat(['sample', 'head', '-o', '-', '--detail', String(detail)]);
    return stdout.match(/^f /gm).length;
  };
  const growth = (await faces(4)) / (await faces(1));
  assert.ok(growth > 3.2 && growth < 4.8, `${growth}`);
});
