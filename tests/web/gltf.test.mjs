// glTF files are opened, laid out, and written with everything else they contain.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  addMesh,
  assertSameButTexcoord,
  assertValidFile,
  atlasOf,
  emptyDocument,
  flaws,
  io,
  primitiveOf,
  primitivesOf,
  randomRows,
  reread,
} from '../support/gltf.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { dropAndWait, exportMesh, metrics, openPage, settled, textOf } from './page.mjs';

/** The smallest possible PNG. */
const PIXEL = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==',
  'base64',
);

/** A ring and a ball with materials, colours, a texture and an animation, in one buffer or two. */
function scene(buffers = 2) {
  const document = emptyDocument();
  const [ring, ball] = [torus(16, 8), sphere(6)].map((surface, i) => {
    const primitive = primitiveOf(document, surface);
    const count = primitive.getAttribute('POSITION').getCount();
    return primitive
      .setAttribute(
        'COLOR_0',
        randomRows(document, 'VEC4', Uint8Array, count, { normalized: true }),
      )
      .setMaterial(document.createMaterial(`material ${i}`));
  });
  ball
    .getMaterial()
    .setBaseColorTexture(document.createTexture('pixel').setImage(PIXEL).setMimeType('image/png'));
  if (buffers === 2) ball.getAttribute('POSITION').setBuffer(document.createBuffer('second'));
  addMesh(document, 'ring', ring);
  addMesh(document, 'ball', ball).node.setTranslation([0, 0, 4]);
  return document;
}

async function exported(page) {
  const { name, path } = await exportMesh(page);
  return { name, document: await io.readBinary(readFileSync(path)) };
}

async function assertExported(page, before) {
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await textOf(page, '#export'), 'Export GLB');
  const { name, document } = await exported(page);
  assert.equal(name, 'scene-uv.glb');
  assertSameButTexcoord(document, before);
  assert.deepEqual(flaws(atlasOf(primitivesOf(document))), []);
  await assertValidFile(document);
  const root = document.getRoot();
  assert.deepEqual(
    root.listMaterials().map((material) => material.getName()),
    ['material 0', 'material 1'],
  );
  assert.deepEqual(Buffer.from(root.listTextures()[0].getImage()), PIXEL);
  assert.deepEqual(root.listNodes()[1].getTranslation(), [0, 0, 4]);
}

test('primitives of a GLB that have uv keep them', async (t) => {
  const document = scene(1);
  const page = await openPage(t, { open: ['scene.glb', await io.writeBinary(document)] });
  const { document: all } = await exported(page);
  const [ring, ball] = primitivesOf(all);
  const painted = atlasOf([ring]);
  ball.setAttribute('TEXCOORD_0', null);
  await dropAndWait(page, 'painted.glb', await io.writeBinary(all));
  await page.focus('#stretch');
  await page.keyboard.press('Home');
  await settled(page);
  await page.click('#more-toggle');
  await page.click('#more-keep-uv');
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  const { document: after } = await exported(page);
  assert.deepEqual(atlasOf([primitivesOf(after)[0]]), painted);
  assert.deepEqual(flaws(atlasOf(primitivesOf(after))), []);
});

test('a GLB gets an atlas and keeps the rest', async (t) => {
  const page = await openPage(t, { settles: false });
  const document = scene(1);
  await dropAndWait(page, 'scene.glb', await io.writeBinary(document));
  assert.match(await textOf(page, '#mesh-info'), /^688 triangles$/);
  assert.equal((await metrics(page)).Faces, '688');
  await assertExported(page, await reread(document));
});

test('uv that textures use stay as they are unless the user wants them replaced', async (t) => {
  const page = await openPage(t, { settles: false });
  const document = scene(1);
  await dropAndWait(page, 'plain.glb', await io.writeBinary(document));
  for (const [i, primitive] of primitivesOf(document).entries()) {
    const count = primitive.getAttribute('POSITION').getCount();
    primitive.setAttribute(
      'TEXCOORD_0',
      randomRows(document, 'VEC2', Float32Array, count, { seed: i + 1 }),
    );
  }
  await dropAndWait(page, 'painted.glb', await io.writeBinary(document));
  assert.equal(await page.locator('#texcoord option:checked').textContent(), 'UV 1, new');
  const { document: kept } = await exported(page);
  // TEXCOORD_0 too: everything that was there.
  assertSameButTexcoord(kept, await reread(document), 'TEXCOORD_1');
  assert.deepEqual(flaws(atlasOf(primitivesOf(kept), { texcoord: 1 })), []);
  await assertValidFile(kept);
  assert.match(
    await textOf(page, '#run-text'),
    /^Exported painted-uv\.glb, .*\. New UVs are UV\s1; textures keep theirs$/,
  );

  await page.selectOption('#texcoord', '0');
  const { document: replaced } = await exported(page);
  assertSameButTexcoord(replaced, await reread(document));
  assert.deepEqual(flaws(atlasOf(primitivesOf(replaced))), []);
  assert.match(await textOf(page, '#run-text'), /\. New UVs replaced UV\s0, which textures use$/);
  for (const [width, height] of [
    [1440, 900],
    [1280, 720],
    [1024, 768],
    [820, 1180],
    [390, 844],
  ]) {
    await page.setViewportSize({ width, height });
    const isWhole = await page
      .locator('#run-text')
      .evaluate((text) => text.scrollHeight <= text.clientHeight);
    assert.ok(isWhole, `what was exported is read in full at ${width}`);
  }
  // On a phone the choice is beside the export that it is about.
  const [choice, button] = await Promise.all(
    ['#texcoord', '#export'].map((id) => page.locator(id).boundingBox()),
  );
  assert.ok(Math.abs(choice.y - button.y) < 2 && choice.x + choice.width <= button.x);
  // It stays chosen for this file.
  await page.focus('#stretch');
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  assert.equal(await page.inputValue('#texcoord'), '0');

  for (const material of document.getRoot().listMaterials()) material.setBaseColorTexture(null);
  await dropAndWait(page, 'untextured.glb', await io.writeBinary(document));
  const sets = () => page.locator('#texcoord option').allInnerTexts();
  assert.deepEqual((await sets()).slice(0, 2), ['UV 0, replaced', 'UV 1, new']);
  assert.equal(await page.inputValue('#texcoord'), '0', 'no texture needs the old ones');
  assert.deepEqual(flaws(atlasOf(primitivesOf((await exported(page)).document))), []);
  assert.match(await textOf(page, '#run-text'), /^Exported .*\. New UVs replaced UV\s0$/);
});

test('each texcoord set of a glTF can be replaced, and a new one added', async (t) => {
  const page = await openPage(t, { settles: false });
  let document = scene(1);
  for (const material of document.getRoot().listMaterials()) material.setBaseColorTexture(null);
  await dropAndWait(page, 'none.glb', await io.writeBinary(document));
  const sets = Array.from({ length: 8 }, (_, set) => `UV ${set}`);
  const offered = () => page.locator('#texcoord option').allInnerTexts();
  assert.deepEqual(
    await offered(),
    sets.map((name) => `${name}, new`),
  );
  document = (await exported(page)).document;
  assert.doesNotMatch(await textOf(page, '#run-text'), /New UVs/, 'the only ones');
  for (const [set, replaced, said] of [
    [1, 1, 'New UVs are UV\u00a01'],
    [2, 2, 'New UVs are UV\u00a02'],
    [1, 3, 'New UVs replaced UV\u00a01'],
    [
      6,
      3,
      'New UVs are UV\u00a06. UV\u00a03, 4 and 5 are the same, since glTF numbers sets without gaps',
    ],
  ]) {
    await dropAndWait(page, `${replaced}-${set}.glb`, await io.writeBinary(document));
    assert.deepEqual(
      await offered(),
      sets.map((name, i) => `${name}, ${i < replaced ? 'replaced' : 'new'}`),
    );
    await page.selectOption('#texcoord', String(set));
    const { document: written } = await exported(page);
    assertSameButTexcoord(written, document, `TEXCOORD_${set}`);
    assert.deepEqual(flaws(atlasOf(primitivesOf(written), { texcoord: set })), []);
    assert.ok((await textOf(page, '#run-text')).endsWith(said));
    document = written;
  }
  await dropAndWait(page, 'all.glb', await io.writeBinary(document));
  const read = await page.locator('#read-texcoord option').allInnerTexts();
  assert.deepEqual(read, sets.slice(0, 7), 'each that it has can be read');
});

test('UV islands are those of the texcoord set that is chosen, after a reload, too', async (t) => {
  const page = await openPage(t, { settles: false });
  const plain = scene(1);
  for (const material of plain.getRoot().listMaterials()) material.setBaseColorTexture(null);
  await dropAndWait(page, 'none.glb', await io.writeBinary(plain));
  assert.ok(await page.isHidden('#read-texcoord'));
  const charts = async () => Number((await metrics(page)).Islands);
  const counts = [await charts()];
  await dropAndWait(page, 'one.glb', await io.writeBinary((await exported(page)).document));
  assert.ok(await page.isHidden('#read-texcoord'), 'one set leaves no choice');
  await page.click('#seams-sharp');
  await page.fill('#sharp-degrees', '30');
  await settled(page);
  counts.push(await charts());
  assert.notEqual(counts[0], counts[1]);
  await page.selectOption('#texcoord', '1');
  const { document } = await exported(page);
  await page.click('#seams-sharp');

  await dropAndWait(page, 'two.glb', await io.writeBinary(document));
  await page.click('#seams-uv');
  await page.click('#seams-auto');
  await settled(page);
  assert.equal(await charts(), counts[0]);
  await page.selectOption('#read-texcoord', '1');
  await page.waitForFunction(() => document.title.startsWith('two.glb, UV 1'));
  await settled(page);
  assert.equal(await charts(), counts[1]);
  assert.equal(await page.inputValue('#read-texcoord'), '1');
  assert.equal(await page.getAttribute('#seams-uv', 'aria-pressed'), 'true', 'as it was');

  await page.reload();
  await settled(page);
  assert.equal(await page.inputValue('#read-texcoord'), '1');
  assert.equal(await charts(), counts[1]);
});

test('a glTF of several files, dropped together or not', async (t) => {
  const page = await openPage(t, { settles: false });
  const document = scene();
  document.getRoot().listTextures()[0].setURI('a picture.png');
  const { json, resources } = await io.writeJSON(document);
  const text = JSON.stringify(json);
  await dropAndWait(page, 'scene.gltf', text, resources);
  await assertExported(page, document);
  await dropAndWait(page, 'lonely.gltf', text);
  assert.match(await textOf(page, '#alert'), /^lonely\.gltf needs .*drop both files together\./);
  // The previous mesh is still there.
  assert.equal((await exported(page)).name, 'scene-uv.glb');
});

test('a disk is flattened into the unit square of its texture', async (t) => {
  const page = await openPage(t, { mode: 'flatten', settles: false });
  const { positions, faces } = torus(24, 12);
  const document = emptyDocument();
  const patch = faces.filter((face) => face.every((v) => v % 24 < 8 && v < 120));
  const large = positions.map((p) => p.map((x) => 1000 * x));
  // Each triangle has its own vertices, as with flat normals.
  const corners = patch.flat().map((v) => large[v]);
  const apart = { positions: corners, faces: patch.map((_, f) => [3 * f, 3 * f + 1, 3 * f + 2]) };
  addMesh(document, 'patch', primitiveOf(document, apart));
  await dropAndWait(page, 'scene.glb', await io.writeBinary(document));
  assert.match(await textOf(page, '#run-text'), /^Flattened in/);
  const { document: written } = await exported(page);
  assertSameButTexcoord(written, await reread(document));
  assert.deepEqual(flaws(atlasOf(primitivesOf(written))), []);
  await page.click('#mode-unwrap');
  await settled(page);
  assert.deepEqual(flaws(atlasOf(primitivesOf((await exported(page)).document))), []);
});

test('what cannot be read is said in a sentence with its name', async (t) => {
  const page = await openPage(t);
  const { json } = await io.writeJSON(scene());
  const required = { extensionsUsed: ['A_future_one'], extensionsRequired: ['A_future_one'] };
  const lost = JSON.stringify({ ...json, buffers: [], images: [], bufferViews: [] });
  const chunk = Buffer.from(await io.writeBinary(scene(1)));
  chunk.writeUInt32LE(0xffffff, 12);
  for (const [name, content, pattern] of [
    [
      'a.gltf',
      JSON.stringify({ ...json, buffers: [], images: [], ...required }),
      /a\.gltf requires A_future_one, which this page cannot read\. Save it without/,
    ],
    [
      'c.gltf',
      'nonsense',
      /^c\.gltf is not a glTF file, because it is not valid JSON: [^:]*\. Export/,
    ],
    ['d.glb', await io.writeBinary(emptyDocument()), /d\.glb has no triangles/],
    [
      'e.glb',
      (await io.writeBinary(scene(1))).slice(0, 300),
      /e\.glb is truncated: it has only 300 of [\d,]+ b/,
    ],
    ['empty.glb', '', /^empty\.glb is empty\. Export/],
    [
      'words.glb',
      'nonsense',
      /^words\.glb is not a GLB file, because it does not begin with "glTF"\. /,
    ],
    ['f.glb', 'glTF', /f\.glb is truncated: it has only 4 of 12 bytes/],
    ['g.gltf', '{"asset":{"version":"1.0"},"buffers":{}}', /g\.gltf is not glTF 2\.0\. Save it as/],
    ['h.gltf', '[1, 2]', /h\.gltf is not glTF 2\.0\. Save it as/],
    ['i.gltf', 'null', /i\.gltf is not glTF 2\.0\. Save it as/],
    ['j.gltf', lost, /j\.gltf is damaged or too large to read \(.*\)\. Export or download/],
    ['k.glb', chunk, /k\.glb is damaged or too large to read \(.*\)\. Export or download/],
  ]) {
    await dropAndWait(page, name, content);
    const alert = await page.locator('#alert p').first().innerText();
    assert.match(alert, pattern);
    assert.doesNotMatch(alert, /[.?!][.?!]/, 'it ends once');
  }
});
