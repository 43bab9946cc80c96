// The page under a strict content security policy, and without a connection.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { HEADERS } from '../../scripts/serve.mjs';
import { withDraco, withMeshopt } from '../support/compressed-by-exporters.mjs';
import { addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere, torus } from '../support/surfaces.mjs';
import { laterParts } from './later-parts.mjs';
import { drop, dropAndWait, exportMesh, openPage, settled, textOf } from './page.mjs';

/** Only the page's own files; `wasm-unsafe-eval` allows WebAssembly and nothing else. */
const POLICY = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'";
const ISOLATED = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

function ball() {
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(5)));
  return document;
}

/** A document with its buffer in a data URI. */
async function gltf() {
  const document = emptyDocument();
  addMesh(document, 'ring', primitiveOf(document, torus(12, 8)));
  const { json, resources } = await io.writeJSON(document);
  for (const buffer of json.buffers) {
    const bytes = Buffer.from(resources[buffer.uri]).toString('base64');
    buffer.uri = `data:application/octet-stream;base64,${bytes}`;
  }
  return JSON.stringify(json);
}

/** Everything that the page can do, once. */
async function doEverything(page) {
  await dropAndWait(page, 'ball.glb', await io.writeBinary(ball()));
  await exportMesh(page);
  await dropAndWait(page, 'ring.gltf', await gltf());
  assert.equal(await textOf(page, '#alert'), '');
  await exportMesh(page);
  for (const id of ['#layout-png', '#layout-heat', '#layout-svg'])
    await Promise.all([page.waitForEvent('download'), page.click(id)]);
  await page.click('#theme');
  await dropAndWait(page, 'waves.obj', grid(6));
  await page.click('#mode-flatten');
  await settled(page);
  await page.click('#details-toggle');
  await page.click('#tab-sweep');
  await page.click('#sweep');
  await page.waitForFunction(() => document.querySelector('#sweep').textContent !== 'Stop');
  await page.click('#tab-methods');
  await page.click('#compare');
  await page.waitForFunction(() => document.querySelector('.method-table'));
  await exportMesh(page);
  for (const name of ['PLY', 'GLB']) {
    await page.click('#export-formats');
    const item = page.getByRole('menuitemradio', { name });
    await Promise.all([page.waitForEvent('download'), item.click()]);
  }
  await page.click('#help');
  await page.keyboard.press('Escape');
}

for (const [name, headers] of [
  ['with threads', { ...ISOLATED, 'Content-Security-Policy': POLICY }],
  ['without threads', { 'Content-Security-Policy': POLICY }],
  ['as npm start sends it', undefined],
])
  test(`nothing violates a strict policy, ${name}`, async (t) => {
    // Violations in workers appear in the console, which is checked at the end.
    const page = await openPage(t, {
      headers,
      prepare: (page) =>
        page.addInitScript(() => {
          globalThis.violations = [];
          document.addEventListener(
            'securitypolicyviolation',
            ({ violatedDirective, blockedURI }) =>
              globalThis.violations.push(`${violatedDirective} ${blockedURI}`),
          );
        }),
    });
    await doEverything(page);
    for (const [name, compress] of [
      ['draco.glb', withDraco],
      ['meshopt.glb', withMeshopt],
    ]) {
      await dropAndWait(page, name, await compress(ball()));
      assert.equal(await textOf(page, '#alert'), '');
      assert.match(await textOf(page, '#notice'), /compressed/);
    }
    assert.deepEqual(await page.evaluate(() => globalThis.violations), []);
  });

test('the policy that is sent allows nothing inline, and nothing from elsewhere but to fetch', () => {
  const directives = HEADERS['Content-Security-Policy'].split(';').map((each) => each.trim());
  assert.ok(directives.includes("default-src 'self'"));
  // A mesh that a link names may be on any server; the page asks before it fetches one.
  const fetched = "connect-src 'self' https:";
  assert.ok(directives.includes(fetched));
  for (const directive of directives.filter((each) => each !== fetched))
    assert.match(directive, /^[\w-]+( '(self|none|wasm-unsafe-eval)')+$/);
});

test('nothing but a mesh that was agreed to comes from elsewhere', async (t) => {
  const asked = [];
  const page = await openPage(t, {
    expected: /Content Security Policy|violates/,
    prepare: (page) =>
      page.route(
        (url) => url.hostname !== '127.0.0.1' && url.protocol.startsWith('http'),
        (route) => {
          asked.push(route.request().url());
          return route.fulfill({
            headers: { 'Access-Control-Allow-Origin': '*' },
            body: 'globalThis.isForeign = true',
          });
        },
      ),
  });
  await doEverything(page);
  assert.deepEqual(asked, []);
  const fate = await page.evaluate(async () => {
    const script = document.createElement('script');
    script.src = 'https://models.example/a.js';
    const loaded = new Promise((done) => {
      script.onload = () => done('loaded');
      script.onerror = () => done('refused');
    });
    document.head.append(script);
    const plain = fetch('http://models.example/a.obj').then(
      () => 'loaded',
      () => 'refused',
    );
    return [await loaded, await plain, 'isForeign' in globalThis];
  });
  assert.deepEqual(fate, ['refused', 'refused', false]);
  assert.deepEqual(asked, []);
});

test('the theme is there before anything is painted', async (t) => {
  const page = await openPage(t, {
    colorScheme: 'light',
    prepare: (page) =>
      page.addInitScript(() => {
        // The first moment there is a body, before any of it is painted.
        new MutationObserver((_, observer) => {
          if (!document.body) return;
          globalThis.themeAtFirst = document.documentElement.dataset.theme;
          observer.disconnect();
        }).observe(document, { childList: true, subtree: true });
      }),
  });
  assert.equal(await page.evaluate(() => globalThis.themeAtFirst), 'light');
});

test('once loaded the page needs no connection, also after a run was cancelled', async (t) => {
  let rest;
  const page = await openPage(t, {
    prepare: (page) => {
      rest = laterParts(page);
    },
  });
  await rest;
  await page.context().setOffline(true);
  await doEverything(page);
  // The cancelled worker is replaced.
  await drop(page, 'ball.obj', objText(sphere(90)));
  await page.locator('#cancel:enabled').waitFor();
  await page.waitForFunction(() => document.body.ariaBusy);
  await page.click('#cancel');
  await settled(page);
  await dropAndWait(page, 'ring.obj', objText(torus(12, 8)));
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});
