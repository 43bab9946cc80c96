// examples/web-build: a build step that verifies the models of a project, and unwraps those without
// a layout.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  addMesh,
  assertValidFile,
  emptyDocument,
  io,
  primitiveOf,
  primitivesOf,
} from '../support/gltf.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { ROOT } from './support/paths.mjs';

const SCRIPT = join(ROOT, 'examples/web-build/verify-models.mjs');

function run(...args) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [SCRIPT, ...args], {
    encoding: 'utf8',
  });
  return { status, stdout, stderr };
}

/** `uv`: all vertices at one place, so that no face has an area. */
async function glb(name, surface, uv) {
  const document = emptyDocument();
  const primitive = primitiveOf(document, surface);
  addMesh(document, name, primitive);
  if (uv) {
    const array = new Float32Array(2 * primitive.getAttribute('POSITION').getCount()).fill(0.5);
    const [buffer] = document.getRoot().listBuffers();
    const texcoords = document.createAccessor().setType('VEC2').setArray(array).setBuffer(buffer);
    primitive.setAttribute('TEXCOORD_0', texcoords);
  }
  return io.writeBinary(document);
}

test('what has no layout is unwrapped once; what has one stays as it is', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('ring.glb'), await glb('ring', torus(12, 8)));
  writeFileSync(at('rules.json'), '{ "resolution": 512, "padding": 3, "maxStretch": 1.5 }');
  const first = run(at(), at('rules.json'));
  assert.deepEqual(first, { status: 0, stdout: 'ring.glb: unwrapped, valid\n', stderr: '' });
  const document = await io.read(at('ring.glb'));
  await assertValidFile(document);
  assert.ok(primitivesOf(document).every((each) => each.getAttribute('TEXCOORD_0')));
  const bytes = readFileSync(at('ring.glb'));
  const second = run(at(), at('rules.json'));
  assert.deepEqual(second, { status: 0, stdout: 'ring.glb: valid\n', stderr: '' });
  assert.deepEqual(readFileSync(at('ring.glb')), bytes);
  assert.deepEqual(readdirSync(at()).sort(), ['ring.glb', 'rules.json']);
});

test('what was found is printed, and is the exit code; the other files are verified, too', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('a-broken.glb'), 'no glTF');
  writeFileSync(at('ball.glb'), await glb('ball', sphere(4), true));
  writeFileSync(at('ring.GLB'), await glb('ring', torus(8, 6)));
  const { status, stdout, stderr } = run(at());
  assert.equal(status, 1);
  assert.match(stderr, /^a-broken\.glb: .+\n$/);
  assert.match(
    stdout,
    /^ball\.glb: 1 found\n {2}ball: empty: \d+ faces have no area.*\nring\.GLB: unwrapped, valid\n$/,
  );
});

test('a rule that there is none of is said for each file', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('ball.glb'), await glb('ball', sphere(4), true));
  writeFileSync(at('rules.json'), '{ "pading": 3 }');
  const { status, stderr } = run(at(), at('rules.json'));
  assert.equal(status, 1);
  assert.match(stderr, /^ball\.glb: There is no option "pading"/);
});
