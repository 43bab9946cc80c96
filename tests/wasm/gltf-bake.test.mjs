// Textures of a document follow its new layout, as with the command line program.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { bakeLayout, documentMesh, pack, unwrap } from 'abflat/gltf';
import { assertValidFile, io, primitivesOf, reread } from '../support/gltf.mjs';
import { encodedPng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';
import { decodePng, imageOf, mostDifference, waves } from './support/bake.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const fileOf = ({ data, width, height }) => encodedPng(width, height, data);
const bumps = imageOf(96, 64, (x, y) => [
  128 + Math.round(60 * Math.sin(x / 5)),
  128 + Math.round(60 * Math.cos(y / 7)),
  230,
]);
const leaves = imageOf(64, 64, (x, y) => [40, 4 * y, 30, (x >> 3) % 2 ? 255 : 0]);

/** Cubes beside each other, with a material each. */
const cubes = (count) =>
  Array.from({ length: count }, (_, material) => {
    const cube = texturedCube(material);
    return { ...cube, positions: cube.positions.map(([x, y, z]) => [x + 5 * material, y, z]) };
  });

const STRONG = { KHR_materials_emissive_strength: { emissiveStrength: 4 } };

/** Every map, in materials of several kinds. */
const RICH = texturedGlb(cubes(4), {
  materials: [
    {
      name: 'metal',
      pbrMetallicRoughness: {
        baseColorTexture: { index: 0 },
        baseColorFactor: [0.5, 1, 0.25, 1],
        metallicFactor: 0.8,
        metallicRoughnessTexture: { index: 1 },
      },
      occlusionTexture: { index: 0, strength: 0.5 },
      normalTexture: { index: 2, scale: 0.8 },
      emissiveFactor: [0, 0.5, 0],
      emissiveTexture: { index: 1 },
      extensions: STRONG,
    },
    { name: 'plain', pbrMetallicRoughness: { baseColorFactor: [0.2, 0.4, 0.8, 0.5] } },
    {
      name: 'leaf',
      pbrMetallicRoughness: {
        baseColorTexture: {
          index: 3,
          extensions: { KHR_texture_transform: { offset: [0.2, 0.1], scale: [2, 2] } },
        },
      },
      alphaMode: 'MASK',
      alphaCutoff: 0.3,
      doubleSided: true,
    },
    { name: 'other plain' },
  ],
  textures: [{ source: 0 }, { source: 1 }, { source: 2 }, { source: 3, sampler: 0 }],
  samplers: [{ wrapS: 33648, wrapT: 33071 }],
  images: [waves(192, 128), waves(96, 64, 1), bumps, leaves].map(fileOf),
  extensionsUsed: [...Object.keys(STRONG), 'KHR_texture_transform'],
});

const decode = decodePng;

async function baked(t, glb, command, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), glb);
  const args = [command, 'in.glb', '-o', 'out.glb', '--bake', '--report', 'r.json', ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 0, stderr);
  const { notes } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  return { document: await io.readBinary(readFileSync(at('out.glb'))), notes };
}

const MAPS = ['BaseColor', 'MetallicRoughness', 'Occlusion', 'Normal', 'Emissive'];

/** What a material says, with its images by name. */
function described(material) {
  const maps = MAPS.map((name) => {
    const [texture, info] = [material[`get${name}Texture`](), material[`get${name}TextureInfo`]()];
    return texture && [texture.getName(), info.getTexCoord(), info.getWrapS(), info.getWrapT()];
  });
  return {
    name: material.getName(),
    maps,
    numbers: [
      material.getBaseColorFactor(),
      material.getMetallicFactor(),
      material.getRoughnessFactor(),
      material.getNormalScale(),
      material.getOcclusionStrength(),
      material.getEmissiveFactor(),
      material.getExtension('KHR_materials_emissive_strength')?.getEmissiveStrength(),
    ],
    alpha: [material.getAlphaMode(), material.getAlphaCutoff(), material.getDoubleSided()],
  };
}

/** Everything that the program and the package should agree on. */
function look(document) {
  const root = document.getRoot();
  return {
    materials: primitivesOf(document).map((each) => described(each.getMaterial())),
    count: root.listMaterials().length,
    textures: root.listTextures().map((each) => each.getName()),
    sets: primitivesOf(document).map((each) => each.listSemantics().sort()),
  };
}

function assertSamePixels(document, other) {
  const textures = other.getRoot().listTextures();
  for (const texture of document.getRoot().listTextures()) {
    const same = textures.find((each) => each.getName() === texture.getName());
    const [mine, theirs] = [texture, same].map((each) => decode({ bytes: each.getImage() }));
    assert.equal(mine.width, theirs.width, texture.getName());
    assert.equal(mostDifference(mine.data, theirs.data), 0, texture.getName());
  }
}

for (const [command, transform] of Object.entries({ unwrap, pack }))
  test(`${command}: the materials and the pixels of the program`, async (t) => {
    const native = await baked(t, RICH, command);
    const document = await io.readBinary(RICH);
    let notes;
    let found;
    await document.transform(
      transform(abflat, {
        bake: { decode },
        onAtlas: ({ result, baked }) => {
          notes = result.report.notes;
          found = baked;
        },
      }),
    );
    assert.deepEqual(look(document), look(native.document));
    assertSamePixels(await reread(document), native.document);
    assert.deepEqual(notes, native.notes);
    assert.deepEqual(
      found.map(({ maps }) => maps),
      [['baseColor'], ['metallicRoughness', 'occlusion'], ['normal'], ['emissive']],
    );
    await assertValidFile(document);
  });

test('tangents are those of the old layout: they lead to the same pixels, and are left out', async (t) => {
  const cube = { ...texturedCube(), tangents: Array(24).fill([0.6, 0.8, 0, -1]) };
  const glb = texturedGlb([cube], {
    materials: [{ normalTexture: { index: 0 } }],
    textures: [{ source: 0 }],
    images: [fileOf(bumps)],
  });
  const native = await baked(t, glb, 'unwrap', '--bake-resolution', '256');
  const document = await io.readBinary(glb);
  let notes;
  const onAtlas = ({ result }) => {
    notes = result.report.notes;
  };
  await document.transform(unwrap(abflat, { bake: { decode, bakeResolution: 256 }, onAtlas }));
  assertSamePixels(document, native.document);
  assert.match(notes.join(), /the tangents of 1 primitive were those of the old layout/);
  assert.deepEqual(notes, native.notes);
  assert.deepEqual(look(document), look(native.document));
});

test('colours of vertices become part of the image, as with the program', async (t) => {
  const cube = texturedCube();
  cube.colors = cube.positions.map(([x, y, z]) => [(2 + x) / 4, (3 - y) / 4, 0.5 + 0.2 * z]);
  for (const json of [oneTexture(fileOf(bumps)), { materials: [{}] }]) {
    const glb = texturedGlb([cube], json);
    const native = await baked(t, glb, 'unwrap', '--bake-resolution', '256');
    const document = await io.readBinary(glb);
    await document.transform(unwrap(abflat, { bake: { decode, bakeResolution: 256 } }));
    assertSamePixels(document, native.document);
    assert.deepEqual(look(document), look(native.document));
    for (const primitive of primitivesOf(document))
      assert.equal(primitive.getAttribute('COLOR_0'), null);
  }
});

test('mirrored nodes have the pixels of the program', async (t) => {
  const glb = texturedGlb([texturedCube()], {
    materials: [{ normalTexture: { index: 0 } }],
    textures: [{ source: 0 }],
    images: [fileOf(bumps)],
    nodes: [{ mesh: 0, scale: [-1, 2, 1] }],
  });
  const native = await baked(t, glb, 'unwrap', '--bake-resolution', '256');
  const document = await io.readBinary(glb);
  await document.transform(unwrap(abflat, { bake: { decode, bakeResolution: 256 } }));
  assertSamePixels(document, native.document);
});

test('textures of extensions keep their texcoords', async (t) => {
  const clearcoat = { clearcoatFactor: 1, clearcoatTexture: { index: 0 } };
  const glb = texturedGlb([texturedCube()], {
    ...oneTexture(fileOf(waves(96)), { extensions: { KHR_materials_clearcoat: clearcoat } }),
    extensionsUsed: ['KHR_materials_clearcoat'],
  });
  const native = await baked(t, glb, 'unwrap');
  const document = await io.readBinary(glb);
  const notes = [];
  const onAtlas = ({ result, texcoord }) => notes.push(texcoord, ...result.report.notes);
  await document.transform(unwrap(abflat, { bake: { decode }, onAtlas }));
  assert.match(notes.join(), /^1,.*uses TEXCOORD_0, so the new texcoords are TEXCOORD_1/);
  assert.deepEqual(look(document).sets, look(native.document).sets);
  assert.deepEqual(look(document).materials, look(native.document).materials);
  assert.equal(document.getRoot().listTextures().length, 2);
});

test('each atlas has images of its own', async () => {
  const document = await io.readBinary(RICH);
  const atlases = [];
  const fractions = [];
  await document.transform(
    unwrap(abflat, {
      bake: { decode, bakeResolution: 64 },
      groupBy: 'primitive',
      onAtlas: (atlas) => atlases.push(atlas),
      onProgress: ({ fraction }) => fractions.push(fraction),
    }),
  );
  assert.equal(atlases.length, 4);
  assert.ok(fractions.every((each, i) => i === 0 || each >= fractions[i - 1] - 1e-9));
  assert.ok(Math.abs(fractions.at(-1) - 1) < 1e-9);
  const [metal, plain, leaf] = atlases;
  assert.deepEqual(
    metal.baked.map(({ maps: [name], side }) => [name, side]),
    ['baseColor', 'metallicRoughness', 'normal', 'emissive'].map((name) => [name, 64]),
  );
  assert.deepEqual(plain.baked, []);
  assert.match(plain.result.report.notes.join(), /nothing was baked/);
  assert.deepEqual(leaf.baked.length, 1);
  assert.deepEqual(
    primitivesOf(document).map((each) => each.getMaterial().getName()),
    ['metal', 'plain', 'leaf', 'other plain'],
  );
  await assertValidFile(document);
});

/** A document with a layout of its own making, and what that is. */
async function laidOut(bake) {
  const document = await io.readBinary(RICH);
  let atlas;
  const onAtlas = (made) => {
    atlas = made;
  };
  await document.transform(unwrap(abflat, { resolution: 512, padding: 4, bake, onAtlas }));
  return { document, atlas };
}

test('bakeLayout: a layout that is there leads to the same document', async () => {
  const bake = { decode, bakeResolution: 128 };
  const { document, atlas } = await laidOut(bake);
  const other = await io.readBinary(RICH);
  const fractions = [];
  const onProgress = (fraction) => fractions.push(fraction);
  const options = { ...bake, resolution: 512, padding: 4, onProgress };
  const made = await bakeLayout(abflat, documentMesh(other), atlas.result, options);
  assert.equal(made.texcoord, 0);
  const described = ({ baked }) => baked.map(({ maps, side }) => [maps, side]);
  assert.deepEqual(described(made), described(atlas));
  assert.deepEqual(await io.writeBinary(other), await io.writeBinary(document));
  assert.ok(fractions.every((each, i) => i === 0 || each >= fractions[i - 1] - 1e-9));
  assert.ok(Math.abs(fractions.at(-1) - 1) < 1e-9);
});

test('bakeLayout: what fails is a sentence, and the document stays as it was', async () => {
  const { atlas } = await laidOut({ decode, bakeResolution: 16 });
  const document = await io.readBinary(RICH);
  const before = await io.writeBinary(document);
  const mesh = documentMesh(document);
  const { uv, indices } = atlas.result;
  const torn = { uv, indices: indices.subarray(3) };
  const stopping = new AbortController();
  const stopped = () => {
    stopping.abort();
    return waves(16);
  };
  for (const [layout, options, expected] of [
    [torn, { decode }, { code: 'InvalidMesh', message: /47 triangles, but the document has 48/ }],
    [atlas.result, { decoder: decode }, { message: /no option "decoder"/ }],
    [atlas.result, { decode: 1 }, { message: /^decode must be a function/ }],
    [atlas.result, { decode, texcoord: -1 }, { message: /texcoord must be/ }],
    [atlas.result, { decode, padding: 300 }, { message: /padding must be/ }],
    [atlas.result, { decode: failing }, { code: 'UnreadableFile' }],
    [atlas.result, { decode: stopped, signal: stopping.signal }, { name: 'AbortError' }],
  ])
    await assert.rejects(bakeLayout(abflat, mesh, layout, options), expected);
  await assert.rejects(bakeLayout({}, mesh, atlas.result), { message: /await createAbflat/ });
  assert.deepEqual(await io.writeBinary(document), before);
});

test('new images may have another format', async () => {
  const document = await io.readBinary(RICH);
  const names = [];
  const encode = (image, name) => {
    names.push(name);
    return { bytes: fileOf(image), mimeType: 'image/png' };
  };
  const bake = { decode, encode, bakeResolution: 32 };
  await document.transform(unwrap(abflat, { bake }));
  assert.deepEqual(names, ['baseColor', 'metallicRoughness', 'normal', 'emissive']);
  const webp = { ...bake, encode: () => ({ bytes: new Uint8Array(9), mimeType: 'image/webp' }) };
  await assert.rejects((await io.readBinary(RICH)).transform(unwrap(abflat, { bake: webp })), {
    code: 'InvalidOption',
    message: /createExtension\(EXTTextureWebP\)/,
  });
});

const failing = () => {
  throw new Error('it is torn.');
};

for (const [what, bake, code, message] of [
  ['no reader of images', true, 'InvalidOption', /no reader of images here.*bake: \{ decode \}/],
  [
    'a reader that fails',
    { decode: failing },
    'UnreadableFile',
    /image.*cannot be decoded: it is torn\.$/,
  ],
  [
    'a writer that fails',
    { decode, encode: failing },
    'CannotWrite',
    /baseColor cannot be encoded/,
  ],
  [
    'a writer without result',
    { decode, encode: () => undefined },
    'InvalidOption',
    /\{ bytes, mimeType \}/,
  ],
  ['pixels that are none', { decode: () => ({}) }, 'InvalidOption', /image\.width must be a whole/],
  ['a wrong side', { decode, bakeResolution: 3 }, 'InvalidOption', /bakeResolution/],
])
  test(`${what}: refused in a sentence, and the document stays as it was`, async () => {
    const document = await io.readBinary(RICH);
    const before = await io.writeBinary(document);
    for (const transform of [unwrap, pack])
      await assert.rejects(document.transform(transform(abflat, { bake })), { code, message });
    assert.deepEqual(await io.writeBinary(document), before);
  });

test('options that do not fit are refused at once', () => {
  for (const [options, message] of [
    [{ bake: 'yes' }, /bake must be true, false or an object/],
    [{ bake: { decoder: decode } }, /no option "bake\.decoder"/],
    [{ bake: { decode: 1 } }, /bake\.decode must be a function/],
    [{ bake: true, udim: true }, /one tile/],
  ])
    for (const transform of [unwrap, pack])
      assert.throws(() => transform(abflat, options), { code: 'InvalidOption', message });
  const { bake: _, ...unable } = abflat;
  assert.throws(() => unwrap(unable, { bake: true }), { message: /can bake/ });
});
