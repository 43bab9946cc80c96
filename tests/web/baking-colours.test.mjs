// Colours of the vertices of a PLY or an OBJ become a texture when it is exported.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { strFromU8, unzipSync } from 'fflate';
import { atRandomPoints, COLOUR } from '../support/baking.mjs';
import { assertValidFile, io } from '../support/gltf.mjs';
import { madePng } from '../support/made-png.mjs';
import { plyBytes } from '../support/ply.mjs';
import { parsePng } from '../support/png.mjs';
import { sphere } from '../support/surfaces.mjs';
import { samplerOf } from '../support/textured.mjs';
import { dropAndWait, exportAs, exportMesh, openPage, textOf } from './page.mjs';

const { positions, faces } = sphere(8);
const COLOURS = positions.map((p) => p.map((x) => Math.round(127 * (1 + x))));
const TRIANGLES = faces.flatMap((face) =>
  face.slice(2).map((_, i) => [face[0], face[i + 1], face[i + 2]]),
);

const PLY = plyBytes({
  format: 'binary_little_endian',
  elements: [
    {
      name: 'vertex',
      properties: [
        ...['x', 'y', 'z'].map((name) => ({ name, type: 'double' })),
        ...['red', 'green', 'blue'].map((name) => ({ name, type: 'uchar' })),
      ],
      rows: positions.map((p, v) => [...p, ...COLOURS[v]]),
    },
    {
      name: 'face',
      properties: [{ name: 'vertex_indices', type: 'int', countType: 'uchar' }],
      rows: faces.map((face) => [face]),
    },
  ],
});

const OBJ = [
  ...positions.map((p, v) => ['v', ...p, ...COLOURS[v].map((x) => x / 255)].join(' ')),
  ...faces.map((face) => ['f', ...face.map((v) => v + 1)].join(' ')),
  '',
].join('\n');

const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

const switchOf = (page) => page.getByRole('menuitemcheckbox', { name: 'Bake textures' });

/**
 * The triangles of the file, in its order, with the colours of their vertices between them, which
 * `times` multiplies.
 */
function assertColoured(bytes, times = [1, 1, 1]) {
  const { sample, json, count } = samplerOf(bytes);
  assert.equal(count, TRIANGLES.length);
  assert.equal('COLOR_0' in json.meshes[0].primitives[0].attributes, false);
  atRandomPoints(count, (triangle, weights) => {
    const is = sample(COLOUR, triangle, weights, true);
    for (const d of [0, 1, 2]) {
      const wanted = TRIANGLES[triangle].reduce(
        (sum, v, k) => sum + weights[k] * times[d] * linear(COLOURS[v][d] / 255),
        0,
      );
      assert.ok(Math.abs(is[d] - wanted) < 0.03, `${is} at ${triangle}: ${wanted}`);
    }
  });
}

for (const [name, content] of [
  ['scan.ply', PLY],
  ['scan.obj', OBJ],
])
  test(`${name} becomes a GLB with an image of its colours`, async (t) => {
    const page = await openPage(t, { open: [name, content] });
    await page.click('#export-formats');
    await switchOf(page).click();
    await page.getByRole('menuitemradio', { name: '1,024\u202fpx', exact: true }).click();
    await page.keyboard.press('Escape');
    assert.equal(await textOf(page, '#export'), 'Export baked GLB');
    const baked = await exportAs(page, 'glb');
    assert.equal(baked.name, 'scan-uv.glb');
    await assertValidFile(await io.readBinary(baked.bytes));
    assertColoured(baked.bytes);
    assert.match(await textOf(page, '#notice'), /^New images: colour 1,024\s*px\./);
    // Another mesh, without colours, has nothing to bake.
    await dropAndWait(page, 'plain.obj', OBJ.replace(/^(v( \S+){3}).*$/gm, '$1'));
    await page.click('#export-formats');
    assert.ok(await switchOf(page).isHidden());
  });

test('colours of an OBJ with an image multiply it in a GLB, and stay in the file as an OBJ', async (t) => {
  const skin = [200, 100, 50];
  const page = await openPage(t, { settles: false });
  await dropAndWait(page, 'scan.obj', `mtllib scan.mtl\nusemtl skin\n${OBJ}`, {
    'scan.mtl': 'newmtl skin\nmap_Kd skin.png\n',
    'skin.png': madePng(32, 32, () => skin),
  });
  await page.click('#export-formats');
  await switchOf(page).click();
  await page.keyboard.press('Escape');
  assert.equal(await textOf(page, '#export'), 'Export baked OBJ (zip)');
  const { name, path } = await exportMesh(page);
  assert.equal(name, 'scan-uv.zip');
  const files = unzipSync(readFileSync(path));
  assert.match(strFromU8(files['scan-uv.obj']), /^v( \S+){6}$/m);
  const image = parsePng(Buffer.from(files['scan-uv-diffuse.png']));
  const seen = new Set();
  for (let y = 0; y < image.height; y += 8)
    for (let x = 0; x < image.width; x += 8) seen.add(image.at(x, y).slice(0, 3).join());
  seen.delete('0,0,0'); // beside the islands
  assert.deepEqual([...seen], [skin.join()]);
  const { bytes } = await exportAs(page, 'glb');
  assertColoured(
    bytes,
    skin.map((x) => linear(x / 255)),
  );
});
