// The page without a connection after one visit, and builds that follow one another.

import assert from 'node:assert/strict';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { WEB_DIST } from '../../scripts/lib/paths.mjs';
import { createStaticServer, HEADERS, listen } from '../../scripts/serve.mjs';
import { newContext, startBrowser } from '../../web/scripts/browser.mjs';
import { listBuild, writeWorker } from '../../web/scripts/offline.mjs';
import { withDraco, withMeshopt } from '../support/compressed-by-exporters.mjs';
import { addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { paintedCube } from '../support/painted-cube.mjs';
import { grid } from '../support/small-meshes.mjs';
import { sphere } from '../support/surfaces.mjs';
import { dropAndWait, exportMesh, settled, textOf } from './page.mjs';

/** Below which the page is, as on a server with other pages. */
const PLACE = 'tools/abflat';

let folder;
let browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-offline-'));
  browser = await startBrowser({ antialias: false });
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** What is built, without compressed copies. */
function copyBuild(name) {
  const site = join(folder, name);
  const isPlain = (path) => !/\.(br|gz)$/.test(path);
  cpSync(WEB_DIST, join(site, PLACE), { recursive: true, filter: isPlain });
  return site;
}

/** Another build: each file in assets/ has another name, and index.html says which build it is. */
function nextBuild(name) {
  const site = copyBuild(name);
  const place = join(site, PLACE);
  const names = readdirSync(join(place, 'assets'));
  const renamed = (file) => file.replace(/.{4}(\.\w+)$/, 'next$1');
  const texts = [
    'index.html',
    ...names.filter((file) => /\.(js|css)$/.test(file)).map((file) => `assets/${file}`),
  ];
  for (const path of texts) {
    let text = readFileSync(join(place, path), 'utf8');
    for (const file of names) text = text.replaceAll(file, renamed(file));
    writeFileSync(join(place, path), text.replace('<html ', `<html data-build="${name}" `));
  }
  for (const file of names)
    renameSync(join(place, 'assets', file), join(place, 'assets', renamed(file)));
  rewriteWorker(place, HEADERS);
  return site;
}

function rewriteWorker(place, headers) {
  const [, ...lines] = readFileSync(join(place, 'sw.js'), 'utf8').split('\n');
  writeWorker(place, lines.join('\n'), headers);
}

/** A server whose `folders` may be exchanged, and which can be away. */
async function serveSites(t, ...folders) {
  let server;
  let port = 0;
  const start = async () => {
    server = createStaticServer(folders, HEADERS);
    port = await listen(server, '127.0.0.1', port, false);
  };
  const stop = () => {
    server.closeAllConnections();
    server.close();
  };
  await start();
  t.after(stop);
  return { folders, url: `http://127.0.0.1:${port}/${PLACE}/`, start, stop };
}

async function newVisitor(t, { expected } = {}) {
  const context = await newContext(browser, { serviceWorkers: 'allow' });
  const problems = [];
  context.on('console', (message) => {
    const isRest = message.type() !== 'error' || message.location().url.endsWith('/favicon.ico');
    if (!isRest && !expected?.test(message.text()))
      problems.push(`${message.text()} ${message.location().url}`);
  });
  context.on('weberror', (error) => problems.push(String(error.error())));
  t.after(async () => {
    await context.close();
    assert.deepEqual(problems, [], 'errors in the console of the page');
  });
  const newPage = async () => {
    const page = await context.newPage();
    page.setDefaultTimeout(120_000);
    return page;
  };
  return { newPage };
}

/** Loads the page and waits until it is kept. */
async function visit(page, url) {
  await page.goto(url);
  await settled(page);
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
}

async function reload(page) {
  await page.reload();
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
}

/** Has the browser look for another build; resolves once that is kept, or has been refused. */
const lookForUpdate = (page) =>
  page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    await registration.update();
    // Loading the page has the browser look as well, so that it may have been kept before.
    const worker = registration.installing ?? registration.waiting;
    await new Promise((resolve) => {
      worker.onstatechange = resolve;
      if (worker.state !== 'installing') resolve();
    });
    return worker.state;
  });

const buildOf = (page) => page.evaluate(() => document.documentElement.dataset.build ?? 'first');

/** Names in assets/ that the page and its workers have asked for. */
const loadedAssets = (page) =>
  page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({ name }) => name.split('/assets/')[1])
      .filter(Boolean),
  );

const cacheNames = (page) => page.evaluate(() => caches.keys());

async function glb(compress) {
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(5)));
  return compress(document);
}

async function openAll(page) {
  await dropAndWait(page, 'waves.obj', grid(6));
  assert.equal(await textOf(page, '#source'), 'waves.obj');
  assert.match(readFileSync((await exportMesh(page)).path, 'utf8'), /^vt /m);
  for (const [name, compress] of [
    ['plain.glb', (document) => io.writeBinary(document)],
    ['draco.glb', withDraco],
    ['meshopt.glb', withMeshopt],
  ]) {
    await dropAndWait(page, name, await glb(compress));
    assert.equal(await textOf(page, '#alert'), '');
    assert.equal(await textOf(page, '#source'), name);
  }
}

test('after one visit the page works without a server, in a folder of a site and with threads', async (t) => {
  const server = await serveSites(t, copyBuild('first'));
  const page = await (await newVisitor(t)).newPage();
  await visit(page, server.url);
  assert.equal(await page.evaluate(() => navigator.serviceWorker.controller), null);
  server.stop();

  await reload(page);
  assert.ok(await page.evaluate(() => navigator.serviceWorker.controller !== null));
  assert.ok(await page.evaluate(() => crossOriginIsolated));
  const modules = (await loadedAssets(page)).filter((name) => /^abflat.*wasm$/.test(name));
  assert.match(modules.join(), /^abflat-threads-[^,]*$/);
  await openAll(page);
  await dropAndWait(page, 'cube.glb', paintedCube());
  await page.click('#export-formats');
  await page.getByRole('menuitemcheckbox', { name: 'Bake textures' }).click();
  await page.keyboard.press('Escape');
  const { path } = await exportMesh(page);
  assert.equal(await textOf(page, '#alert'), '');
  const [baked] = (await io.readBinary(readFileSync(path))).getRoot().listTextures();
  assert.equal(baked.getName(), 'baseColor');

  await page.goto(`${server.url}index.html?from=elsewhere#top`);
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  await server.start();
});

test('a module that another visit needs is kept once it was fetched', async (t) => {
  const server = await serveSites(t, copyBuild('modules'));
  const page = await (await newVisitor(t)).newPage();
  await visit(page, server.url);
  await reload(page);
  // What a page asks for that has lost its threads.
  const [path] = listBuild(WEB_DIST, HEADERS).modules.simd;
  const sizeOf = () =>
    page.evaluate(async (path) => (await (await fetch(path)).arrayBuffer()).byteLength, path);
  const size = await sizeOf();
  await page.waitForFunction((path) => caches.match(path), path);
  server.stop();
  assert.equal(await sizeOf(), size);
  await server.start();
});

test('another build is used from the next load on, whole, and pages that are open keep theirs', async (t) => {
  const first = copyBuild('first-of-two');
  const second = nextBuild('second');
  const server = await serveSites(t, first);
  const { newPage } = await newVisitor(t);
  const page = await newPage();
  await visit(page, server.url);
  await reload(page);

  server.folders[0] = second;
  assert.equal(await lookForUpdate(page), 'installed');
  const other = await newPage();
  await other.goto(server.url);
  await settled(other);
  server.stop();
  await reload(other);
  assert.equal(await buildOf(other), 'second');
  for (const name of await loadedAssets(other)) assert.match(name, /next\.\w+$/);
  // Decoders have not been loaded yet.
  for (const each of [other, page]) {
    await dropAndWait(each, 'draco.glb', await glb(withDraco));
    assert.equal(await textOf(each, '#alert'), '');
    assert.equal(await textOf(each, '#source'), 'draco.glb');
  }
  assert.equal(await buildOf(page), 'first');
  await server.start();

  assert.equal((await cacheNames(page)).length, 3);
  await page.close();
  await other.close();
  const last = await newPage();
  await visit(last, server.url);
  assert.equal(await buildOf(last), 'second');
  await last.waitForFunction(async () => (await caches.keys()).length === 2);

  // Back to the first one.
  server.folders[0] = first;
  assert.equal(await lookForUpdate(last), 'installed');
  server.stop();
  await reload(last);
  assert.equal(await buildOf(last), 'first');
  await server.start();
});

test('half of a build is not kept', async (t) => {
  const first = copyBuild('whole');
  const half = join(folder, 'half');
  mkdirSync(join(half, PLACE), { recursive: true });
  cpSync(join(nextBuild('half-built'), PLACE, 'sw.js'), join(half, PLACE, 'sw.js'));
  const server = await serveSites(t, first);
  const page = await (await newVisitor(t, { expected: /integrity|404/ })).newPage();
  await visit(page, server.url);
  await reload(page);
  server.folders.unshift(half);
  assert.equal(await lookForUpdate(page), 'redundant');
  assert.equal((await cacheNames(page)).length, 2);
  server.stop();
  await reload(page);
  assert.equal(await buildOf(page), 'first');
  await server.start();
});

test('where the page was taken away, it is gone with the next load', async (t) => {
  const server = await serveSites(t, copyBuild('gone'));
  const page = await (await newVisitor(t, { expected: /404|integrity/ })).newPage();
  await visit(page, server.url);
  await reload(page);
  const nothing = join(folder, 'nothing', PLACE);
  mkdirSync(nothing, { recursive: true });
  writeFileSync(join(nothing, 'index.html'), '<p>Another page');
  server.folders[0] = join(folder, 'nothing');
  await reload(page);
  await page.waitForFunction(async () => (await caches.keys()).length === 1);
  await page.reload();
  assert.equal(await textOf(page, 'p'), 'Another page');
  await page.waitForFunction(async () => {
    const registrations = await navigator.serviceWorker.getRegistrations();
    return registrations.length === 0 && (await caches.keys()).length === 0;
  });
});

test('what the browser has thrown away is kept again', async (t) => {
  const server = await serveSites(t, copyBuild('thrown-away'));
  const page = await (await newVisitor(t)).newPage();
  await visit(page, server.url);
  await page.evaluate(async () => {
    for (const name of await caches.keys()) await caches.delete(name);
  });
  await reload(page);
  await page.waitForFunction(
    (url) => caches.match(url, { cacheName: `abflat ${url}` }),
    server.url,
  );
  server.stop();
  await reload(page);
  await server.start();
});

test('a browser that keeps nothing shows the page all the same', async (t) => {
  const server = await serveSites(t, copyBuild('refused'));
  const page = await (await newVisitor(t)).newPage();
  await page.addInitScript(() => {
    navigator.serviceWorker.register = () => Promise.reject(new Error('no room'));
  });
  await page.goto(server.url);
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('the list has every file of the page once, with what is sent for it', () => {
  const { files, modules, version } = listBuild(WEB_DIST, HEADERS);
  const isOfPage = (name) => !/\.(br|gz|txt)$|^sw\.js$/.test(name);
  const names = readdirSync(WEB_DIST, { recursive: true }).filter(
    (name) => /\.\w+$/.test(name) && isOfPage(name),
  );
  const listed = [...files, ...Object.values(modules)].map(([path]) => path);
  assert.deepEqual(
    listed.map((path) => (path === './' ? 'index.html' : path)).sort(),
    names.sort(),
  );
  for (const path of listed) assert.ok(existsSync(join(WEB_DIST, path)), path);
  assert.deepEqual(Object.keys(modules).sort(), ['simd', 'threads']);
  const [line] = readFileSync(join(WEB_DIST, 'sw.js'), 'utf8').split('\n');
  assert.equal(line, `const BUILD = ${JSON.stringify({ version, files, modules })};`);
  assert.notEqual(listBuild(WEB_DIST, {}).version, version);
});
