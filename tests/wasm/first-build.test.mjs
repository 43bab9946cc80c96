// A package with only one build: it stands in for the others, as when the page is first built.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { ISOLATED } from '../../scripts/serve.mjs';
import { placeModules } from '../../wasm/modules.mjs';
import { newContext, serveFolder, startBrowser } from '../../web/scripts/browser.mjs';
import { DIST, ROOT } from './support/paths.mjs';

const NEEDS_CHROME = { skip: findChrome() ? false : 'there is no Chromium' };

let folder;
before(() => {
  mkdirSync(join(ROOT, 'build/tests'), { recursive: true });
  folder = mkdtempSync(join(ROOT, 'build/tests/first-build-'));
  cpSync(DIST, join(folder, 'dist'), { recursive: true });
  placeModules(join(folder, 'dist'), ['simd']);
  writeFileSync(join(folder, 'index.html'), '<!doctype html><link rel="icon" href="data:,">');
});
after(() => rmSync(folder, { recursive: true }));

test('without threads it runs with vectors, and no error is seen', NEEDS_CHROME, async () => {
  const server = await serveFolder(folder, ISOLATED);
  const browser = await startBrowser({ webgl: false });
  const page = await (await newContext(browser)).newPage();
  const problems = [];
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await page.goto(server.url);
  const [isolated, build, valid] = await page.evaluate(async () => {
    const { createAbflat } = await import('./dist/index.js');
    const abflat = await createAbflat();
    const { report } = await abflat.flatten(await abflat.sample('hemisphere'));
    return [crossOriginIsolated, abflat.build, report.valid];
  });
  await browser.close();
  server.close();
  assert.equal(isolated, true, 'threads would run here');
  assert.deepEqual([build, valid, problems], ['simd', true, []]);
});

test('Node takes the same build', async () => {
  const { createAbflat } = await import(join(folder, 'dist/node.js'));
  const abflat = await createAbflat();
  assert.equal(abflat.build, 'simd');
  abflat.terminate();
});
