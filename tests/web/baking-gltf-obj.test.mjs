// A glTF is exported as an OBJ with textures that follow its new layout.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { unzipSync } from 'fflate';
import { assertSameCubes, CUBE_NAMES, threeCubes } from '../support/baked-cubes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { dropFiles, exportAs, openPage, settled, textOf } from './page.mjs';

async function bakeAt(page, side) {
  await page.click('#export-formats');
  await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).click();
  await page.getByRole('menuitemradio', { name: side, exact: true }).click();
  await page.keyboard.press('Escape');
}

test('a GLB becomes an archive of an OBJ, its materials and new images', async (t) => {
  const before = threeCubes();
  const page = await openPage(t, { open: ['cubes.glb', before] });
  const limit = () => textOf(page, '#export-menu [data-value="obj"]');
  await page.click('#export-formats');
  assert.match(await limit(), /loses materials and names$/);
  await page.keyboard.press('Escape');
  await bakeAt(page, '1,024\u202fpx');
  await page.click('#export-formats');
  assert.match(await limit(), /loses names$/);
  await page.keyboard.press('Escape');
  const { name, bytes } = await exportAs(page, 'obj');
  assert.equal(name, 'cubes-uv.zip');
  const files = unzipSync(bytes);
  assert.deepEqual(Object.keys(files).sort(), [
    ...['diffuse', 'emissive', 'metallic', 'roughness'].map((map) => `cubes-uv-${map}.png`),
    ...['cubes-uv.mtl', 'cubes-uv.obj'],
  ]);
  const at = tempFolder(t);
  for (const [file, content] of Object.entries(files)) writeFileSync(at(file), content);
  assertSameCubes(before, at('cubes-uv.obj'));
  const mtl = readFileSync(at('cubes-uv.mtl'), 'utf8');
  assert.deepEqual(
    mtl.match(/^newmtl .*$/gm),
    CUBE_NAMES.map((each) => `newmtl ${each}`),
  );
  const obj = readFileSync(at('cubes-uv.obj'), 'utf8');
  assert.equal(obj.match(/^vn /gm).length, 72, 'the normals of the file');
  assert.match(await textOf(page, '#notice'), /Occlusion was left out, because materials of an/);
  assert.match(
    await textOf(page, '#run-text'),
    /^Exported cubes-uv\.zip, .*KB\. Textures follow the new UVs$/,
  );
  // It opens as it was saved.
  await dropFiles(page, { 'cubes-uv.zip': bytes });
  await page.waitForFunction(
    () => document.querySelector('#source').textContent === 'cubes-uv.obj',
  );
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.ok(await page.locator('#shading option[value="materials"]').count());
});
