// What is pasted: files, addresses and the text of a mesh.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CUBE, grid } from '../support/small-meshes.mjs';
import { loadModule } from './modules.mjs';
import { openPage, sampleOf, settled, textOf } from './page.mjs';

const { pastedIn } = await loadModule('opening/pasted-text');
const { companionsOf, namedByGltf, namedByMtl, namedByObj } =
  await loadModule('opening/companions');

test('meshes and addresses are known by how they begin, other text is left alone', () => {
  for (const [text, name] of [
    [CUBE, 'pasted.obj'],
    [`# a comment\r\n\r\n${grid(60)}`, 'pasted.obj'],
    ['\n OFF\n3 1 0\n', 'pasted.off'],
    ['STCNOFF\n3 1 0\n', 'pasted.off'],
    ['ply\nformat ascii 1.0\n', 'pasted.ply'],
    ['solid x\n facet normal 0 0 1\n', 'pasted.stl'],
    ['{ "scene": 0, "asset": { "version": "2.0" } }', 'pasted.gltf'],
  ])
    assert.deepEqual(pastedIn(text), { kind: 'mesh', name }, text.slice(0, 20));
  assert.deepEqual(pastedIn(' https://a.example/b.glb\n'), {
    kind: 'address',
    text: 'https://a.example/b.glb',
  });
  for (const text of [
    '',
    'v',
    'very good\nf\n',
    'see https://a.example',
    'OFFER\n',
    'plywood',
    'v 1 2 3 and more\nso on\n',
    '{}',
    'f 1 2 3\n',
  ])
    assert.equal(pastedIn(text), null, text);
});

test('the files that a mesh names are found in its folder, each once', () => {
  const mesh = new URL('https://a.example/m/x.obj');
  const found = companionsOf(mesh, [
    'a.bin',
    './a.bin',
    'in/b.png',
    '../c.png',
    '/d.png',
    'https://b.example/m/e.png',
    'x.obj',
    'http://[',
  ]);
  assert.deepEqual(
    found.map(({ pathname }) => pathname),
    ['/m/a.bin', '/m/in/b.png'],
  );
  assert.throws(
    () =>
      companionsOf(
        mesh,
        Array.from({ length: 300 }, (_, i) => `${i}.png`),
      ),
    /refers to 300 other files/,
  );
  assert.deepEqual(namedByObj('mtllib a.mtl b c.mtl\nv 0 0 0\n mtllib d#1.mtl\n'), [
    'a.mtl',
    'b%20c.mtl',
    'd%231.mtl',
  ]);
  assert.deepEqual(
    namedByMtl(
      'map_Kd red one.png\nmap_Ks -o 1 0.5 0 -clamp on in\\s.png\nbump -bm 2 b.png\nKd 1 1 1',
    ),
    ['red%20one.png', 'in/s.png', 'b.png'],
  );
  assert.deepEqual(
    namedByGltf('{"buffers":[{"uri":"a.bin"},{}],"images":[{"uri":"data:,"},{"uri":"b.png"}]}'),
    ['a.bin', 'b.png'],
  );
  assert.deepEqual(namedByGltf('no json'), []);
});

/** Dispatches what Ctrl+V does, with a text, at an element. */
async function paste(page, text, selector = 'body') {
  await page.evaluate(
    ({ text, selector }) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text/plain', text);
      document
        .querySelector(selector)
        .dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
    },
    { text, selector },
  );
}

const shows = (page, name) =>
  page.waitForFunction(
    (name) => document.querySelector('#source').textContent === name && !document.body.ariaBusy,
    name,
  );

test('the text of a mesh opens, unless it is pasted into a field', async (t) => {
  const page = await openPage(t);
  await paste(page, grid(4), '#padding');
  await paste(page, 'no mesh at all');
  await settled(page);
  assert.equal(await sampleOf(page), 'head');
  await paste(page, grid(4));
  await shows(page, 'pasted.obj');
  assert.equal(await textOf(page, '#mesh-info'), '32 triangles');
  assert.equal(await textOf(page, '#alert'), '');
});

test('by keyboard: Ctrl+V opens what is on the clipboard', async (t) => {
  const page = await openPage(t, { own: true });
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.evaluate((text) => navigator.clipboard.writeText(text), grid(3));
  await page.keyboard.press('Control+V');
  await shows(page, 'pasted.obj');
  assert.equal(await textOf(page, '#mesh-info'), '18 triangles');
});

test('an address that is pasted is asked about, once', async (t) => {
  const page = await openPage(t, {
    prepare: (page) =>
      page.route('https://models.example/**', (route) =>
        route.fulfill({ headers: { 'Access-Control-Allow-Origin': '*' }, body: grid(5) }),
      ),
  });
  await paste(page, 'https://models.example/waves.obj');
  await page.locator('.question').waitFor();
  await paste(page, 'https://models.example/other.obj', '.question');
  assert.equal(await page.locator('.question').count(), 1);
  await page.keyboard.press('Enter');
  await shows(page, 'waves.obj');
});
