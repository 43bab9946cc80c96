// Textures of an OBJ follow the new layout when it is exported.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { test } from 'node:test';
import { unzipSync } from 'fflate';
import { atRandomPoints, COLOUR, tiling, waves } from '../support/baking.mjs';
import { assertValidFile, io } from '../support/gltf.mjs';
import { madePng } from '../support/made-png.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { samplerOf, texturedCube } from '../support/textured.mjs';
import { objSampler, texturedObj } from '../support/textured-obj.mjs';
import { exportAs, exportMesh, openPage, settled, textOf } from './page.mjs';

const MTL = `newmtl wood
Kd 0.5 0.5 0.5
map_Kd -s 2 2 1 -o 0.25 0.5 0 wood.png
map_Ks -s 2 2 1 -o 0.25 0.5 0 wood.png
map_Pr -imfchan g rough.png
refl sky.png
newmtl leaf
d 1
map_Kd leaf.png
map_d leaf.png
norm -bm 0.5 tilted.png
newmtl unused
map_Kd lost.png
`;

const FILES = {
  'in.obj': texturedObj(
    'in.mtl',
    ['wood', 'leaf'].map((material, i) => {
      const cube = texturedCube();
      const positions = cube.positions.map(([x, y, z]) => [x + 5 * i, y, z]);
      return { ...cube, positions, material };
    }),
  ),
  'in.mtl': MTL,
  'wood.png': tiling(128),
  'rough.png': waves(192, 128, 1),
  'leaf.png': madePng(96, 64, (x, y) => [200, 100, 50, 128 + x + (y % 3)]),
  'tilted.png': madePng(64, 64, () => [178, 128, 245]),
};

async function open(t, files) {
  const page = await openPage(t);
  await page.setInputFiles(
    '#file',
    Object.entries(files).map(([name, content]) => ({
      name,
      mimeType: '',
      buffer: Buffer.from(content),
    })),
  );
  await settled(page);
  return page;
}

async function bakeAt(page, side) {
  await page.click('#export-formats');
  await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).click();
  await page.getByRole('menuitemradio', { name: side, exact: true }).click();
  await page.keyboard.press('Escape');
}

/** Puts files in a folder, by name. */
function stored(t, files) {
  const at = tempFolder(t);
  for (const [name, content] of Object.entries(files)) {
    mkdirSync(dirname(at(name)), { recursive: true });
    writeFileSync(at(name), content);
  }
  return at;
}

function near(is, expected, what) {
  expected.forEach((x, d) => {
    assert.ok(Math.abs(x - is[d]) < 0.03, `${what}: ${is} is not ${expected}`);
  });
}

test('as an OBJ: an archive with its materials and new images, which look as before', async (t) => {
  const page = await open(t, FILES);
  await bakeAt(page, '1,024\u202fpx');
  assert.equal(await textOf(page, '#export'), 'Export baked OBJ (zip)');
  const { name, path } = await exportMesh(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(name, 'in-uv.zip');
  const files = unzipSync(readFileSync(path));
  assert.deepEqual(Object.keys(files).sort(), [
    ...['in-uv-diffuse.png', 'in-uv-normal.png', 'in-uv-roughness.png'],
    ...['in-uv.mtl', 'in-uv.obj'],
  ]);
  const at = stored(t, files);
  assert.equal(
    readFileSync(at('in-uv.mtl'), 'utf8'),
    `newmtl wood
Kd 0.5 0.5 0.5
map_Kd in-uv-diffuse.png
map_Ks in-uv-diffuse.png
map_Pr -imfchan g in-uv-roughness.png
newmtl leaf
d 1
map_Kd in-uv-diffuse.png
map_d in-uv-diffuse.png
norm -bm 0.5 in-uv-normal.png
`,
  );
  const [was, is] = [objSampler(stored(t, FILES)('in.obj')), objSampler(at('in-uv.obj'))];
  assert.equal(is.count, was.count);
  atRandomPoints(is.count, (triangle, weights) => {
    const channels = triangle < 12 ? 3 : 4;
    const of = (each, map, count) => each.sample(map, triangle, weights)?.slice(0, count);
    near(of(is, 'map_Kd', channels), of(was, 'map_Kd', channels), 'map_Kd');
    if (triangle < 12) near(of(is, 'map_Pr', 1), of(was, 'map_Pr', 1), 'map_Pr');
  });
  assert.match(
    await textOf(page, '#notice'),
    /^New images: colour .*Images for refl were left out, because/,
  );
});

test('as a GLB: base colour with opacity, roughness and normals', async (t) => {
  const page = await open(t, FILES);
  await bakeAt(page, '1,024\u202fpx');
  const { name, bytes } = await exportAs(page, 'glb');
  assert.equal(name, 'in-uv.glb');
  await assertValidFile(await io.readBinary(bytes));
  const { sample, json, count } = samplerOf(bytes);
  assert.deepEqual(
    json.materials.map(({ name, alphaMode, pbrMetallicRoughness, normalTexture }) => [
      name,
      alphaMode,
      'metallicRoughnessTexture' in pbrMetallicRoughness,
      normalTexture !== undefined,
    ]),
    [
      ['wood', undefined, true, true],
      ['leaf', 'BLEND', true, true],
    ],
  );
  const was = objSampler(stored(t, FILES)('in.obj'));
  assert.equal(count, was.count);
  atRandomPoints(count, (triangle, weights) => {
    const expected = was.sample('map_Kd', triangle, weights);
    near(sample(COLOUR, triangle, weights), expected.slice(0, triangle < 12 ? 3 : 4), COLOUR);
  });
});

test('without its images nothing is offered', async (t) => {
  const page = await open(t, { 'in.obj': FILES['in.obj'], 'in.mtl': MTL });
  await page.click('#export-formats');
  assert.ok(await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).isHidden());
});
