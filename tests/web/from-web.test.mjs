// Meshes from other servers: asked for by a link or pasted, fetched only after consent. The servers are played by the browser.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import axe from 'axe-core';
import { addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { CUBE, grid } from '../support/small-meshes.mjs';
import { sphere } from '../support/surfaces.mjs';
import { openPage, sampleOf, settled, textOf } from './page.mjs';

const HOST = 'https://models.example';
const OPEN_TO_ALL = { 'Access-Control-Allow-Origin': '*' };

/** Serves `files` by path from another host; what was asked for is in `asked`. */
async function play(page, files, asked) {
  await page.route(`${HOST}/**`, (route) => {
    const { pathname } = new URL(route.request().url());
    asked?.push(pathname);
    const { status = 200, headers = OPEN_TO_ALL, body = '' } = files[pathname] ?? { status: 404 };
    return route.fulfill({ status, headers, body });
  });
}

/** Loads the page by a link to a mesh, with the question open. */
async function follow(page, address) {
  const own = page.url().replace(/\?.*/, '');
  await page.goto(`${own}?url=${encodeURIComponent(address)}`);
  await page.locator('dialog.question').waitFor();
}

const shows = (page, name) =>
  page.waitForFunction(
    (name) => document.querySelector('#source').textContent === name && !document.body.ariaBusy,
    name,
  );

const refused = (page) =>
  page.waitForFunction(() => document.querySelector('#alert').textContent !== '');

const agree = (page) => page.locator('.question .primary').click();

/** A ball with its buffer in a file of its own. */
async function ballInParts() {
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(5)));
  const { json, resources } = await io.writeJSON(document);
  const [buffer] = json.buffers;
  const bytes = Buffer.from(resources[buffer.uri]);
  buffer.uri = 'parts/ball.bin';
  return { text: JSON.stringify(json), bytes };
}

test('a link opens its mesh after asking, and nothing is fetched before', async (t) => {
  const asked = [];
  const page = await openPage(t, {
    prepare: (page) => play(page, { '/a/ring.obj': { body: CUBE } }, asked),
  });
  await follow(page, `${HOST}/a/ring.obj`);
  assert.match(await textOf(page, '.question'), /^Open ring\.obj from models\.example\?/);
  assert.match(await textOf(page, '.question'), /and the files it refers to/);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Open');
  await settled(page);
  await page.keyboard.press('Escape');
  await page.locator('dialog').first().waitFor({ state: 'hidden' });
  assert.equal(await page.locator('.question').count(), 0);
  assert.deepEqual(asked, []);
  assert.equal(await textOf(page, '#alert'), '');

  await follow(page, `${HOST}/a/ring.obj`);
  await page.keyboard.press('Enter');
  await shows(page, 'ring.obj');
  assert.deepEqual(asked, ['/a/ring.obj']);
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('with a mesh come the files that it names, from its own folder only', async (t) => {
  const { text, bytes } = await ballInParts();
  const asked = [];
  const files = {
    '/m/ball.gltf': { body: text },
    '/m/parts/ball.bin': { body: bytes },
    '/m/cube.obj': {
      body: `mtllib ../out.mtl a b.mtl\n${CUBE}`,
    },
    '/m/a%20b.mtl': {
      body: 'newmtl x\nmap_Kd -s 2 2 2 red.png\nmap_Bump https://other.example/x.png\n',
    },
  };
  const page = await openPage(t, { expected: /404/, prepare: (page) => play(page, files, asked) });
  await follow(page, `${HOST}/m/ball.gltf`);
  await agree(page);
  await shows(page, 'ball.gltf');
  assert.deepEqual(asked.splice(0), ['/m/ball.gltf', '/m/parts/ball.bin']);
  await follow(page, `${HOST}/m/cube.obj`);
  await agree(page);
  await shows(page, 'cube.obj');
  assert.equal(await textOf(page, '#alert'), '');
  assert.deepEqual(asked, ['/m/cube.obj', '/m/a%20b.mtl', '/m/red.png']);
});

test('what goes wrong is said in one sentence: what, where, and what to do', async (t) => {
  const files = {
    '/empty.obj': {},
    '/closed.obj': { headers: { 'Access-Control-Allow-Origin': HOST }, body: CUBE },
    '/private.obj': { status: 403 },
    '/broken.obj': { status: 500 },
    '/page': { headers: { ...OPEN_TO_ALL, 'Content-Type': 'text/html' }, body: '<p>' },
  };
  const page = await openPage(t, {
    expected: /404|403|500|CORS|ERR_FAILED/,
    prepare: (page) => play(page, files),
  });
  for (const [path, pattern] of [
    ['/none.obj', /^models\.example has no none\.obj \(404\)\. Check the address\./],
    ['/empty.obj', /^empty\.obj at models\.example is empty\./],
    [
      '/closed.obj',
      /^closed\.obj could not be fetched from models\.example: .*CORS\)\. Download the file/,
    ],
    ['/private.obj', /^models\.example requires you to sign in for private\.obj \(403\)\./],
    ['/broken.obj', /^models\.example did not send broken\.obj \(500\)\. Try again later/],
    ['/page', /^models\.example sent a web page instead of page\./],
  ]) {
    await follow(page, HOST + path);
    await settled(page);
    await agree(page);
    await refused(page);
    assert.match(await textOf(page, '#alert'), pattern);
    assert.equal(await sampleOf(page), 'head', 'the mesh that is open stays');
  }
});

test('only https is fetched, other than from the server of the page', async (t) => {
  const page = await openPage(t);
  for (const [address, pattern] of [
    ['http://models.example/a.obj', /does not begin with https:/],
    ['https://me:secret@models.example/a.obj', /contains a password/],
    ['data:text/plain,v', /does not begin with https:/],
    ['https://', /is not an address/],
  ]) {
    await page.goto(`${page.url().replace(/\?.*/, '')}?url=${encodeURIComponent(address)}`);
    await settled(page);
    assert.match(await textOf(page, '#alert'), pattern, 'also when the sample has been opened');
    assert.equal(await page.locator('.question').count(), 0);
  }
});

test('the size of a file beside the page is shown before it is fetched', async (t) => {
  const body = grid(40);
  const page = await openPage(t, {
    prepare: (page) =>
      page.route('**/near.obj', (route) =>
        route.fulfill({ headers: { 'Content-Length': `${body.length}` }, body }),
      ),
  });
  await follow(page, 'near.obj');
  assert.match(await textOf(page, '.question'), /this mesh \(0\.1\sMB\)/);
  await agree(page);
  await shows(page, 'near.obj');
});

test('a large file is asked about again, and can be declined', async (t) => {
  const headers = { ...OPEN_TO_ALL, 'Content-Length': '300000000' };
  const page = await openPage(t, {
    prepare: (page) =>
      page.addInitScript((headers) => {
        const { fetch } = globalThis;
        globalThis.fetch = async (url, options) =>
          String(url).endsWith('large.obj')
            ? new Response('v 0 0 0\n', { headers })
            : fetch(url, options);
      }, headers),
  });
  await follow(page, `${HOST}/large.obj`);
  await settled(page);
  await agree(page);
  await page.getByText('Fetch 300').waitFor();
  await page.locator('.question').getByText('Cancel').click();
  await page.waitForFunction(() => document.querySelector('#run-text').textContent === 'Cancelled');
  assert.equal(await textOf(page, '#alert'), '');
});

test('the copy of the page for use offline holds nothing from elsewhere', async (t) => {
  const page = await openPage(t, {
    serviceWorkers: 'allow',
    prepare: (page) => play(page, { '/ring.obj': { body: CUBE } }),
  });
  await page.evaluate(async () => (await navigator.serviceWorker.ready).active);
  await follow(page, `${HOST}/ring.obj`);
  assert.ok(await page.evaluate(() => navigator.serviceWorker.controller !== null));
  await agree(page);
  await shows(page, 'ring.obj');
  const kept = await page.evaluate(async () => {
    const found = [];
    for (const name of await caches.keys())
      for (const { url } of await (await caches.open(name)).keys()) found.push(new URL(url).host);
    return [...new Set(found)];
  });
  assert.deepEqual(kept, [new URL(page.url()).host]);
});

test('a part of the page that cannot be loaded is named as such', async (t) => {
  const page = await openPage(t, {
    expected: /ERR_FAILED/,
    prepare: (page) => page.route('**/web-sheet-*', (route) => route.abort()),
  });
  await page.goto(`${page.url()}?url=${encodeURIComponent(`${HOST}/ring.obj`)}`);
  await refused(page);
  // What is said while the sample is opened is said again at the end.
  await settled(page);
  assert.match(
    await textOf(page, '#alert'),
    /^A part of this page could not be loaded\. Check the/,
  );
});

test('fetching shows how far it is and can be cancelled', async (t) => {
  const page = await openPage(t, {
    prepare: (page) =>
      page.addInitScript(() => {
        const { fetch } = globalThis;
        const slow = (signal) =>
          new ReadableStream({
            start(controller) {
              controller.enqueue(new Uint8Array(5e6));
              const timer = setInterval(() => controller.enqueue(new Uint8Array(1e3)), 50);
              signal.addEventListener('abort', () => {
                clearInterval(timer);
                controller.error(signal.reason);
              });
            },
          });
        globalThis.fetch = async (url, options) =>
          String(url).endsWith('slow.obj')
            ? new Response(slow(options.signal), { headers: { 'Content-Length': '20000000' } })
            : fetch(url, options);
      }),
  });
  await follow(page, `${HOST}/slow.obj`);
  await settled(page);
  await agree(page);
  await page.waitForFunction(() =>
    /^Fetching slow\.obj: 5\.\d of 20\.0\sMB$/.test(
      document.querySelector('#run-text').textContent,
    ),
  );
  assert.ok(await page.evaluate(() => document.querySelector('#progress').value > 0.2));
  await page.click('#cancel');
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
  assert.equal(await sampleOf(page), 'head');
});

test('the question has no faults that axe finds, in either theme, and fits a phone', async (t) => {
  for (const [colorScheme, viewport] of [
    ['dark', { width: 1280, height: 720 }],
    ['light', { width: 390, height: 844 }],
  ]) {
    const page = await openPage(t, { colorScheme, viewport, hasTouch: viewport.width < 400 });
    await follow(page, `${HOST}/${'long-name-'.repeat(12)}.gltf?token=${'0123456789'.repeat(30)}`);
    await settled(page);
    await page.evaluate(axe.source);
    const found = await page.evaluate(async () => (await globalThis.axe.run('dialog')).violations);
    assert.deepEqual(
      found.map(({ id }) => id),
      [],
    );
    const box = await page.locator('.question').boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= viewport.width, JSON.stringify(box));
    assert.ok(box.y >= 0 && box.y + box.height <= viewport.height, JSON.stringify(box));
    if (process.env.PICTURES)
      await page.screenshot({ path: `${process.env.PICTURES}/question-${colorScheme}.png` });
    await (viewport.width < 400
      ? page.locator('.question').getByText('Cancel').tap()
      : page.keyboard.press('Escape'));
  }
});
