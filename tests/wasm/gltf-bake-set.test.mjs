// Textures of a document follow a layout that it already has, as with `abflat bake`.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { KHRTextureBasisu } from '@gltf-transform/extensions';
import { createAbflat } from 'abflat';
import { bake } from 'abflat/gltf';
import { assertValidFile, io, primitivesOf } from '../support/gltf.mjs';
import { encodedPng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';
import { decodePng, waves } from './support/bake.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** A cube with a second layout, the first one turned by a quarter and shrunk. */
function twoLayouts() {
  const cube = texturedCube();
  const { data, width, height } = waves(192, 128);
  return texturedGlb(
    [{ ...cube, uv1: cube.uv.map(([u, v]) => [0.9 - 0.8 * v, 0.1 + 0.8 * u]) }],
    oneTexture(encodedPng(width, height, data)),
  );
}

const imageOf = (document) => {
  const [texture] = document.getRoot().listTextures();
  return decodePng({ bytes: texture.getImage() });
};

test('the pixels of the program, in the layout of the set', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), twoLayouts());
  const args = ['bake', 'in.glb', '-o', 'out.glb', '--texcoord', '1', '--padding', '3'];
  assert.equal((await runAbflat(args, { cwd: at() })).code, 0);
  const native = await io.readBinary(readFileSync(at('out.glb')));
  const document = await io.readBinary(twoLayouts());
  const before = primitivesOf(document)[0].getAttribute('TEXCOORD_1').getArray().slice();
  let found;
  await document.transform(
    bake(abflat, {
      padding: 3,
      decode: decodePng,
      onBaked: (baked, notes) => {
        found = { maps: baked.map(({ maps }) => maps), notes };
      },
    }),
  );
  assert.deepEqual(found, { maps: [['baseColor']], notes: [] });
  assert.deepEqual(imageOf(document), imageOf(native));
  const [primitive] = primitivesOf(document);
  assert.equal(primitive.getMaterial().getBaseColorTextureInfo().getTexCoord(), 1);
  assert.deepEqual(primitive.getAttribute('TEXCOORD_1').getArray(), before);
  await assertValidFile(document);
});

test('what cannot be done is a sentence, and the document stays as it was', async () => {
  const document = await io.readBinary(twoLayouts());
  const bytes = await io.writeBinary(document);
  for (const [options, expected] of [
    [{ texcoord: 2 }, { code: 'NoTexcoords', message: /No triangle has TEXCOORD_2. Name the set/ }],
    [{ padding: 999 }, { message: /padding must be/ }],
    [{ decode: () => Promise.reject(new Error('torn')) }, { code: 'UnreadableFile' }],
  ])
    await assert.rejects(
      document.transform(bake(abflat, { decode: decodePng, ...options })),
      expected,
    );
  for (const options of [{ texcoord: 'auto' }, { texcoord: -1 }, { set: 1 }, { onBaked: 1 }])
    assert.throws(() => bake(abflat, options), { code: 'InvalidOption' });
  assert.throws(() => bake({}), { message: /createAbflat/ });
  assert.deepEqual(await io.writeBinary(document), bytes);
});

test('images of 16 bits are said to become ones of 8', async () => {
  const document = await io.readBinary(twoLayouts());
  const [texture] = document.getRoot().listTextures();
  const deep = texture.getImage().slice();
  deep[24] = 16; // only the header counts here
  texture.setImage(deep);
  let notes;
  await document.transform(
    bake(abflat, {
      decode: () => waves(192, 128),
      onBaked: (_, found) => {
        notes = found;
      },
    }),
  );
  assert.deepEqual(notes, ['1 image has 16 bits per channel, of which the new ones have 8']);
});

test('KTX2 is for a reader of the caller', async () => {
  const document = await io.readBinary(twoLayouts());
  const [texture] = document.getRoot().listTextures();
  texture.setImage(Buffer.from('\xabKTX 20\xbb\r\n\x1a\n', 'latin1'));
  await assert.rejects(document.transform(bake(abflat)), {
    code: 'UnreadableFile',
    message: /is a KTX2 texture. Convert it to PNG, such as with 'ktx extract', or pass/,
  });
  await assert.rejects(document.transform(bake(abflat, { decode: () => null })), {
    code: 'UnreadableFile',
    message: /is a KTX2 texture/,
  });
  await document.transform(bake(abflat, { decode: () => waves(192, 128) }));
  assert.equal(imageOf(document).width, 256);
});

test('an image that the reader of the caller leaves is read as by default', async () => {
  const document = await io.readBinary(twoLayouts());
  await assert.rejects(document.transform(bake(abflat, { decode: async () => null })), {
    message: /^There is no reader of images here, as in Node/,
  });
});

test('the extension of an image format goes with its last image', async () => {
  const decode = () => waves(192, 128);
  for (const [isLeft, expected] of [
    [false, []],
    [true, ['KHR_texture_basisu']],
  ]) {
    const document = await io.readBinary(twoLayouts());
    const root = document.getRoot();
    document.createExtension(KHRTextureBasisu).setRequired(true);
    root.listTextures()[0].setMimeType('image/ktx2');
    if (isLeft) document.createTexture('of an extension').setMimeType('image/ktx2');
    await document.transform(bake(abflat, { decode }));
    const names = root.listExtensionsUsed().map(({ extensionName }) => extensionName);
    assert.deepEqual(names, expected);
  }
});
