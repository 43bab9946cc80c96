// Ways to open a mesh: several files at once, folders, files that are not meshes, and names of any
// length.

import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { CUBE, grid } from '../support/small-meshes.mjs';
import { objText, sphere } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { dropAndWait, dropFiles, metrics, openPage, settled, textOf } from './page.mjs';

/** Drops local paths, including folders, as a file manager does. */
async function dropPaths(page, paths) {
  const client = await page.context().newCDPSession(page);
  const data = { items: [], files: paths, dragOperationsMask: 1 };
  for (const type of ['dragEnter', 'dragOver', 'drop'])
    await client.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
}

const shows = (page, name) =>
  page.waitForFunction(
    (name) => document.querySelector('#source').textContent === name && !document.body.ariaBusy,
    name,
  );

test('a mesh is found among what comes with it, in any order, in a folder, pasted', async (t) => {
  const page = await openPage(t, { settles: false });
  const parts = [
    ['x.mtl', 'newmtl red\n'],
    ['x.png', 'no picture'],
    ['x.obj', `mtllib x.mtl\n${CUBE}`],
  ];
  for (let turn = 0; turn < parts.length; turn++) {
    await dropAndWait(page, 'other.obj', grid(3));
    await dropFiles(page, Object.fromEntries(parts));
    await shows(page, 'x.obj');
    assert.equal(await textOf(page, '#alert'), '');
    assert.equal(await textOf(page, '#notice'), '');
    parts.push(parts.shift());
  }

  const path = tempFolder(t);
  mkdirSync(path('things/deeper'), { recursive: true });
  writeFileSync(path('things/readme.txt'), 'one mesh');
  writeFileSync(path('things/._ball.obj'), 'what a system keeps beside a file');
  writeFileSync(path('things/deeper/ball.obj'), objText(sphere(4)));
  await dropPaths(page, [path('things')]);
  await shows(page, 'ball.obj');
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#notice'), '');

  mkdirSync(path('nothing'));
  await dropPaths(page, [path('nothing')]);
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(await textOf(page, '#alert'), /^The folder is empty\./);
  assert.equal(await textOf(page, '#source'), 'ball.obj');

  await page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.items.add(new File([text], 'pasted.obj'));
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
  }, grid(4));
  await shows(page, 'pasted.obj');
  assert.equal(await textOf(page, '#alert'), '');
});

test('of meshes that are dropped together one is opened, until another one is', async (t) => {
  const page = await openPage(t);
  await dropFiles(page, { 'one.obj': grid(3), 'two.obj': grid(4) });
  await shows(page, 'one.obj');
  await page.getByRole('button', { name: 'Close this notice' }).click();
  assert.ok(await page.isHidden('#notice'));
  await dropFiles(page, { 'one.obj': grid(3), 'two.obj': grid(4) });
  await shows(page, 'one.obj');
  assert.ok(await page.isVisible('#notice'));
  await dropAndWait(page, 'alone.obj', grid(3));
  assert.equal(await textOf(page, '#notice'), '', 'it belongs to what was dropped before');
});

test('what is no mesh, has no faces or is no image leaves the mesh that is open', async (t) => {
  const page = await openPage(t, { open: ['waves.obj', grid(4)] });
  const before = await metrics(page);
  for (const [name, content, reason] of [
    ['cat.png', 'meow', /^cat\.png is damaged or too large to show/],
    ['cat.mtl', 'newmtl cat\n', /^cat\.mtl is not a mesh\./],
    ['empty.obj', '', /^empty\.obj is empty\./],
    ['words.obj', '# a cube\n', /^words\.obj contains no mesh \(no v or f lines\)\.(\n|$)/],
    ['doc.fbx', 'Kaydara FBX Binary', /^doc\.fbx is not an FBX file, because it does not begin /],
    ['doc.blend', 'BLENDER-v301', /^doc\.blend is not supported\. Export it as glTF /],
    ['points.obj', 'v 0 0 0\nv 1 0 0\n', /^points\.obj has 2 vertices but no faces/],
  ]) {
    await dropFiles(page, { [name]: content });
    await page.waitForFunction(
      (name) => document.querySelector('#alert').textContent.startsWith(name),
      name,
    );
    await settled(page);
    assert.match(await textOf(page, '#alert'), reason);
    assert.equal(await textOf(page, '.alert-detail'), 'Still showing waves.obj.');
    assert.equal(await textOf(page, '#source'), 'waves.obj');
    assert.equal(await textOf(page, '#mesh-info'), '32 triangles');
    assert.deepEqual(await metrics(page), before);
    assert.ok(await page.isHidden('#layout-note'), 'the layout is that of the mesh on screen');
    assert.equal(await textOf(page, '#export'), 'Export OBJ');
    assert.ok(await page.isEnabled('#export'));
  }
});

for (const [name, width, height] of [
  ['a small screen', 1280, 720],
  ['a narrow window', 820, 700],
  ['a phone', 390, 844],
]) {
  test(`${name}: a long name is cut short and everything stays in place`, async (t) => {
    const page = await openPage(t, { viewport: { width, height }, hasTouch: width < 1000 });
    const long = `${'a-very-long-name_'.repeat(5)}of-a-mesh.obj`;
    await dropFiles(page, { [long]: CUBE, [`other-${long}`]: CUBE });
    await shows(page, long);
    assert.equal(await page.getAttribute('#source', 'title'), long);
    for (const id of ['open', 'sample', 'export', 'theme', 'cancel', 'notice']) {
      await page.locator(`#${id}`).scrollIntoViewIfNeeded();
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width, `${id}: ${JSON.stringify(box)}`);
    }
    const scrolls = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    assert.ok(scrolls <= 0, 'no horizontal scrolling');
  });
}

test('polygons are counted as the file has them', async (t) => {
  const page = await openPage(t, { open: ['cube.obj', CUBE] });
  assert.equal(await textOf(page, '#mesh-info'), '6 polygons, 12 triangles');
  assert.equal((await metrics(page)).Faces, '6');
});
