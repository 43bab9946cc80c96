// Several meshes at once: as tabs, or in one atlas.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import axe from 'axe-core';
import { CUBE, grid } from '../support/small-meshes.mjs';
import { loadModule } from './modules.mjs';
import { dropFiles, exportMesh, metrics, openPage, openSample, settled, textOf } from './page.mjs';

const { CONTROLS } = await loadModule('help/keys');
const { joinedObj } = await loadModule('files/joined-obj');

const THREE = { 'one.obj': grid(3), 'two.obj': grid(4), 'three.obj': grid(5) };

const shows = (page, name) =>
  page.waitForFunction(
    (name) => document.querySelector('#source').textContent === name && !document.body.ariaBusy,
    name,
  );

async function openTabs(page, files = THREE) {
  await dropFiles(page, files);
  await shows(page, Object.keys(files)[0]);
  await page.getByRole('button', { name: 'Open as tabs' }).click();
}

const tabs = (page) => page.locator('#mesh-tabs').getByRole('tab');
const names = (page) => page.locator('.mesh-tab-name').allTextContents();
const selected = (page) => page.locator('.mesh-tab[aria-selected="true"]').innerText();
const focused = (page) => page.evaluate(() => document.activeElement.textContent);

test('meshes become tabs, each of which is the mesh of the page when it is chosen', async (t) => {
  const page = await openPage(t);
  await dropFiles(page, THREE);
  await shows(page, 'one.obj');
  assert.match(await textOf(page, '#notice'), /^You chose 3 meshes\. one\.obj is open\./);
  assert.ok(await page.isHidden('#mesh-tabs'));
  await page.getByRole('button', { name: 'Open as tabs' }).click();
  assert.equal(await textOf(page, '#notice'), '');
  assert.deepEqual(await names(page), ['one.obj', 'two.obj', 'three.obj']);
  assert.match(await selected(page), /^one\.obj/);
  await tabs(page).nth(2).click();
  await shows(page, 'three.obj');
  assert.equal((await metrics(page)).Faces, '50');
  assert.match(await selected(page), /^three\.obj/);
  assert.equal(await textOf(page, '#notice'), '');
  // What is opened in the meantime gets a tab, too.
  await openSample(page, 'hemisphere');
  assert.deepEqual(await names(page), ['one.obj', 'two.obj', 'three.obj', 'Hemisphere']);
  assert.match(await selected(page), /^Hemisphere/);
  await tabs(page).nth(1).click();
  await shows(page, 'two.obj');
  assert.equal((await exportMesh(page)).name, 'two-uv.obj');
});

test('tabs work by keyboard, as the sheet of keys says', async (t) => {
  const { controls } = CONTROLS.find(({ title }) => title === 'Meshes in tabs');
  assert.deepEqual(controls.flatMap(({ keys }) => keys).sort(), [
    'ArrowLeft',
    'ArrowRight',
    'Delete',
    'End',
    'Enter',
    'Home',
    'Space',
  ]);
  const page = await openPage(t);
  await openTabs(page);
  assert.equal(await focused(page), 'one.obj×');
  for (const [key, name] of [
    ['ArrowRight', 'two.obj'],
    ['ArrowLeft', 'one.obj'],
    ['ArrowLeft', 'three.obj'],
    ['Home', 'one.obj'],
    ['End', 'three.obj'],
  ]) {
    await page.keyboard.press(key);
    assert.equal(await focused(page), `${name}×`, key);
  }
  assert.match(await selected(page), /^one\.obj/, 'nothing is opened on the way');
  await page.keyboard.press('Enter');
  await shows(page, 'three.obj');
  assert.equal(await focused(page), 'three.obj×');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Space');
  await shows(page, 'two.obj');
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await shows(page, 'three.obj');
  await page.keyboard.press('Home');
  await page.keyboard.press('Delete');
  assert.deepEqual(await names(page), ['two.obj', 'three.obj']);
  assert.equal(await focused(page), 'three.obj×');
  await page.keyboard.press('Delete');
  await shows(page, 'two.obj');
  assert.ok(await page.isHidden('#mesh-tabs'), 'one mesh needs no tabs');
  assert.equal(await page.getAttribute('#mesh-stage', 'role'), null);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'mesh-canvas');
});

test('a mesh that cannot be read leaves the tab that is shown', async (t) => {
  const page = await openPage(t);
  await openTabs(page, { 'one.obj': grid(3), 'bad.obj': 'v 0 0 0\n' });
  await tabs(page).nth(1).click();
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  await settled(page);
  assert.match(await selected(page), /^one\.obj/);
  await page.locator('.mesh-tab-close').nth(1).click();
  assert.ok(await page.isHidden('#mesh-tabs'));
  assert.equal(await textOf(page, '#source'), 'one.obj');
});

test('meshes of other formats share one atlas, and the export has an object for each', async (t) => {
  const page = await openPage(t);
  const off = 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n';
  await dropFiles(page, { 'a cube.obj': CUBE, 'tile.off': off });
  await shows(page, 'a cube.obj');
  await page.getByRole('button', { name: 'One atlas' }).click();
  await shows(page, 'a cube-and-1-more.obj');
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.match(await textOf(page, '#mesh-info'), /^\d+ polygons/, 'quads stay quads');
  const text = readFileSync((await exportMesh(page)).path, 'utf8');
  assert.deepEqual(text.match(/^o .*$/gm), ['o a cube', 'o tile']);
  assert.equal(text.match(/^f \S+ \S+ \S+ \S+$/gm).length, 7);
});

test('one file that cannot be read is named, and the mesh that is open stays', async (t) => {
  const page = await openPage(t);
  await dropFiles(page, { 'one.obj': grid(3), 'bad.obj': 'v 0 0 0\nf 1 2 3\n' });
  await shows(page, 'one.obj');
  await page.getByRole('button', { name: 'One atlas' }).click();
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(await textOf(page, '#alert'), /bad\.obj/);
  assert.equal(await textOf(page, '#source'), 'one.obj');
});

test('meshes that would lie in each other go side by side in an OBJ; others keep their places', () => {
  const box = (x, y) => ({
    name: 'box',
    positions: Float64Array.of(x - 1, y, -1, x + 1, y, -1, x + 1, y + 2, 1, x - 1, y + 2, 1),
    indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
    faces: Uint32Array.of(0, 0),
  });
  const places = (...boxes) =>
    joinedObj(boxes)
      .join('')
      .match(/^v .*$/gm)
      .map((line) => line.split(' ').slice(1).map(Number))
      .filter((_, i) => i % 4 === 0);
  assert.deepEqual(
    places(box(0, 0), box(0.5, 0), box(0, 0.5)).map(([x]) => x.toFixed(6)),
    ['-1.000000', '1.200000', '3.400000'],
    'a gap, but no more than that',
  );
  assert.deepEqual(places(box(0, 0), box(5, 0))[1], [4, 0, -1], 'apart already');
  assert.deepEqual(places(box(0, 0), box(0, 1.5))[1], [-1, 1.5, -1], 'one stands on the other');
});

test('joined faces keep their outlines, and odd ones become triangles', () => {
  const positions = Float64Array.from({ length: 24 }, (_, i) => i / 3);
  const mesh = (indices, faces) => ({
    name: 'x\ny',
    positions,
    indices: Uint32Array.from(indices),
    faces: Uint32Array.from(faces),
  });
  const quad = [0, 1, 2, 0, 2, 3];
  const facesOf = (each) =>
    joinedObj([each])
      .join('')
      .match(/^f .*$/gm);
  assert.deepEqual(facesOf(mesh([...quad, 4, 5, 6], [0, 0, 1])), ['f 1 2 3 4', 'f 5 6 7']);
  assert.deepEqual(facesOf(mesh([0, 1, 2, 4, 5, 6], [0, 0])), ['f 1 2 3', 'f 5 6 7']);
  assert.deepEqual(facesOf(mesh([0, 1, 2, 0, 1, 2], [0, 0])), ['f 1 2 3', 'f 1 2 3']);
  const two = joinedObj([mesh(quad, [0, 0]), { ...mesh(quad, [0, 0]), faces: undefined }]).join('');
  assert.deepEqual(two.match(/^[of] .*$/gm), [
    'o x y',
    'f 1 2 3 4',
    'o x y',
    'f 9 10 11',
    'f 9 11 12',
  ]);
});

for (const [name, options] of [
  ['dark', {}],
  ['light', { colorScheme: 'light' }],
  ['phone', { viewport: { width: 390, height: 844 }, hasTouch: true }],
])
  test(`tabs and their notice are without faults, ${name}`, async (t) => {
    const page = await openPage(t, options);
    const long = Object.fromEntries(
      ['a', 'b', 'c', 'd'].map((each) => [`${each}-${'long-name-'.repeat(5)}.obj`, grid(4)]),
    );
    await dropFiles(page, { ...THREE, ...long });
    await shows(page, 'one.obj');
    await page.evaluate(axe.source);
    const check = async (what) => {
      await page.mouse.move(0, 0);
      if (process.env.PICTURES)
        await page.screenshot({ path: `${process.env.PICTURES}/tabs-${what}-${name}.png` });
      const found = await page.evaluate(async () => (await globalThis.axe.run()).violations);
      assert.deepEqual(
        found.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id} ${target}`)),
        [],
        what,
      );
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(wide <= 0, what);
    };
    await check('notice');
    const press = (part) => (options.hasTouch ? part.tap() : part.click());
    await press(page.getByRole('button', { name: 'Open as tabs' }));
    await press(tabs(page).nth(6));
    await shows(page, Object.keys(long)[3]);
    await check('row');
    await press(page.locator('.mesh-tab-close').nth(6));
    await shows(page, Object.keys(long)[2]);
    assert.equal((await names(page)).length, 6);
  });
