// Textures of a glTF follow the new layout when it is exported.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  addMesh,
  assertValidFile,
  atlasOf,
  emptyDocument,
  io,
  primitiveOf,
  primitivesOf,
} from '../support/gltf.mjs';
import { imageOf } from '../support/made-images.mjs';
import { encodedPng } from '../support/made-png.mjs';
import { paintedCube } from '../support/painted-cube.mjs';
import { parsePng } from '../support/png.mjs';
import { ringAndBall } from '../support/ring-and-ball.mjs';
import { grid } from '../support/small-meshes.mjs';
import { sphere } from '../support/surfaces.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';
import { choose, dropAndWait, exportAs, exportMesh, openPage, settled, textOf } from './page.mjs';
import { rendersFor } from './renders.mjs';

const PAINTED = ringAndBall({ index: 1, scale: 0.8 });
const fileOf = ({ data, width, height }) => encodedPng(width, height, data);
const CUBE = paintedCube();

const switchOf = (page) => page.getByRole('menuitemcheckbox', { name: 'Bake textures' });

/** One of its sides, which is a disk. */
const SIDE = paintedCube(texturedCube().triangles.slice(0, 2));

/** Turns baking on, or off, in the menu of exports. */
async function toggle(page, side) {
  await page.click('#export-formats');
  await switchOf(page).click();
  if (side) await page.getByRole('menuitemradio', { name: side, exact: true }).click();
  await page.keyboard.press('Escape');
}

async function baked(page) {
  const { name, path } = await exportMesh(page);
  assert.equal(await textOf(page, '#alert'), '');
  const bytes = readFileSync(path);
  return { name, bytes, document: await io.readBinary(bytes) };
}

const imagesOf = (document) =>
  document
    .getRoot()
    .listTextures()
    .map((texture) => [texture.getName(), parsePng(Buffer.from(texture.getImage())).width]);

const layoutOf = (document, texcoord = 0) =>
  atlasOf(primitivesOf(document), { texcoord }).map((triangle) =>
    triangle
      .map((corner) => corner.map((x) => x.toFixed(4)).join())
      .sort()
      .join(' '),
  );

function assertLooksAlike({ views, contrast }, t) {
  t.diagnostic(views.map(({ mean }) => `${(100 * mean).toFixed(2)} %`).join(', '));
  assert.equal(views.length, 12);
  for (const { mean, share } of views) {
    assert.ok(mean < 0.01, `${100 * mean} %`);
    assert.ok(share > 0.1, 'little of the picture is compared');
  }
  assert.ok(contrast > 0.05, 'views differ by more than that from each other');
}

test('colours of vertices alone become an image', async (t) => {
  const cube = texturedCube();
  cube.colors = cube.positions.map(([x, y, z]) => [(2 + x) / 4, (3 - y) / 4, 0.5 + 0.2 * z]);
  const page = await openPage(t, {
    open: ['coloured.glb', texturedGlb([cube], { materials: [{}] })],
  });
  await toggle(page, '1,024\u202fpx');
  const { document } = await baked(page);
  assert.deepEqual(imagesOf(document), [['baseColor', 1024]]);
  assert.equal(primitivesOf(document)[0].getAttribute('COLOR_0'), null);
});

test('after Unwrap the exported GLB has new images in the layout on screen, and looks as before', async (t) => {
  const compare = await rendersFor(t);
  const page = await openPage(t, { open: ['painted.glb', PAINTED] });
  const plain = (await baked(page)).document;
  await toggle(page, '1,024\u202fpx');
  assert.equal(await textOf(page, '#export'), 'Export baked GLB');
  assert.ok(await page.locator('#texcoord').isHidden());
  const { name, bytes, document } = await baked(page);
  assert.equal(name, 'painted-uv.glb');
  await assertValidFile(document);
  // Without baking, the layout on screen is in a set beside the old one.
  assert.deepEqual(layoutOf(document), layoutOf(plain, 1));
  assert.deepEqual(
    imagesOf(document),
    ['baseColor', 'metallicRoughness', 'normal', 'emissive'].map((map) => [map, 1024]),
  );
  assert.match(
    await textOf(page, '#run-text'),
    /^Exported painted-uv\.glb, .*KB\. Textures follow the new UVs$/,
  );
  assert.match(
    await textOf(page, '#notice'),
    /^New images: colour 1,024\s*px, .*\. The tangents of 1 primitive were.*\./,
  );
  assertLooksAlike(await compare(PAINTED, bytes), t);
});

test('after a Repack of the UVs of the file, too', async (t) => {
  const compare = await rendersFor(t);
  const glb = ringAndBall();
  const page = await openPage(t, { open: ['painted.glb', glb] });
  await choose(page, 'pack');
  await page.click('#export-formats');
  assert.ok(await switchOf(page).isHidden(), 'the layout is that of the textures');
  await page.keyboard.press('Escape');
  await page.click('#pack-islands');
  await settled(page);
  await toggle(page);
  const { bytes, document } = await baked(page);
  assert.notDeepEqual(layoutOf(document), layoutOf(await io.readBinary(glb)));
  assert.ok(imagesOf(document).length > 0);
  assertLooksAlike(await compare(glb, bytes), t);
});

test('off, or in another format, all is as without the switch; another mesh begins anew', async (t) => {
  const page = await openPage(t, { open: ['cube.glb', CUBE] });
  const before = await exportAs(page, 'glb');
  await toggle(page);
  await page.click('#export-formats');
  assert.match(
    await textOf(page, '#export-menu [data-value="ply"]'),
    /shape and UVs only, no baked textures$/,
    'said before anything is saved',
  );
  await page.keyboard.press('Escape');
  const ply = await exportAs(page, 'ply');
  assert.match(ply.bytes.toString('latin1'), /^ply/);
  assert.equal(await textOf(page, '#export'), 'Export PLY');
  await toggle(page);
  assert.deepEqual((await exportAs(page, 'glb')).bytes, before.bytes);
  await toggle(page, '2,048\u202fpx');
  await dropAndWait(page, 'other.glb', CUBE);
  assert.equal(await textOf(page, '#export'), 'Export GLB');
  await page.click('#export-formats');
  assert.equal(await switchOf(page).getAttribute('aria-checked'), 'false');
});

test('nothing is offered for meshes without textures, or in one piece', async (t) => {
  const plain = emptyDocument();
  addMesh(plain, 'ball', primitiveOf(plain, sphere(5)));
  const page = await openPage(t, { open: ['cube.glb', CUBE] });
  const isOffered = async () => {
    await page.click('#export-formats');
    const isShown = await switchOf(page).isVisible();
    await page.keyboard.press('Escape');
    return isShown;
  };
  assert.ok(await isOffered());
  await dropAndWait(page, 'side.glb', SIDE);
  assert.ok(await isOffered());
  await choose(page, 'flatten');
  assert.ok(!(await isOffered()));
  await choose(page, 'unwrap');
  await dropAndWait(page, 'plain.glb', await io.writeBinary(plain));
  assert.ok(!(await isOffered()));
  await dropAndWait(page, 'waves.obj', grid(6));
  assert.ok(!(await isOffered()));
});

test('the switch and the sizes work by keyboard', async (t) => {
  const page = await openPage(t, { open: ['cube.glb', CUBE] });
  const focused = () => page.evaluate(() => document.activeElement.firstChild.textContent);
  await page.focus('#export-formats');
  for (const key of ['Enter', 'ArrowDown']) await page.keyboard.press(key);
  assert.equal(await focused(), 'Bake textures');
  await page.keyboard.press('Space');
  assert.equal(await switchOf(page).getAttribute('aria-checked'), 'true');
  for (const key of ['ArrowDown', 'ArrowDown', 'Enter']) await page.keyboard.press(key);
  assert.equal(await focused(), '1,024\u202fpx');
  await page.keyboard.press('ArrowUp');
  assert.equal(await focused(), 'Auto');
  await page.keyboard.press('Escape');
  assert.deepEqual(imagesOf((await baked(page)).document), [['baseColor', 1024]]);
});

test('Cancel leaves no file, and the next export works', async (t) => {
  const page = await openPage(t, { open: ['cube.glb', CUBE] });
  await toggle(page, '8,192\u202fpx');
  const files = [];
  page.on('download', (download) => files.push(download.suggestedFilename()));
  await page.click('#export');
  await page.waitForFunction(() =>
    document.querySelector('#progress').classList.contains('active'),
  );
  assert.equal(await textOf(page, '#run-text'), 'Baking textures');
  await page.click('#cancel');
  assert.equal(await textOf(page, '#run-text'), 'Export cancelled');
  assert.ok(await page.locator('#cancel').isDisabled());
  await page.click('#export-formats');
  await page.getByRole('menuitemradio', { name: 'Auto' }).click();
  await page.keyboard.press('Escape');
  const { name } = await baked(page);
  assert.deepEqual(files, [name]);
});

test('an image that cannot be read is named in a sentence, and there is no file', async (t) => {
  const { images, ...rest } = oneTexture(fileOf(imageOf(4, 4, () => [1, 2, 3])));
  const torn = texturedGlb([texturedCube()], { ...rest, images: [images[0].subarray(0, 40)] });
  const page = await openPage(t, { open: ['torn.glb', torn] });
  await toggle(page);
  await page.click('#export');
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(
    await textOf(page, '#alert'),
    /^torn\.glb was not saved: .*image.* cannot be decoded: /i,
  );
  assert.equal(await textOf(page, '#run-text'), 'Not exported');
});
