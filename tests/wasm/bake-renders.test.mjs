// A document looks as before once its textures have followed a new layout: drawn by three.js in
// Chromium, where images are decoded without help.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { buildSync } from 'esbuild';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { createStaticServer, listen } from '../../scripts/serve.mjs';
import { startBrowser } from '../../web/scripts/browser.mjs';
import { ringAndBall } from '../support/ring-and-ball.mjs';
import { DIST, ROOT } from './support/paths.mjs';

const hasChrome = findChrome() !== undefined;
const NEEDS_CHROME = { skip: hasChrome ? false : 'there is no Chromium' };

let browser;
let folder;
let server;
let page;

before(async () => {
  if (!hasChrome) return;
  mkdirSync(join(ROOT, 'build/tests'), { recursive: true });
  folder = mkdtempSync(join(ROOT, 'build/tests/wasm-renders-'));
  cpSync(DIST, join(folder, 'dist'), { recursive: true });
  buildSync({
    entryPoints: [fileURLToPath(new URL('./renders/page.mjs', import.meta.url))],
    bundle: true,
    format: 'esm',
    target: 'es2022',
    outfile: join(folder, 'main.js'),
    // The package stays as it is, with its workers.
    external: ['abflat', 'abflat/gltf', 'node:*'],
    nodePaths: [join(ROOT, 'node_modules')],
  });
  const imports = { abflat: './dist/index.js', 'abflat/gltf': './dist/gltf.js' };
  writeFileSync(
    join(folder, 'index.html'),
    `<!doctype html><link rel="icon" href="data:,"><title>renders</title>
    <script type="importmap">${JSON.stringify({ imports })}</script>
    <script type="module" src="./main.js"></script>`,
  );
  server = createStaticServer(folder);
  const port = await listen(server, '127.0.0.1', 0, false);
  browser = await startBrowser({ webgl: true });
  page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${port}/`);
  await page.waitForFunction(() => window.compare);
});
after(async () => {
  await browser?.close();
  server?.close();
  if (folder) rmSync(folder, { recursive: true });
});

// Packing keeps how much a layout is stretched, and with it what three.js then lacks tangents for.
for (const [name, normalTexture] of Object.entries({
  unwrap: { index: 1, scale: 0.8 },
  pack: undefined,
}))
  test(`after ${name}, twelve views look as before`, NEEDS_CHROME, async (t) => {
    const run = ([what, glb, given]) => window.compare(what, glb, given);
    const glb = ringAndBall(normalTexture).toString('base64');
    const argument = [name, glb, { resolution: 1024, padding: 8 }];
    const { views, images, contrast } = await page.evaluate(run, argument);
    t.diagnostic(views.map(({ mean }) => `${(100 * mean).toFixed(2)} %`).join(', '));
    t.diagnostic(images.map((image) => image.join(' ')).join(', '));
    assert.equal(views.length, 12);
    for (const { mean, share } of views) {
      assert.ok(mean < 0.01, `${100 * mean} %`);
      assert.ok(share > 0.1, 'little of the picture is compared');
    }
    assert.ok(contrast > 0.05, 'views differ by more than that from each other');
  });
