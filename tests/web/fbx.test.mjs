// An FBX is opened like a glTF, and written as one or as an OBJ.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { unzipSync, zipSync } from 'fflate';
import { assertValidFile, atlasOf, flaws, io, primitivesOf } from '../support/gltf.mjs';
import {
  asBinary,
  asText,
  CUBE_QUADS,
  CUBE_VERTICES,
  fbxParts,
  fbxTree,
} from '../support/made-fbx.mjs';
import { BLUE, oneColor, RED } from '../support/painted.mjs';
import {
  dropAndWait,
  dropFiles,
  exportAs,
  exportMesh,
  openPage,
  reload,
  settled,
  textOf,
} from './page.mjs';

const { properties } = fbxParts;
const cell = (i) => [
  [i / 6, 0],
  [(i + 1) / 6, 0],
  [(i + 1) / 6, 1],
  [i / 6, 1],
];
const BOX = {
  vertices: CUBE_VERTICES,
  faces: CUBE_QUADS,
  uv: [CUBE_QUADS.flatMap((_, i) => cell(i))],
};

/** Two boxes and a camera, one painted by an embedded image, one by a file. */
const tree = () =>
  fbxTree({
    objects: [
      { ...BOX, name: 'Hull', material: 0, scaling: [100, 100, 100] },
      { ...BOX, name: 'Turret', material: 1, translation: [0, 200, 0], scaling: [50, 50, 50] },
    ],
    materials: [
      { name: 'steel', images: [{ file: 'steel.png', content: oneColor(RED) }] },
      { name: 'paint', images: [{ file: 'paint.png' }] },
    ],
    extra: ({ add, connect }) => connect(add('Model', 'Eye', 'Camera', [properties()]), 0),
  });

const limitsOf = (page) =>
  page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('#export-menu [data-value] small')].map((small) => [
        small.parentElement.dataset.value,
        small.textContent,
      ]),
    ),
  );

async function bake(page) {
  await page.click('#export-formats');
  await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).click();
  await page.keyboard.press('Escape');
}

for (const [kind, write] of Object.entries({ text: asText, binary: asBinary }))
  test(`${kind}: objects, materials and images become a GLB`, async (t) => {
    const page = await openPage(t, { settles: false });
    await dropAndWait(page, 'tank.fbx', write(tree()), { 'paint.png': oneColor(BLUE) });
    assert.equal(await textOf(page, '#alert'), '');
    assert.equal(await textOf(page, '#badge'), 'Valid');
    assert.equal(await textOf(page, '#mesh-info'), '24 triangles');
    assert.equal(
      await textOf(page, '#notice p'),
      'tank.fbx is exported as GLB or OBJ, not as FBX. Its polygons become triangles.',
    );
    await page.locator('#shading option[value="materials"]').waitFor({ state: 'attached' });
    await page.waitForFunction(() => document.querySelector('#export-menu small'));
    assert.equal((await limitsOf(page)).glb, 'loses polygons');
    assert.equal((await limitsOf(page)).obj, 'loses polygons, materials and names');
    assert.equal(await textOf(page, '#export'), 'Export GLB');
    const { name, path } = await exportMesh(page);
    assert.equal(name, 'tank-uv.glb');
    const document = await io.readBinary(readFileSync(path));
    await assertValidFile(document);
    const names = document
      .getRoot()
      .listNodes()
      .map((node) => node.getName());
    assert.deepEqual(names, ['tank', 'Hull', 'Turret', 'Eye']);
    // The images keep the UVs that they are for.
    assert.deepEqual(flaws(atlasOf(primitivesOf(document), { texcoord: 1 })), []);
    await bake(page);
    const baked = await io.readBinary(readFileSync((await exportMesh(page)).path));
    assert.equal(await textOf(page, '#alert'), '');
    assert.equal(baked.getRoot().listTextures().length, 1);
    assert.deepEqual(flaws(atlasOf(primitivesOf(baked))), []);
    const obj = await exportAs(page, 'obj');
    assert.deepEqual(Object.keys(unzipSync(obj.bytes)).sort(), [
      'tank-uv-diffuse.png',
      'tank-uv.mtl',
      'tank-uv.obj',
    ]);
  });

test('an archive with an FBX, and its UVs as they are', async (t) => {
  const page = await openPage(t, { settles: false });
  const zip = zipSync({ 'tank/tank.FBX': asBinary(tree()), 'tank/tex/paint.png': oneColor(BLUE) });
  await dropFiles(page, { 'tank.zip': zip });
  await page.waitForFunction(() => document.querySelector('#source').textContent === 'tank.FBX');
  await settled(page);
  await page.evaluate(() => document.querySelector('#mode-pack').click());
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.match(await textOf(page, '#layout-info'), /12 islands/);
});

test('an FBX and an OBJ share an atlas, as a GLB', async (t) => {
  const page = await openPage(t, { settles: false });
  const obj = `${CUBE_VERTICES.map((v) => `v ${v.join(' ')}`).join('\n')}\nf 1 2 4 3\n`;
  await dropFiles(page, { 'tank.fbx': asText(tree()), 'floor.obj': obj });
  await page.getByRole('button', { name: 'One atlas' }).click();
  await page.waitForFunction(() =>
    document.querySelector('#source').textContent.endsWith('-and-1-more.glb'),
  );
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#mesh-info'), '26 triangles');
});

test('an FBX is there again after a reload', async (t) => {
  const page = await openPage(t, { open: ['tank.fbx', asText(tree())] });
  await page.waitForFunction(() => document.querySelector('#notice').textContent !== '');
  assert.match(await textOf(page, '#notice'), /paint\.png not found/);
  await reload(page);
  assert.equal(await textOf(page, '#source'), 'tank.fbx');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('what no FBX can be read from gets a sentence, and the mesh stays', async (t) => {
  const page = await openPage(t, { open: ['tank.fbx', asText(tree())] });
  const old = fbxTree({ objects: [{ ...BOX, name: 'Box' }], version: 6100 });
  const points = fbxTree({ objects: [{ name: 'nothing' }] });
  const outside = asText(tree()).replace('a: 0,2,3,-2', 'a: 0,2,99,-2');
  for (const [name, bytes, expected] of [
    ['a.fbx', 'hello', /^a\.fbx is not an FBX file/],
    ['b.fbx', asBinary(old), /^b\.fbx is FBX 6\.1, which is too old to read/],
    ['c.fbx', asBinary(tree()).subarray(0, 800), /^c\.fbx is damaged, or holds what this page/],
    ['d.fbx', asText(points), /^d\.fbx has no triangles, so there is nothing to unwrap\./],
    ['e.fbx', outside, /^e\.fbx is damaged, or holds/],
  ]) {
    await dropFiles(page, { [name]: bytes });
    await page.waitForFunction(
      (name) => document.querySelector('#alert').textContent.startsWith(name),
      name,
    );
    await settled(page);
    assert.match(await textOf(page, '#alert'), expected);
    assert.equal(await textOf(page, '#source'), 'tank.fbx');
  }
});
