// Materials, textures and colours of vertices, on the mesh and in the layout.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { KHRMaterialsUnlit } from '@gltf-transform/extensions';
import { io } from '../support/gltf.mjs';
import { madePng } from '../support/made-png.mjs';
import {
  BLUE,
  fourColors,
  GREEN,
  oneColor,
  paintedDocument,
  RED,
  square,
  textured,
  YELLOW,
} from '../support/painted.mjs';
import { CUBE } from '../support/small-meshes.mjs';
import { countTextures, loseContexts, prepareCounting } from './graphics.mjs';
import { dropAndWait, openPage, settled, textOf } from './page.mjs';

const MESH = '#mesh-canvas';
const LAYOUT = '#layout-canvas';
const COLORS = { red: RED, green: GREEN, blue: BLUE, yellow: YELLOW };

/** With materials that light makes no difference to. */
function document(...paints) {
  const document = paintedDocument(...paints);
  const extension = document.createExtension(KHRMaterialsUnlit);
  for (const material of document.getRoot().listMaterials())
    material.setExtension('KHR_materials_unlit', extension.createUnlit());
  return document;
}

/** The shading is chosen once the materials have been read. */
async function withMaterials(page) {
  await page.waitForFunction(() => document.querySelector('#shading').value === 'materials');
  await settled(page);
}

/**
 * What is seen of each of COLORS: its share of the pixels that have one of them, and the middle of
 * its pixels in fractions of the canvas.
 */
async function seen(page, canvas, tolerance = 4) {
  const picture = (await page.locator(canvas).screenshot()).toString('base64');
  return page.evaluate(
    async ({ picture, colors, tolerance }) => {
      const bytes = Uint8Array.from(atob(picture), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes]));
      const { width, height } = image;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      const found = {};
      let all = 0;
      for (let i = 0; i < width * height; i++)
        for (const [name, color] of Object.entries(colors)) {
          if (color.some((value, d) => Math.abs(value - data[4 * i + d]) > tolerance)) continue;
          found[name] ??= { share: 0, x: 0, y: 0 };
          found[name].share += 1;
          found[name].x += (i % width) / width;
          found[name].y += Math.floor(i / width) / height;
          all += 1;
        }
      for (const each of Object.values(found)) {
        each.x /= each.share;
        each.y /= each.share;
        each.share /= all;
      }
      return found;
    },
    { picture, colors: COLORS, tolerance },
  );
}

function assertShares(found, shares) {
  assert.deepEqual(Object.keys(found).sort(), Object.keys(shares).sort());
  for (const [name, share] of Object.entries(shares))
    assert.ok(Math.abs(found[name].share - share) < 0.05, `${name}: ${found[name].share}`);
}

const QUARTERS = { red: 0.25, green: 0.25, blue: 0.25, yellow: 0.25 };

/** Seen from the front, as the picture is. */
function assertUpright({ red, green, blue, yellow }) {
  assert.ok(red.x < green.x && blue.x < yellow.x, 'red and blue are on the left');
  assert.ok(red.y < blue.y && green.y < yellow.y, 'red and green are above');
}

/** Turned by any angle, but not mirrored. */
function assertTurned({ red, green, blue }) {
  const [a, b] = [
    [green.x - red.x, green.y - red.y],
    [blue.x - red.x, blue.y - red.y],
  ];
  assert.ok(a[0] * b[1] - a[1] * b[0] > 0, 'from red to green to yellow to blue is clockwise');
}

async function lookFromFront(page) {
  await page.focus(MESH);
  await page.keyboard.press('1');
}

/** Light changes the colours of the mesh by less than `light`. */
async function assertFourColors(page, light = 4) {
  await withMaterials(page);
  await lookFromFront(page);
  const mesh = await seen(page, MESH, light);
  assertShares(mesh, QUARTERS);
  assertUpright(mesh);
  const layout = await seen(page, LAYOUT);
  assertShares(layout, QUARTERS);
  assertTurned(layout);
}

test('the texture of a GLB is on the mesh and in its new place in the layout', async (t) => {
  const page = await openPage(t);
  assert.equal(await page.locator('#shading option[value="materials"]').count(), 0);
  const bytes = await io.writeBinary(document(textured('four', fourColors())));
  await dropAndWait(page, 'square.glb', bytes);
  await assertFourColors(page);
  assert.equal(await textOf(page, '#notice'), '');

  await page.keyboard.press('z');
  assert.equal(await page.inputValue('#shading'), 'plain');
  assert.deepEqual(await seen(page, MESH), {});
  await page.keyboard.press('z');
  assertShares(await seen(page, MESH), QUARTERS);

  // Other settings, the same picture.
  await page.focus('#stretch');
  await page.keyboard.press('ArrowRight');
  await settled(page);
  assertShares(await seen(page, LAYOUT), QUARTERS);
});

test('who prefers islands gets them for the next mesh, too', async (t) => {
  const bytes = await io.writeBinary(document(textured('four', fourColors())));
  const page = await openPage(t, { open: ['square.glb', bytes] });
  await withMaterials(page);
  await page.selectOption('#shading', 'plain');
  await dropAndWait(page, 'other.glb', bytes);
  await page.waitForSelector('#shading option[value="materials"]', { state: 'attached' });
  assert.equal(await page.inputValue('#shading'), 'plain');
  await dropAndWait(page, 'cube.obj', CUBE);
  assert.equal(await page.locator('#shading option[value="materials"]').count(), 0);
});

test('a glTF and its image are dropped together', async (t) => {
  const page = await openPage(t, { settles: false });
  const { json, resources } = await io.writeJSON(document(textured('four', fourColors())));
  await dropAndWait(page, 'square.gltf', JSON.stringify(json), resources);
  await assertFourColors(page);
});

test('materials have textures of their own, of any size, or a colour', async (t) => {
  const page = await openPage(t, { settles: false });
  const bytes = await io.writeBinary(
    document(
      textured('red', oneColor(RED, 5)),
      textured('four', fourColors(64)),
      // Linear.
      (_, material) =>
        material.setBaseColorFactor([...BLUE.map((x) => ((x / 255 + 0.055) / 1.055) ** 2.4), 1]),
    ),
  );
  await dropAndWait(page, 'squares.glb', bytes);
  await withMaterials(page);
  await lookFromFront(page);
  const shares = { red: 5 / 12, green: 1 / 12, blue: 5 / 12, yellow: 1 / 12 };
  const mesh = await seen(page, MESH);
  assertShares(mesh, shares);
  assert.ok(mesh.red.x < mesh.green.x && mesh.green.x < mesh.blue.x);
  assertShares(await seen(page, LAYOUT), shares);
});

test('what is cut out of a picture is not seen', async (t) => {
  const page = await openPage(t, { settles: false });
  const half = madePng(16, 16, (x) => [...(x < 8 ? RED : GREEN), x < 8 ? 255 : 100]);
  const masked = (document, material) => {
    textured('half', half)(document, material);
    material.setAlphaMode('MASK');
  };
  await dropAndWait(page, 'mask.glb', await io.writeBinary(document(masked)));
  await withMaterials(page);
  await lookFromFront(page);
  assertShares(await seen(page, MESH), { red: 1 });
  assertShares(await seen(page, LAYOUT), { red: 1 });
});

/** The square as OBJ with polygons, cut by materials into a lower and an upper half. */
function paintedObj() {
  const { positions, uv, quads } = square();
  const face = (quad) => `f ${quad.map((v) => `${v + 1}/${v + 1}`).join(' ')}`;
  return [
    'mtllib square.mtl',
    ...positions.map((p) => `v ${p.join(' ')}`),
    ...uv.map((each) => `vt ${each.join(' ')}`),
    'usemtl lower',
    ...quads.slice(0, 8).map(face),
    'usemtl upper',
    ...quads.slice(8).map(face),
  ].join('\n');
}

test('an OBJ of polygons has the materials of its MTL, once all files are there', async (t) => {
  const page = await openPage(t, { settles: false });
  const mtl = 'newmtl lower\nKd 0 0 0\nmap_Kd textures\\Four.png\nnewmtl upper\nmap_Kd four.png\n';
  const files = { 'square.mtl': mtl, 'four.png': fourColors() };
  await dropAndWait(page, 'square.obj', paintedObj(), files);
  await assertFourColors(page, 70);

  const blue = 'newmtl lower\nmap_Kd four.png\nnewmtl upper\nKd 0.156863 0.313725 0.901961\n';
  await dropAndWait(page, 'other.obj', paintedObj(), { 'square.mtl': blue });
  await page.waitForFunction(() => document.querySelector('#notice').textContent !== '');
  assert.match(
    await textOf(page, '#notice p'),
    /^Textures not shown: four\.png not found\. .* Drop it together with other\.obj to see it\.$/,
  );
  await dropAndWait(page, 'lonely.obj', paintedObj());
  await page.waitForFunction(() => document.querySelector('#notice').textContent !== '');
  assert.match(await textOf(page, '#notice p'), /^Materials not shown: square\.mtl not found\./);
});

test('an image that no browser decodes is named', async (t) => {
  const page = await openPage(t, { settles: false });
  const bytes = await io.writeBinary(document(textured('torn', Buffer.from('no picture'))));
  await dropAndWait(page, 'torn.glb', bytes);
  await page.waitForFunction(() => document.querySelector('#notice').textContent !== '');
  assert.equal(
    await textOf(page, '#notice p'),
    'This browser cannot decode torn: save it as PNG or JPEG.',
  );
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('colours of the vertices of a PLY are shown', async (t) => {
  const page = await openPage(t, { settles: false });
  const { positions, quads } = square();
  const ply = [
    'ply\nformat ascii 1.0',
    `element vertex ${positions.length}`,
    ...['x', 'y', 'z'].map((name) => `property float ${name}`),
    ...['red', 'green', 'blue'].map((name) => `property uchar ${name}`),
    `element face ${quads.length}\nproperty list uchar int vertex_indices\nend_header`,
    ...positions.map((p) => [...p, ...(p[0] < 0.3 ? RED : BLUE)].join(' ')),
    ...quads.map((quad) => [4, ...quad].join(' ')),
  ].join('\n');
  await dropAndWait(page, 'square.ply', ply);
  await withMaterials(page);
  await lookFromFront(page);
  // The layout has no light.
  const layout = await seen(page, LAYOUT);
  assert.deepEqual(Object.keys(layout).sort(), ['blue', 'red']);
});

test('on a phone, a mesh with a texture leaves all buttons within reach', async (t) => {
  const bytes = await io.writeBinary(document(textured('four', fourColors())));
  const page = await openPage(t, { viewport: { width: 390, height: 844 } });
  await dropAndWait(page, 'square.glb', bytes);
  await assertFourColors(page);
  for (const id of ['#texcoord', '#export', '#help', '#theme', '#shading']) {
    const { x, width } = await page.locator(id).boundingBox();
    assert.ok(x >= 0 && x + width <= 390, id);
  }
});

test('the next mesh frees all textures', async (t) => {
  const page = await openPage(t, {
    prepare: prepareCounting,
    open: ['cube.obj', CUBE],
  });
  const before = await countTextures(page);
  const bytes = await io.writeBinary(document(textured('four', fourColors())));
  for (const name of ['a.glb', 'b.glb']) {
    await dropAndWait(page, name, bytes);
    await withMaterials(page);
    await seen(page, MESH);
    // Corners, materials and images in each view.
    assert.equal(await countTextures(page), before + 6, name);
  }
  await dropAndWait(page, 'cube.obj', CUBE);
  assert.equal(await countTextures(page), before);
});

test('textures come back with a lost context', async (t) => {
  const bytes = await io.writeBinary(document(textured('four', fourColors())));
  const page = await openPage(t, { own: true, expected: /WebGL|Context/ });
  await dropAndWait(page, 'square.glb', bytes);
  await withMaterials(page);
  await loseContexts(page, [MESH, LAYOUT]);
  await assertFourColors(page);
});
