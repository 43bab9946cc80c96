// KTX2 textures of a glTF are shown and baked, and stay as they are where only the layout changes.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { assertValidFile, io, primitivesOf } from '../support/gltf.mjs';
import { KTX2_IMAGES, ktx2Cube, QUARTERS } from '../support/ktx2-images.mjs';
import { oneColor, RED } from '../support/painted.mjs';
import { parsePng } from '../support/png.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';
import { dropAndWait, exportAs, exportMesh, openPage, textOf } from './page.mjs';

const read = (path) => io.readBinary(readFileSync(path));
const extensionsOf = (document) =>
  document
    .getRoot()
    .listExtensionsUsed()
    .map(({ extensionName }) => extensionName);

async function bake(page) {
  await page.click('#export-formats');
  await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).click();
  await page.keyboard.press('Escape');
}

const isNear = (a, b) => a.every((x, d) => Math.abs(x - b[d]) <= 12);

/** The share of an image near each colour. */
function sharesOf({ width, height, at }, colors) {
  const shares = colors.map(() => 0);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      colors.forEach((color, k) => {
        if (isNear(color, at(x, y))) shares[k] += 1 / (width * height);
      });
  return shares;
}

for (const [kind, image] of Object.entries(KTX2_IMAGES)) {
  test(`${kind}: shown, kept in an export, and baked into PNG`, async (t) => {
    const page = await openPage(t, { open: ['cube.glb', await ktx2Cube(image)] });
    assert.equal(await textOf(page, '#alert'), '');
    await page.locator('#shading option[value="materials"]').waitFor({ state: 'attached' });
    assert.equal(await textOf(page, '#notice'), '', 'it can be shown');
    const kept = await read((await exportMesh(page)).path);
    assert.deepEqual(Buffer.from(kept.getRoot().listTextures()[0].getImage()), image);
    assert.ok(extensionsOf(kept).includes('KHR_texture_basisu'));
    await bake(page);
    const baked = await read((await exportMesh(page)).path);
    assert.equal(await textOf(page, '#alert'), '');
    const [texture, ...others] = baked.getRoot().listTextures();
    assert.equal(others.length, 0);
    assert.equal(texture.getMimeType(), 'image/png');
    assert.deepEqual(extensionsOf(baked), [], 'nothing needs a reader of KTX2 any more');
    await assertValidFile(baked);
    assert.equal(primitivesOf(baked).length, 1);
    const shares = sharesOf(parsePng(Buffer.from(texture.getImage())), QUARTERS);
    for (const share of shares) assert.ok(share > 0.05, `${shares}`);
  });
}

test('an OBJ gets new images from KTX2, too', async (t) => {
  const page = await openPage(t, { open: ['cube.glb', await ktx2Cube(KTX2_IMAGES.ETC1S)] });
  await bake(page);
  const { name } = await exportAs(page, 'obj');
  assert.equal(name, 'cube-uv.zip');
});

test('the transcoder is loaded for KTX2 alone', async (t) => {
  const page = await openPage(t, { own: true });
  const urls = [];
  page.context().on('request', (request) => urls.push(request.url()));
  await dropAndWait(page, 'plain.glb', texturedGlb([texturedCube()], oneTexture(oneColor(RED))));
  await bake(page);
  await exportMesh(page);
  assert.ok(!urls.some((url) => /basis/.test(url)), 'not for PNG');
  await dropAndWait(page, 'cube.glb', await ktx2Cube(KTX2_IMAGES.UASTC));
  await page.locator('#shading option[value="materials"]').waitFor({ state: 'attached' });
  assert.ok(urls.some((url) => /\/basis_transcoder-.*\.wasm$/.test(url)));
});

test('damaged KTX2 is named; the layout can be exported all the same', async (t) => {
  const broken = Buffer.from(KTX2_IMAGES.UASTC).fill(0x5a, 12, 60);
  const page = await openPage(t, { open: ['cube.glb', await ktx2Cube(broken)] });
  await page.waitForFunction(() => document.querySelector('#notice').textContent !== '');
  assert.match(
    await textOf(page, '#notice'),
    /^This browser cannot decode image 0: save it as PNG or JPEG\./,
  );
  const kept = await read((await exportMesh(page)).path);
  assert.deepEqual(Buffer.from(kept.getRoot().listTextures()[0].getImage()), broken);
  await bake(page);
  await page.click('#export');
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(await textOf(page, '#alert'), /An image of the document cannot be decoded: it/);
});
