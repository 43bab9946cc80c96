// glTF in and out of the command line program.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { complaints } from '../support/atlas.mjs';
import { elementsOf, GlbMaker, objOf, parseGltf, trianglesOf } from '../support/glb.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { richGltf, richTransform } from '../support/rich-gltf.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { judge, sharedMesh, withoutShared } from '../support/shared.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** Runs unwrap on a file in a folder and reads the output. */
async function unwrapped(at, input, output, ...options) {
  const args = [
    'unwrap',
    input,
    '-o',
    output,
    '--report',
    'r.json',
    '--resolution',
    '512',
    ...(options.includes('--texcoord') ? [] : ['--texcoord', '0']),
    ...options,
  ];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  assert.deepEqual(await errorsIn(at(output), at), []);
  return parseGltf(readFileSync(at(output)));
}

const isDrawn = (primitive) => (primitive.mode ?? 4) >= 4;

/** Compares every attribute except the written one, and every morph target, corner by corner. */
function assertSameCorners(before, after, written = 'TEXCOORD_0') {
  for (const [m, mesh] of before.json.meshes.entries())
    for (const [p, old] of mesh.primitives.entries()) {
      const now = after.json.meshes[m].primitives[p];
      if (!isDrawn(old)) {
        assert.deepEqual(now, old);
        continue;
      }
      const [from, to] = [trianglesOf(before, old).flat(), trianglesOf(after, now).flat()];
      const sets = [old, ...(old.targets ?? [])].map((set, i) => [
        set.attributes ?? set,
        i === 0 ? now.attributes : now.targets[i - 1],
      ]);
      for (const [was, is] of sets)
        for (const name of Object.keys(was).filter((n) => n !== written)) {
          const [a, b] = [before.json.accessors[was[name]], after.json.accessors[is[name]]];
          for (const key of ['componentType', 'type', 'normalized', 'min', 'max', 'name'])
            assert.deepEqual(b[key], a[key], `${name}.${key}`);
          const [x, y] = [elementsOf(before, was[name]), elementsOf(after, is[name])];
          assert.deepEqual(y.slice(0, x.length), x, `${name}: vertices keep their numbers`);
          assert.deepEqual(
            to.map((v) => y[v]),
            from.map((v) => x[v]),
            name,
          );
        }
    }
}

/** Compares everything that new texcoords do not affect. */
function assertSameRest(before, after) {
  const rest = ({ json }) => ({
    ...json,
    accessors: null,
    bufferViews: null,
    buffers: null,
    meshes: json.meshes.map((mesh) => ({
      ...mesh,
      primitives: mesh.primitives.map(({ material, extras }) => ({ material, extras })),
    })),
  });
  assert.deepEqual(rest(after), rest(before));
  for (const { inverseBindMatrices } of before.json.skins ?? [])
    assert.deepEqual(
      elementsOf(after, inverseBindMatrices),
      elementsOf(before, inverseBindMatrices),
    );
  for (const { samplers } of before.json.animations ?? [])
    for (const index of samplers.flatMap(({ input, output }) => [input, output]))
      assert.deepEqual(elementsOf(after, index), elementsOf(before, index));
  for (const [i, { bufferView }] of (before.json.images ?? []).entries()) {
    const bytes = ({ json, buffer }, view) => {
      const { byteOffset = 0, byteLength } = json.bufferViews[view];
      return buffer.subarray(byteOffset, byteOffset + byteLength);
    };
    assert.deepEqual(bytes(after, after.json.images[i].bufferView), bytes(before, bufferView));
  }
}

/**
 * Asserts that charts are inside the square, not flipped and, if there is a judge, do not overlap.
 */
function assertAtlas(t, at, model, options) {
  const text = objOf(model, options);
  assert.deepEqual(complaints(text), []);
  if (withoutShared) return t.diagnostic(`not judged: ${withoutShared}`);
  writeFileSync(at('judged.obj'), text);
  assert.deepEqual(judge(at('judged.obj'), at('judged.obj')).failures, []);
}

for (const uv of [true, false])
  for (const ending of ['glb', 'gltf'])
    test(`everything else survives, ${uv ? 'with' : 'without'} texcoords, .${ending}`, async (t) => {
      const at = tempFolder(t);
      writeFileSync(at('in.glb'), richGltf({ uv }).glb());
      assert.deepEqual(await errorsIn(at('in.glb'), at), []);
      const before = parseGltf(readFileSync(at('in.glb')));
      const after = await unwrapped(at, 'in.glb', `out.${ending}`);
      assertSameCorners(before, after);
      assertSameRest(before, after);
      assertAtlas(t, at, after, { transform: richTransform });
      const { notes, input } = JSON.parse(readFileSync(at('r.json')));
      assert.equal(input.faces, 2 * 24 * 12 + 2 * 6 * 16 + 32);
      assert.equal(notes.filter((n) => n.includes('point or line')).length, 1);
      assert.equal(notes.filter((n) => n.includes('tangents')).length, uv ? 1 : 0);
    });

test('primitives that shared their vertices still do', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), richGltf().glb());
  const { json } = await unwrapped(at, 'in.glb', 'out.glb');
  const [a, b] = json.meshes[0].primitives;
  assert.deepEqual([a.attributes, a.targets], [b.attributes, b.targets]);
});

test('a lightmap set leaves the others alone', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), richGltf().glb());
  const before = parseGltf(readFileSync(at('in.glb')));
  const after = await unwrapped(at, 'in.glb', 'out.glb', '--texcoord', '2');
  assertSameCorners(before, after, 'TEXCOORD_2');
  assertSameRest(before, after);
  assertAtlas(t, at, after, { set: 2, transform: richTransform });
});

test('unwrapping again takes no more room', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), richGltf().glb());
  await unwrapped(at, 'in.glb', '1.glb');
  const once = await unwrapped(at, '1.glb', '2.glb', '--seams', 'uv');
  const twice = await unwrapped(at, '2.glb', '3.glb', '--seams', 'uv');
  assert.deepEqual(twice.json, once.json);
});

test('a .gltf finds its buffer and its images, wherever the result goes', async (t) => {
  const at = tempFolder(t);
  mkdirSync(at('model'));
  mkdirSync(at('new folder'));
  const maker = richGltf();
  maker.json.images = [{ uri: 'skin%20tone.png' }];
  const { text, buffer } = maker.gltf('the%20buffer.bin');
  writeFileSync(at('model/in.gltf'), text);
  writeFileSync(at('model/the buffer.bin'), buffer);
  const { images } = JSON.parse(text);
  for (const output of ['new folder/out.gltf', 'new folder/out.glb']) {
    const run = await runAbflat(['unwrap', 'model/in.gltf', '-o', output, '-q'], { cwd: at() });
    assert.deepEqual([run.code, run.stderr], [0, '']);
    const { json } = parseGltf(readFileSync(at(output)));
    assert.deepEqual(json.images, [{ ...images[0], uri: '../model/skin%20tone.png' }]);
  }
  const missing = await runAbflat(['inspect', 'in.gltf'], { cwd: at('model') });
  assert.equal(missing.code, 0);
  writeFileSync(at('lost.gltf'), text);
  const lost = await runAbflat(['inspect', 'lost.gltf'], { cwd: at() });
  assert.equal(lost.code, 3);
  assert.match(
    lost.stderr,
    /lost\.gltf: buffers\[0\]\.uri: cannot read the buffer\.bin: No such file/,
  );
});

test('split vertices do not keep a disk from being flattened', async (t) => {
  const at = tempFolder(t);
  const maker = new GlbMaker();
  const grid = (i) => [i % 3, Math.floor(i / 3), (i % 2) / 4];
  const faces = [0, 1, 3, 4].flatMap((a) => [a, a + 1, a + 4, a, a + 4, a + 3]);
  const corners = Float32Array.from(faces.flatMap(grid));
  const POSITION = maker.accessor(corners, 'VEC3', { box: true, target: 34962 });
  maker.json.meshes = [{ primitives: [{ attributes: { POSITION } }] }];
  writeFileSync(at('in.glb'), maker.glb());
  for (const output of ['out.glb', 'out.obj', 'out.ply']) {
    const run = await runAbflat(['flatten', 'in.glb', '-o', output, '-q'], { cwd: at() });
    assert.deepEqual([run.code, run.stderr], [0, '']);
  }
  assert.deepEqual(await errorsIn(at('out.glb'), at), []);
  const seen = await runAbflat(['inspect', 'in.glb', '--json'], { cwd: at() });
  assert.equal(JSON.parse(seen.stdout).disk.ok, true);
});

test('a mirrored mesh is not turned over', async (t) => {
  const at = tempFolder(t);
  const maker = new GlbMaker();
  const { positions, faces } = torus(16, 8);
  const POSITION = maker.accessor(Float32Array.from(positions.flat()), 'VEC3', { box: true });
  const indices = maker.accessor(Uint16Array.from(faces.flat()), 'SCALAR');
  Object.assign(maker.json, {
    meshes: [{ primitives: [{ attributes: { POSITION }, indices }] }],
    nodes: [{ mesh: 0, scale: [-1, 1, 1] }],
    scenes: [{ nodes: [0] }],
  });
  writeFileSync(at('in.glb'), maker.glb());
  const run = await runAbflat(['unwrap', 'in.glb', '-o', 'out.glb', '-q'], { cwd: at() });
  assert.deepEqual([run.code, run.stderr], [0, '']);
  // The scene shows the back side of what the indices describe.
  const turned = objOf(parseGltf(readFileSync(at('out.glb')))).replaceAll(
    /^f (\S+) (\S+) (\S+)$/gm,
    'f $1 $3 $2',
  );
  assert.deepEqual(complaints(turned), []);
});

test('other formats become a glTF', { skip: withoutShared }, async (t) => {
  const at = tempFolder(t);
  const names = ['suzanne-quads.obj', 'genus3.off', ...(isInstrumented ? [] : ['spot-uv.obj'])];
  for (const name of names) {
    const args = ['unwrap', sharedMesh(name), '-o', at('out.glb'), '--report', at('r.json')];
    const run = await runAbflat(args);
    assert.deepEqual([run.code, run.stderr], [0, '']);
    assert.deepEqual(await errorsIn(at('out.glb'), at), []);
    const model = parseGltf(readFileSync(at('out.glb')));
    const { input } = JSON.parse(readFileSync(at('r.json')));
    const { primitives } = model.json.meshes[0];
    const triangles = primitives.flatMap((p) => trianglesOf(model, p));
    assert.equal(triangles.length, input.triangles);
    assertAtlas(t, at, model);
  }
});

test('what is wrong with a file is said in a sentence', async (t) => {
  const at = tempFolder(t);
  const changed = (change) => {
    const maker = richGltf();
    change(maker.json);
    return maker.glb();
  };
  const good = richGltf().glb();
  const cases = [
    [good.subarray(0, 8), /truncated: it ends within its 12-byte header/],
    [good.subarray(0, 100), /this GLB is truncated/],
    [changed((j) => (j.asset.version = '1.0')), /glTF version '1\.0' is not supported/],
    [
      changed((j) => (j.meshes[0].primitives[1].indices = 99)),
      /meshes\[0\]\.primitives\[1\]\.indices is 99, but there are only \d+ accessors/,
    ],
    [
      changed(
        (j) => (j.meshes[0].primitives[0].indices = j.meshes[0].primitives[0].attributes._CUSTOM),
      ),
      /meshes\[0\]\.primitives\[0\]\.indices: entry \d+ is vertex \d+, but there are only 288/,
    ],
    [
      changed((j) => (j.accessors[0].count = 1e6)),
      /accessors\[0\] has more elements than bufferViews/,
    ],
    [
      changed((j) => (j.bufferViews[2].byteLength = 1e7)),
      /bufferViews\[2\] ends at byte \d+ of buffer 0, which has/,
    ],
    [changed((j) => (j.nodes[2].children = [1])), /nodes\[1\] is reached twice/],
    [changed((j) => (j.nodes[1].scale = [1, 2])), /nodes\[1\]\.scale is not an array of 3 numbers/],
    [changed((j) => (j.meshes = { a: 1 })), /meshes is not an array/],
  ];
  for (const [bytes, sentence] of cases) {
    writeFileSync(at('a.glb'), bytes);
    const run = await runAbflat(['inspect', 'a.glb'], { cwd: at() });
    assert.equal(run.code, 3, run.stderr);
    assert.match(run.stderr, sentence);
    assert.equal(run.stderr.trimEnd().split('\n').length, 1);
  }
  const maker = new GlbMaker();
  const { positions } = sphere(1);
  positions[3][1] = Number.NaN;
  const POSITION = maker.accessor(Float32Array.from(positions.flat()), 'VEC3');
  maker.json.meshes = [{ primitives: [{ attributes: { POSITION } }] }];
  writeFileSync(at('a.glb'), maker.glb());
  const run = await runAbflat(['inspect', 'a.glb'], { cwd: at() });
  assert.match(
    run.stderr,
    /primitives\[0\]\.attributes\.POSITION: vertex 3 has a coordinate that is not finite/,
  );
});
