// glTF compressed by Draco and meshopt: read as their own decoders read it, and written
// uncompressed.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  COMPRESSIONS,
  compressed,
  compressionsIn,
  io,
  meshoptViews,
} from '../support/compressed-gltf.mjs';
import { randomNumbers } from '../support/disks.mjs';
import { glbOf, parseGltf } from '../support/glb.mjs';
import { assertSameButTexcoord, atlasOf, flaws, primitivesOf } from '../support/gltf.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { richGltf } from '../support/rich-gltf.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const FILTERS = ['OCTAHEDRAL', 'QUATERNION', 'EXPONENTIAL'];
const NOTE = /^in\.\w+ was compressed with (Draco|meshopt); the output is uncompressed$/;

/** Unwraps a file in a folder and passes the output to the validator and to glTF-Transform. */
async function unwrapped(at, input = 'in.glb', output = 'out.glb') {
  const args = ['unwrap', input, '-o', output, '--report', 'r.json', '--resolution', '512'];
  const run = await runAbflat([...args, '--texcoord', '0'], { cwd: at() });
  assert.equal(run.code, 0, run.stderr);
  assert.deepEqual(await errorsIn(at(output), at), []);
  const bytes = readFileSync(at(output));
  return { run, bytes, document: await io.readBinary(new Uint8Array(bytes)) };
}

async function inspected(at, bytes) {
  writeFileSync(at('in.glb'), bytes);
  return runAbflat(['inspect', 'in.glb'], { cwd: at() });
}

const drawn = (document) => primitivesOf(document).filter((primitive) => primitive.getMode() >= 4);

/**
 * Whether the scene mirrors primitives. Checked by area, because quantizing gives them nodes in
 * another order.
 */
const isBackwards = (primitives) =>
  atlasOf(primitives).reduce(
    (sum, [a, b, c]) => sum + (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]),
    0,
  ) < 0;

/** Skins, animations and images, as numbers and bytes. */
const restOf = (document) => ({
  skins: document
    .getRoot()
    .listSkins()
    .map((skin) => skin.getInverseBindMatrices().getArray()),
  animations: document
    .getRoot()
    .listAnimations()
    .flatMap((animation) => animation.listSamplers())
    .map((sampler) => [sampler.getInput().getArray(), sampler.getOutput().getArray()]),
  images: document
    .getRoot()
    .listTextures()
    .map((texture) => texture.getImage()),
});

for (const how of Object.keys(COMPRESSIONS))
  test(`all attributes come out as the decoder has them: ${how}`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('in.glb'), await compressed(richGltf().glb(), how));
    const before = await io.readBinary(new Uint8Array(readFileSync(at('in.glb'))));
    const { run, bytes, document } = await unwrapped(at);
    assertSameButTexcoord(document, before);
    assert.deepEqual(restOf(document), restOf(before));
    assert.deepEqual(compressionsIn(bytes), []);
    const atlas = atlasOf(drawn(document), { isMirrored: (primitive) => isBackwards([primitive]) });
    assert.deepEqual(flaws(atlas, 512), []);
    const { notes } = JSON.parse(readFileSync(at('r.json')));
    const [note] = notes.filter((each) => NOTE.test(each));
    assert.equal(run.stderr, `abflat: ${note}.\n`);
  });

test('the files have all that the extensions offer', async () => {
  const { json } = parseGltf(await compressed(richGltf().glb(), 'meshopt, filtered'));
  const views = meshoptViews(json);
  const seen = new Set(views.flatMap(({ mode, filter }) => [mode, filter]));
  for (const name of ['ATTRIBUTES', 'TRIANGLES', 'INDICES'].concat(FILTERS))
    assert.ok(seen.has(name), name);
  for (const how of ['Draco, edgebreaker', 'Draco, sequential']) {
    const { meshes } = parseGltf(await compressed(richGltf().glb(), how)).json;
    assert.ok(
      meshes[0].primitives.every(({ extensions, targets }) => extensions && targets),
      how,
    );
  }
});

test('compressed bytes do not stay in the file', async (t) => {
  const at = tempFolder(t);
  const plain = richGltf().glb();
  const sizes = [];
  for (const how of ['Draco, sequential', 'meshopt, without loss']) {
    writeFileSync(at('in.glb'), await compressed(plain, how));
    const { bytes } = await unwrapped(at);
    writeFileSync(at('in.glb'), bytes);
    sizes.push([bytes.length, (await unwrapped(at, 'in.glb', 'again.glb')).bytes.length]);
  }
  writeFileSync(at('in.glb'), plain);
  const { bytes } = await unwrapped(at);
  for (const [once, twice] of sizes) {
    assert.ok(once < 1.2 * bytes.length, `${once} and ${bytes.length}`);
    assert.ok(twice <= 1.02 * once, `${twice} and ${once}`);
  }
});

test('a .gltf finds its compressed buffer, and does without the other one', async (t) => {
  const at = tempFolder(t);
  const document = await io.readBinary(
    new Uint8Array(await compressed(richGltf().glb(), 'meshopt, filtered')),
  );
  for (const texture of document.getRoot().listTextures()) texture.dispose();
  const { json, resources } = await io.writeJSON(document, { basename: 'parts' });
  const fallback = json.buffers.find((buffer) => buffer.extensions);
  fallback.uri = 'not-there.bin';
  writeFileSync(at('in.gltf'), JSON.stringify(json));
  for (const [name, bytes] of Object.entries(resources)) writeFileSync(at(name), bytes);
  const { document: after } = await unwrapped(at, 'in.gltf');
  assertSameButTexcoord(after, document);
});

test('KHR_meshopt_compression is the same by another name', async (t) => {
  const at = tempFolder(t);
  const bytes = await compressed(richGltf().glb(), 'meshopt, filtered');
  const { json, buffer } = parseGltf(bytes);
  const text = JSON.stringify(json).replaceAll('EXT_meshopt_', 'KHR_meshopt_');
  writeFileSync(at('in.glb'), glbOf(text, buffer));
  const { document } = await unwrapped(at);
  assertSameButTexcoord(document, await io.readBinary(new Uint8Array(bytes)));
});

/** Applies a change to the JSON of a file compressed in this way; its bytes stay. */
async function changed(how, change) {
  const { json, buffer } = parseGltf(await compressed(richGltf().glb(), how));
  change(json, buffer);
  return glbOf(json, buffer);
}

const dracoOf = (json, m = 0, p = 0) =>
  json.meshes[m].primitives[p].extensions.KHR_draco_mesh_compression;
const dracoView = (json) => json.bufferViews[dracoOf(json).bufferView];

test('plain accessors beside a Draco mesh are used as they are', async (t) => {
  const at = tempFolder(t);
  const { json, buffer } = parseGltf(richGltf().glb());
  json.meshes[2].primitives.shift();
  const plain = glbOf(json, buffer);
  const view = json.bufferViews.push({ buffer: 0, byteOffset: 0, byteLength: 64 }) - 1;
  const { attributes } = json.meshes[0].primitives[0];
  const ids = Object.fromEntries(Object.keys(attributes).map((name, id) => [name, id]));
  json.meshes[0].primitives[0].extensions = {
    KHR_draco_mesh_compression: { bufferView: view, attributes: ids },
  };
  json.extensionsUsed.push('KHR_draco_mesh_compression');
  writeFileSync(at('in.glb'), glbOf(json, buffer));
  const { bytes, document } = await unwrapped(at);
  assertSameButTexcoord(document, await io.readBinary(new Uint8Array(plain)));
  assert.deepEqual(compressionsIn(bytes), []);
});

test('primitives that share a Draco mesh share what it holds', async (t) => {
  const at = tempFolder(t);
  const before = await compressed(richGltf().glb(), 'Draco, edgebreaker');
  const { json, buffer } = parseGltf(before);
  const [first, second] = json.meshes[0].primitives;
  json.meshes[0].primitives.push({ ...first, material: 1 });
  // Another compressed mesh claims the first one's accessors, and gets its own.
  Object.assign(second, { attributes: first.attributes, indices: first.indices });
  writeFileSync(at('in.glb'), glbOf(json, buffer));
  const { document } = await unwrapped(at);
  const positions = (primitive) => primitive.getAttribute('POSITION').getArray();
  const old = primitivesOf(await io.readBinary(new Uint8Array(before))).map(positions);
  const now = primitivesOf(document).map(positions);
  for (const [i, from] of [0, 1, 0].entries())
    assert.deepEqual(now[i].slice(0, old[from].length), old[from]);
  const indices = json.meshes[0].primitives.map((primitive) => primitive.attributes.POSITION);
  assert.equal(new Set(indices).size, 1);
});

test('a file that only names a compression is plain', async (t) => {
  const at = tempFolder(t);
  const { json, buffer } = parseGltf(richGltf().glb());
  json.extensionsRequired.push('KHR_draco_mesh_compression');
  json.extensionsUsed.push('KHR_draco_mesh_compression');
  writeFileSync(at('in.glb'), glbOf(json, buffer));
  const { run, bytes } = await unwrapped(at);
  assert.equal(run.stderr, '');
  assert.deepEqual(compressionsIn(bytes), []);
});

/**
 * The header of a Draco mesh with 1.4 billion triangles, by method (0: sequential, 1: edgebreaker).
 */
function hugeDraco(method) {
  const version = [2, 2];
  const [mesh, noFlags, traversal] = [[1], [0, 0], method === 1 ? [0, 3] : []];
  const faces = [0x80, 0xce, 0xc8, 0x9b, 5];
  const head = [...version, ...mesh, method, ...noFlags, ...traversal, ...faces];
  return Buffer.concat([Buffer.from('DRACO'), Buffer.from(head), Buffer.alloc(16)]);
}

test('what is wrong with compressed bytes is said in a sentence', async (t) => {
  const at = tempFolder(t);
  const draco = (change) => changed('Draco, edgebreaker', change);
  const meshopt = (change) =>
    changed('meshopt, filtered', (json, buffer) => change(meshoptViews(json), buffer, json));
  const place = 'meshes\\[0\\]\\.primitives\\[0\\]\\.extensions\\.KHR_draco_mesh_compression';
  const view = 'bufferViews\\[\\d+\\]\\.extensions\\.EXT_meshopt_compression';
  const cases = [
    [
      draco((json, buffer) => {
        const { byteOffset = 0 } = dracoView(json);
        buffer.fill(0, byteOffset, byteOffset + 4);
      }),
      `${place} cannot be decoded by Draco \\(it does not start with the Draco header\\)\\. The file is damaged`,
    ],
    [
      draco((json, buffer) => buffer.writeUInt8(0, (dracoView(json).byteOffset ?? 0) + 7)),
      `${place} is a point cloud, not a mesh\\. Save the file without compression`,
    ],
    ...[0, 1].map((method) => [
      draco((json, buffer) => hugeDraco(method).copy(buffer, dracoView(json).byteOffset ?? 0)),
      `${place} decodes to far more than the size of the file allows`,
    ]),
    [
      draco((json) => {
        dracoView(json).byteLength = 100;
      }),
      `${place} cannot be decoded by Draco \\(.+\\)\\. The file is damaged; export it again`,
    ],
    [
      draco((json) => {
        dracoView(json).byteLength = 1e9;
      }),
      'bufferViews\\[\\d+\\] ends at byte \\d+ of buffer 0, which has \\d+',
    ],
    [
      draco((json) => {
        json.meshes[0].primitives[0].mode = 0;
      }),
      `${place} is for triangles, but the mode of its primitive is 0`,
    ],
    [
      draco((json) => {
        dracoOf(json).attributes.NORMAL = 99;
      }),
      `${place}\\.attributes\\.NORMAL cannot be decoded by Draco \\(it has no attribute 99\\)`,
    ],
    [
      draco((json) => {
        json.accessors[json.meshes[0].primitives[0].attributes.NORMAL].type = 'VEC2';
      }),
      `${place}\\.attributes\\.NORMAL cannot be decoded by Draco \\(attribute \\d+ has 3 components, but its accessor has 2\\)`,
    ],
    [
      draco((json) => {
        dracoOf(json).attributes._MISSING = 0;
      }),
      'meshes\\[0\\]\\.primitives\\[0\\]\\.attributes\\._MISSING is missing',
    ],
    [
      draco((json) => {
        dracoOf(json).bufferView = 1e6;
      }),
      `${place}\\.bufferView is 1000000, but there are only \\d+ bufferViews`,
    ],
    [
      meshopt(([first]) => {
        first.count = 2 ** 40;
      }),
      `${view} decodes to far more than the \\d+ bytes of the file allow`,
    ],
    [
      meshopt(([first]) => {
        first.byteLength = 20;
      }),
      `${view} has damaged compressed bytes\\. Export the file again`,
    ],
    [
      meshopt(([first]) => {
        first.byteLength = 1e9;
      }),
      `${view} ends at byte \\d+ of buffer \\d+, which has \\d+`,
    ],
    [
      meshopt(([first]) => {
        first.byteStride = 7;
      }),
      `${view}\\.byteStride does not fit the mode and the filter`,
    ],
    [
      meshopt(([first]) => {
        first.mode = 'MAGIC';
      }),
      `${view}\\.mode must be ATTRIBUTES, TRIANGLES or INDICES`,
    ],
    [
      meshopt((views) => {
        views.find(({ mode }) => mode === 'ATTRIBUTES').filter = 'COLOR';
      }),
      `${view}\\.filter is COLOR, which abflat cannot decode\\. Save the file without compression`,
    ],
    [
      meshopt((views, buffer) => {
        const { byteOffset = 0 } = views.find(({ mode }) => mode === 'ATTRIBUTES');
        buffer.writeUInt8(0xa1, byteOffset);
      }),
      `${view} has (vertices in version 1 of meshopt's format|damaged compressed bytes)`,
    ],
  ];
  for (const [bytes, sentence] of cases) {
    const run = await inspected(at, await bytes);
    assert.equal(run.code, 3, `${sentence}: ${run.stdout}${run.stderr}`);
    assert.match(run.stderr, new RegExp(`^abflat: in\\.glb: ${sentence}`));
    assert.equal(run.stderr.trimEnd().split('\n').length, 1);
  }
});

test('damaged bytes end in a sentence or in a mesh', async (t) => {
  const at = tempFolder(t);
  const random = randomNumbers(20);
  const runs = isInstrumented ? 20 : 60;
  for (const how of ['Draco, edgebreaker', 'Draco, sequential', 'meshopt, filtered']) {
    const whole = await compressed(richGltf().glb(), how);
    const begin = 28 + whole.readUInt32LE(12);
    for (let i = 0; i < runs; ++i) {
      const bytes = Buffer.from(whole);
      const flips = 1 + Math.floor(4 * random());
      for (let f = 0; f < flips; ++f)
        bytes[begin + Math.floor(random() * (bytes.length - begin))] ^=
          1 << Math.floor(8 * random());
      const run = await inspected(at, bytes);
      assert.ok(run.code === 0 || run.code === 3, `${how} ${i}: ${run.code} ${run.stderr}`);
      assert.ok(run.stderr.trimEnd().split('\n').length === 1, run.stderr);
    }
  }
});
