// What a mesh may make the program read: only ordinary files in its own folder and below.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { GlbMaker, parseGltf } from '../support/glb.mjs';
import { PNG } from '../support/made-gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { grid } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const SECRET = 'the secret that is nobody’s business';
const OUTSIDE = /is outside the folder of the mesh\. Use --allow-outside to read it/;

/** A square whose positions are in a buffer at `uri`. */
function squareGltf(uri, change) {
  const maker = new GlbMaker();
  const corners = Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
  const POSITION = maker.accessor(corners, 'VEC3', { box: true });
  const indices = maker.accessor(Uint16Array.from([0, 1, 2, 0, 2, 3]), 'SCALAR');
  maker.json.meshes = [{ primitives: [{ attributes: { POSITION }, indices }] }];
  const { text, buffer } = maker.gltf(uri);
  const json = JSON.parse(text);
  change?.(json);
  return { text: JSON.stringify(json), buffer };
}

/** A folder `model` for meshes, and beside it files that they must not read. */
function prepared(t) {
  const at = tempFolder(t);
  mkdirSync(at('model/sub'), { recursive: true });
  mkdirSync(at('model-2'));
  const { buffer } = squareGltf('x');
  for (const name of ['outside.bin', 'model/in.bin', 'model/sub/in.bin', 'model-2/in.bin'])
    writeFileSync(at(name), buffer);
  symlinkSync('../outside.bin', at('model/link.bin'));
  symlinkSync('..', at('model/up'));
  symlinkSync('in.bin', at('model/inside.bin'));
  assert.equal(spawnSync('mkfifo', [at('model/pipe.bin')]).status, 0);
  return at;
}

test('buffers are read in the folder of the mesh and below', async (t) => {
  const at = prepared(t);
  const inspect = (uri, ...options) => {
    writeFileSync(at('model/in.gltf'), squareGltf(uri).text);
    return runAbflat(['inspect', 'model/in.gltf', ...options], { cwd: at() });
  };
  for (const uri of ['in.bin', 'sub/in.bin', './sub/../in.bin', 'inside.bin', at('model/in.bin')]) {
    const run = await inspect(uri);
    assert.equal(run.code, 0, `${uri}: ${run.stderr}`);
  }
  const outside = ['../outside.bin', '%2E%2e/outside.bin', 'sub/../../outside.bin', 'link.bin'];
  outside.push('up/outside.bin', at('outside.bin'), '../model-2/in.bin', '../not-there.bin');
  for (const uri of outside) {
    const run = await inspect(uri);
    assert.equal(run.code, 3, uri);
    assert.match(run.stderr, OUTSIDE);
    const allowed = await inspect(uri, '--allow-outside');
    if (uri !== '../not-there.bin') assert.equal(allowed.code, 0, `${uri}: ${allowed.stderr}`);
    else assert.match(allowed.stderr, /No such file/);
  }
  // The mesh's name may be a link; its folder is the one that contains the link.
  symlinkSync('in.gltf', at('model/link.gltf'));
  const linked = await runAbflat(['inspect', 'link.gltf'], { cwd: at('model') });
  assert.match(linked.stderr, OUTSIDE);
});

test('devices, pipes and folders are refused at once, wherever they are', async (t) => {
  const at = prepared(t);
  symlinkSync('/dev/zero', at('model/zero.bin'));
  const cases = [
    ['pipe.bin', /it is a device or a pipe/],
    ['sub', /it is a folder/],
    ['zero.bin', /it is a device or a pipe/, '--allow-outside'],
    ['/dev/tty', /it is a device or a pipe/, '--allow-outside'],
    ['/dev/zero', OUTSIDE],
    ['/proc/kmsg', OUTSIDE],
    ['/proc/kmsg', /cannot read|has only 0/, '--allow-outside'],
    ['in.bin%00.png', /zero byte/],
  ];
  for (const [uri, sentence, ...options] of cases) {
    writeFileSync(at('model/in.gltf'), squareGltf(uri).text);
    const run = await runAbflat(['inspect', 'model/in.gltf', ...options], { cwd: at() });
    assert.equal(run.code, 3, `${uri}: ${run.stderr}`);
    assert.match(run.stderr, sentence);
  }
});

test('a buffer that nothing refers to is neither read nor copied', async (t) => {
  const at = prepared(t);
  writeFileSync(at('model/note.txt'), SECRET);
  for (const uri of ['note.txt', '../not-there.bin', '/dev/zero']) {
    const { text } = squareGltf('in.bin', (json) =>
      json.buffers.push({ uri, byteLength: SECRET.length }),
    );
    writeFileSync(at('model/in.gltf'), text);
    const args = ['unwrap', 'model/in.gltf', '-o', 'out.glb', '-q'];
    const run = await runAbflat(args, { cwd: at() });
    assert.deepEqual([run.code, run.stderr], [0, '']);
    assert.equal(readFileSync(at('out.glb')).includes(SECRET.slice(0, 10)), false);
  }
});

test('bytes that no view holds are not copied', async (t) => {
  const at = prepared(t);
  const { text, buffer } = squareGltf('padded.bin', (json) => {
    json.buffers[0].byteLength += 1000;
  });
  writeFileSync(at('model/padded.bin'), Buffer.concat([buffer, Buffer.alloc(1000, SECRET)]));
  writeFileSync(at('model/in.gltf'), text);
  const args = ['unwrap', 'model/in.gltf', '-o', 'out.glb', '-q'];
  const run = await runAbflat(args, { cwd: at() });
  assert.equal(run.code, 0, run.stderr);
  assert.equal(readFileSync(at('out.glb')).includes('secret'), false);
});

test('one file is not read any number of times', async (t) => {
  const at = prepared(t);
  const many = squareGltf('in.bin', (json) => {
    for (let i = 1; i < 100; i++) {
      json.buffers.push({ ...json.buffers[0], uri: `${'./'.repeat(i)}in.bin` });
      json.bufferViews.push({ buffer: i, byteLength: 4 });
    }
  });
  writeFileSync(at('model/in.gltf'), many.text);
  const run = await runAbflat(['inspect', 'model/in.gltf'], { cwd: at() });
  assert.equal(run.code, 3);
  assert.match(run.stderr, /buffers\[8\]\.uri: .*the mesh refers to it more than 8 times/);
});

test('material files and images of an OBJ, and the image of a PLY, are held to the same', async (t) => {
  const at = prepared(t);
  mkdirSync(at('maps'));
  writeFileSync(at('maps/secret.png'), PNG);
  writeFileSync(at('secret.mtl'), 'newmtl m\nKd 1 0 0\n');
  writeFileSync(at('model/ok.mtl'), 'newmtl m\nmap_Kd ../maps/secret.png\n');
  const obj = (library) => `mtllib ${library}\nusemtl m\n${grid(3)}`;
  writeFileSync(at('model/in.ply'), plyWithImage('../maps/secret.png'));
  writeFileSync(at('model/lib.obj'), obj('../secret.mtl'));
  writeFileSync(at('model/map.obj'), obj('ok.mtl'));
  for (const name of ['lib.obj', 'map.obj', 'in.ply']) {
    const convert = async (...options) => {
      const args = ['unwrap', `model/${name}`, '-o', 'out.glb', '--report', 'r.json', ...options];
      const run = await runAbflat(args, { cwd: at() });
      assert.deepEqual([run.code, run.stderr], [0, '']);
      const { json } = parseGltf(readFileSync(at('out.glb')));
      return { json, notes: JSON.parse(readFileSync(at('r.json'))).notes.join('\n') };
    };
    const alone = await convert();
    assert.match(alone.notes, OUTSIDE);
    assert.equal(alone.json.images, undefined);
    const allowed = await convert('--allow-outside');
    assert.doesNotMatch(allowed.notes, /cannot read/);
    if (name !== 'lib.obj') assert.equal(allowed.json.images.length, 1, name);
    else
      assert.deepEqual(
        allowed.json.materials[0].pbrMetallicRoughness.baseColorFactor,
        [1, 0, 0, 1],
      );
  }
});

function plyWithImage(name) {
  return `ply\nformat ascii 1.0\ncomment TextureFile ${name}\nelement vertex 3\nproperty float x\nproperty float y
property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n`;
}

test('the mesh itself may come through a pipe, but not from a device', async (t) => {
  const at = prepared(t);
  writeFileSync(at('in.obj'), grid(3));
  for (const script of [
    'cat in.obj | "$0" inspect -',
    'cat in.obj | "$0" inspect /dev/stdin',
    '"$0" inspect - < in.obj',
    'mkfifo mesh; cat in.obj > mesh & "$0" inspect mesh',
  ]) {
    const run = await runAbflat([], { cwd: at(), wrapper: ['sh', '-c', script] });
    assert.equal(run.code, 0, `${script}: ${run.stderr}`);
  }
  for (const [device, sentence] of [
    ['/dev/zero', /cannot read \/dev\/zero: it is a device/],
    ['/dev/null', /\/dev\/null: /],
  ]) {
    const run = await runAbflat(['inspect', device]);
    assert.equal(run.code, 3);
    assert.match(run.stderr, sentence);
  }
  assert.ok(existsSync('/dev/null'));
});
