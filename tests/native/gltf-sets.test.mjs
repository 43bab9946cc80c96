// Which texcoord set of a glTF is written: textures stay right unless the user says otherwise.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { elementsOf, GlbMaker, parseGltf, trianglesOf } from '../support/glb.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { PNG } from '../support/made-gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** A square with `sets` sets of texcoords and a material. */
function square({ sets, material, extensions }) {
  const maker = new GlbMaker();
  const corners = [0, 1, 1, 1, 1, 0, 0, 0]; // v points down
  const positions = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
  const attributes = {
    POSITION: maker.accessor(Float32Array.from(positions), 'VEC3', { box: true }),
  };
  for (const set of sets) {
    const uv = Float32Array.from(corners, (x) => (x + set) / 16);
    attributes[`TEXCOORD_${set}`] = maker.accessor(uv, 'VEC2');
  }
  const indices = maker.accessor(Uint16Array.from([0, 1, 2, 0, 2, 3]), 'SCALAR');
  const image = maker.view(PNG);
  Object.assign(maker.json, {
    meshes: [
      { primitives: [{ attributes, indices, material: 0, ...(extensions && { extensions }) }] },
    ],
    images: [{ bufferView: image, mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    extensionsUsed: ['KHR_texture_transform', 'KHR_materials_clearcoat', 'KHR_materials_variants'],
    extensions: { KHR_materials_variants: { variants: [{ name: 'painted' }] } },
    materials: [material, { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  });
  return maker;
}

const albedo = (texture) => ({
  pbrMetallicRoughness: { baseColorTexture: { index: 0, ...texture } },
});
const transform = (texCoord) => ({ extensions: { KHR_texture_transform: { texCoord } } });
const coat = { extensions: { KHR_materials_clearcoat: { clearcoatTexture: { index: 0 } } } };
const variants = { KHR_materials_variants: { mappings: [{ material: 1, variants: [0] }] } };

/** What the file contains, and the set that auto chooses. */
const CASES = [
  ['no texture', { sets: [0], material: {} }, 0],
  ['a texture of set 0', { sets: [0], material: albedo() }, 1],
  ['a second set that no texture uses', { sets: [0, 1], material: albedo() }, 2],
  ['a texture of set 1', { sets: [0, 1], material: albedo({ texCoord: 1 }) }, 0],
  [
    'textures of both',
    { sets: [0, 1], material: { ...albedo(), occlusionTexture: { index: 0, texCoord: 1 } } },
    2,
  ],
  [
    'a texture that an extension moves to set 1',
    { sets: [0, 1], material: albedo(transform(1)) },
    0,
  ],
  [
    'a texture that an extension moves to set 0',
    { sets: [0, 1], material: albedo({ texCoord: 1, ...transform(0) }) },
    2,
  ],
  ['a texture of an extension', { sets: [0], material: coat }, 1],
  ['a texture of a variant', { sets: [0], material: {}, extensions: variants }, 1],
];

async function unwrapped(t, maker, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), maker.glb());
  const args = ['unwrap', 'in.glb', '-o', 'out.glb', '--report', 'r.json', ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 0, stderr);
  const { notes } = JSON.parse(readFileSync(at('r.json')));
  return { at, stderr, notes, after: parseGltf(readFileSync(at('out.glb'))) };
}

const cornersOf = (model, set) => {
  const [primitive] = model.json.meshes[0].primitives;
  const uv = elementsOf(model, primitive.attributes[`TEXCOORD_${set}`]);
  return trianglesOf(model, primitive).map((triangle) => triangle.map((v) => uv[v]));
};

for (const [what, file, expected] of CASES)
  test(`auto: ${what} gives set ${expected}`, async (t) => {
    const maker = square(file);
    const before = parseGltf(maker.glb());
    const { at, stderr, notes, after } = await unwrapped(t, maker);
    assert.deepEqual(await errorsIn(at('out.glb'), at), []);
    const sets = Object.keys(after.json.meshes[0].primitives[0].attributes);
    assert.ok(sets.includes(`TEXCOORD_${expected}`));
    for (const set of file.sets)
      if (set !== expected) assert.deepEqual(cornersOf(after, set), cornersOf(before, set));
    assert.equal(notes.length, expected > 0 ? 1 : 0);
    assert.equal(stderr, expected > 0 ? `abflat: in.glb: ${notes[0]}.\n` : '');
    if (expected === 0) return;
    // The remedy that the note names replaces a set that the file has, if possible one without textures.
    assert.ok(notes[0].includes(`so the new texcoords are TEXCOORD_${expected}. `), notes[0]);
    const named = Number(/Use --texcoord (\d)/.exec(notes[0])[1]);
    assert.ok(file.sets.includes(named), notes[0]);
    assert.equal(named, expected > 1 && !notes[0].startsWith('textures use') ? 1 : 0);
    const replaced = await unwrapped(t, maker, '--texcoord', `${named}`);
    assert.deepEqual([replaced.stderr, replaced.notes], ['', []]);
    assert.notDeepEqual(cornersOf(replaced.after, named), cornersOf(before, named));
  });

test('a set that is named is written, and nothing is said', async (t) => {
  const file = { sets: [0, 1], material: albedo() };
  const before = parseGltf(square(file).glb());
  for (const set of [0, 1]) {
    const { stderr, notes, after } = await unwrapped(t, square(file), '--texcoord', `${set}`);
    assert.deepEqual([stderr, notes], ['', []]);
    assert.notDeepEqual(cornersOf(after, set), cornersOf(before, set));
    assert.deepEqual(cornersOf(after, 1 - set), cornersOf(before, 1 - set));
  }
});

test('another set is read: its islands become seams, or stay where they are', async (t) => {
  const file = { sets: [0, 1, 2], material: albedo() };
  const before = parseGltf(square(file).glb());
  for (const set of [0, 1, 2]) {
    const kept = await unwrapped(t, square(file), '--keep', 'uv', '--read-texcoord', `${set}`);
    for (const each of file.sets)
      assert.deepEqual(cornersOf(kept.after, each), cornersOf(before, each), `${set}, ${each}`);
    const moved = await unwrapped(
      t,
      square(file),
      ...['--keep', 'uv', '--read-texcoord', `${set}`, '--texcoord', '3'],
    );
    assert.deepEqual(cornersOf(moved.after, 3), cornersOf(before, set));
  }
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), square(file).glb());
  const args = ['unwrap', 'in.glb', '-o', 'o.glb', '--seams', 'uv', '--read-texcoord', '5'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 2);
  assert.match(stderr, /no texcoords/);
});

test('--quiet keeps the sentence for the report; --keep uv stays in set 0', async (t) => {
  const file = { sets: [0], material: albedo() };
  const quiet = await unwrapped(t, square(file), '-q');
  assert.deepEqual([quiet.stderr, quiet.notes.length], ['', 1]);
  const kept = await unwrapped(t, square(file), '--keep', 'uv');
  assert.deepEqual([kept.stderr, kept.notes], ['', []]);
  assert.deepEqual(cornersOf(kept.after, 0), cornersOf(parseGltf(square(file).glb()), 0));
});

test('what is no set is refused', async () => {
  for (const set of ['-1', '8', '0.5', 'Auto', 'nan', ''])
    assert.equal(
      (await runAbflat(['unwrap', 'a.glb', '-o', 'b.glb', '--texcoord', set])).code,
      2,
      set,
    );
});
