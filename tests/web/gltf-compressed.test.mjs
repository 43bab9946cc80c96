// Compressed glTF files are opened and written uncompressed; decoders are only loaded for them.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { EXTTextureWebP } from '@gltf-transform/extensions';
import {
  codecIo,
  glbOf,
  partsOf,
  quantize,
  withDraco,
  withMeshopt,
} from '../support/compressed-by-exporters.mjs';
import {
  assertSameButTexcoord,
  assertValidFile,
  atlasOf,
  flaws,
  io,
  primitivesOf,
} from '../support/gltf.mjs';
import { character } from '../wasm/support/character.mjs';
import { drop, dropAndWait, exportMesh, openPage, settled, textOf } from './page.mjs';

/** The smallest possible WebP: the page does not care about images. */
const WEBP = Buffer.from('UklGRhoAAABXRUJQVlA4TA0AAAAvAAAAEAcQERGIiP4HAA==', 'base64');

/** Skinned and textured, with morph targets and attributes of many kinds. */
function robot() {
  const document = character();
  document.createExtension(EXTTextureWebP).setRequired(true);
  const texture = document.createTexture('paint').setImage(WEBP).setMimeType('image/webp');
  for (const material of document.getRoot().listMaterials()) material.setBaseColorTexture(texture);
  return document;
}

const FILES = {
  'draco.glb': ['Draco', () => withDraco(robot(), 'sequential')],
  'edgebreaker.glb': [
    'Draco',
    () => {
      const document = robot();
      for (const primitive of primitivesOf(document))
        for (const target of primitive.listTargets()) primitive.removeTarget(target);
      return withDraco(document);
    },
  ],
  'meshopt.glb': ['meshopt', () => withMeshopt(quantize(robot()))],
  'filter.glb': ['meshopt', () => withMeshopt(robot(), 'filter')],
};

const COMPRESSION = /draco|meshopt/;

/** Collects the requests sent from now on. */
function listen(page) {
  const urls = [];
  const onRequest = (request) => urls.push(request.url());
  page.context().on('request', onRequest);
  return { urls, end: () => page.context().off('request', onRequest) };
}

for (const [name, [compression, make]] of Object.entries(FILES))
  test(`${name} gets an atlas, and is written uncompressed`, async (t) => {
    const page = await openPage(t, { settles: false });
    const file = await make();
    const before = await codecIo.readBinary(file);
    await dropAndWait(page, name, file);
    assert.equal(await textOf(page, '#alert'), '');
    assert.equal(await textOf(page, '#badge'), 'Valid');
    assert.equal(
      await textOf(page, '#notice p'),
      `${name} was compressed with ${compression}. The export is uncompressed.`,
    );
    const { path } = await exportMesh(page);
    assert.match(await textOf(page, '#run-text'), /KB, uncompressed\. New UVs are UV\s2/);
    // Without a decoder.
    const after = await io.readBinary(readFileSync(path));
    assertSameButTexcoord(after, before, 'TEXCOORD_2');
    assert.deepEqual(flaws(atlasOf(primitivesOf(after), { texcoord: 2 })), []);
    const root = after.getRoot();
    for (const extension of root.listExtensionsUsed())
      assert.doesNotMatch(extension.extensionName, COMPRESSION);
    assert.deepEqual(Buffer.from(root.listTextures()[0].getImage()), WEBP);
    assert.deepEqual(
      root.listSkins().map((skin) => skin.listJoints().map((joint) => joint.getName())),
      [['root', 'tip']],
    );
    await assertValidFile(after);
  });

test('the newer name of meshopt, and buffers that are files of their own', async (t) => {
  const page = await openPage(t, { settles: false });
  const file = await withMeshopt(quantize(robot()));
  const before = await codecIo.readBinary(file);
  const { json, bin } = partsOf(file);
  json.buffers[0].uri = 'robot.bin';
  const text = JSON.stringify(json).replaceAll('EXT_meshopt', 'KHR_meshopt');
  await dropAndWait(page, 'robot.gltf', text, { 'robot.bin': bin });
  assert.match(await textOf(page, '#notice'), /^robot\.gltf was compressed with meshopt\./);
  const after = await io.readBinary(readFileSync((await exportMesh(page)).path));
  assertSameButTexcoord(after, before, 'TEXCOORD_2');
});

test('decoders are loaded for compressed files alone, and from where the page is from', async (t) => {
  const page = await openPage(t, { own: true });
  const { origin } = new URL(page.url());
  const workers = page.workers().length;
  const plain = listen(page);
  await dropAndWait(page, 'plain.glb', await io.writeBinary(robot()));
  await exportMesh(page);
  assert.equal(await textOf(page, '#notice'), '');
  assert.ok(!plain.urls.some((url) => /draco|meshopt/.test(url)));
  plain.end();
  const { urls } = listen(page);
  await dropAndWait(page, 'draco.glb', await FILES['draco.glb'][1]());
  assert.ok(urls.some((url) => /\/draco_decoder-.*\.wasm$/.test(url)));
  assert.ok(!urls.some((url) => /meshopt/.test(url)));
  await dropAndWait(page, 'meshopt.glb', await FILES['meshopt.glb'][1]());
  assert.ok(urls.some((url) => /meshopt/.test(url)));
  for (const url of urls) assert.equal(new URL(url).origin, origin, url);
  assert.equal(page.workers().length, workers, 'the decoders are gone');
});

/** A file with some change. */
function changed(file, change) {
  const parts = partsOf(file);
  change(parts, parts.json.bufferViews);
  return glbOf(parts);
}

test('damaged data is told in a sentence, and the page goes on', async (t) => {
  const page = await openPage(t, { settles: false });
  const draco = await FILES['edgebreaker.glb'][1]();
  const meshopt = await FILES['meshopt.glb'][1]();
  const ofDraco = ({ json }) => json.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression;
  const ofMeshopt = (views) =>
    views.find(({ extensions }) => extensions)?.extensions.EXT_meshopt_compression;
  const shorten = (view) => {
    view.byteLength = Math.floor(view.byteLength / 2);
  };
  const damaged = {
    'short.glb': changed(draco, (parts, views) => shorten(views[ofDraco(parts).bufferView])),
    'empty.glb': changed(draco, ({ bin }) => bin.fill(0)),
    'noise.glb': changed(draco, (parts, views) => {
      const { byteOffset, byteLength } = views[ofDraco(parts).bufferView];
      parts.bin.fill(0xa5, byteOffset + 30, byteOffset + byteLength);
    }),
    'missing.glb': changed(draco, (parts) => {
      ofDraco(parts).attributes.POSITION = 99;
    }),
    'nowhere.glb': changed(draco, (parts) => {
      ofDraco(parts).bufferView = 99;
    }),
    'half.glb': changed(meshopt, (_, views) => shorten(ofMeshopt(views))),
    'zero.glb': changed(meshopt, ({ bin }) => bin.fill(0)),
    'huge.glb': changed(meshopt, (_, views) => {
      ofMeshopt(views).count = 2 ** 50;
    }),
    'stride.glb': changed(meshopt, (_, views) => {
      ofMeshopt(views).byteStride = 1_000_000;
    }),
    'mode.glb': changed(meshopt, (_, views) => {
      ofMeshopt(views).mode = 'constructor';
    }),
  };
  for (const [name, content] of Object.entries(damaged)) {
    await dropAndWait(page, name, content);
    const alert = await page.locator('#alert p').first().innerText();
    assert.match(
      alert,
      /^\w+\.glb is damaged: its (Draco|meshopt) data cannot be decoded \(.+\)\. Export or download it again\.$/,
    );
    assert.ok(alert.startsWith(name), alert);
  }
  await dropAndWait(page, 'good.glb', draco);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('what could not be loaded is loaded by trying again', async (t) => {
  const page = await openPage(t, { own: true, expected: /Failed to load resource|ERR_FAILED/ });
  const blocked = /draco_decoder/;
  await page.context().route(blocked, (route) => route.abort());
  await dropAndWait(page, 'draco.glb', await FILES['draco.glb'][1]());
  assert.match(
    await textOf(page, '#alert'),
    /^draco\.glb was not opened: a part of this page .*\./,
  );
  await page.context().unroute(blocked);
  assert.equal(await textOf(page, '#again'), 'Try again');
  await page.click('#again');
  await page.waitForFunction(() => document.querySelector('#source').textContent === 'draco.glb');
  assert.equal(await textOf(page, '#alert'), '');
});

test('decoding that takes long can be cancelled', async (t) => {
  const page = await openPage(t, { own: true });
  const workers = page.workers().length;
  let asked;
  const isAsked = new Promise((resolve) => {
    asked = resolve;
  });
  // Never answered.
  await page.context().route(/draco_decoder.*wasm/, asked);
  await drop(page, 'draco.glb', await FILES['draco.glb'][1]());
  await isAsked;
  assert.equal(page.workers().length, workers + 1);
  await page.click('#cancel');
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
  await dropAndWait(page, 'meshopt.glb', await FILES['meshopt.glb'][1]());
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(page.workers().length, workers);
});
