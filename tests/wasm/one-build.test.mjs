// Entries with one build: what a bundler emits for each, and that no other build runs.

import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { createAbflat as withSimd } from 'abflat/simd';
import { createAbflat as withThreads } from 'abflat/threads';
import { createStaticServer, ISOLATED, listen } from '../../scripts/serve.mjs';
import { DIST, ROOT } from './support/paths.mjs';
import { NEEDS_CHROME, whileTesting } from './support/while-testing.mjs';

const here = whileTesting('one-build');

const PAGE =
  '<!doctype html><link rel="icon" href="data:,"><body></body><script type="module" src="./main.js"></script>';
const codeFor = (entry) => `
  import { createAbflat } from '${entry}';
  async function show() {
    const abflat = await createAbflat();
    const { report } = await abflat.unwrap(await abflat.sample('hemisphere'));
    return abflat.build + ', valid: ' + report.valid;
  }
  show().catch(({ code, message }) => 'not valid: ' + code + ' ' + message)
    .then((text) => (document.body.textContent = text));
`;

/** The page of a Vite build, and the names of its files without their hashes. */
async function built(entry) {
  const path = createRequire(join(ROOT, 'web/package.json')).resolve('vite');
  const vite = await import(pathToFileURL(path.replace(/index\.cjs$/, 'dist/node/index.js')));
  const root = join(here.folder, entry.replace('/', '-'));
  mkdirSync(root);
  writeFileSync(join(root, 'index.html'), PAGE);
  writeFileSync(join(root, 'main.js'), codeFor(entry));
  await vite.build({ root, logLevel: 'warn', configFile: false });
  const names = readdirSync(join(root, 'dist/assets'));
  return { root: join(root, 'dist'), names: names.map((name) => name.replace(/-[\w-]{8}\./, '.')) };
}

async function shown(root, headers) {
  const server = createStaticServer(root, headers);
  here.servers.push(server);
  const page = await here.browser.newPage();
  try {
    await page.goto(`http://127.0.0.1:${await listen(server, '127.0.0.1', 0, false)}/`);
    await page.waitForFunction(() => document.body?.innerText.includes('valid'));
    return await page.innerText('body');
  } finally {
    await page.close();
  }
}

const LATER = ['abflat-bake.wasm', 'abflat-pack.wasm'];

test('abflat has both builds', NEEDS_CHROME, async () => {
  const { names } = await built('abflat');
  const modules = names.filter((name) => name.endsWith('.wasm'));
  assert.deepEqual(modules.sort(), [...LATER, 'abflat-simd.wasm', 'abflat-threads.wasm']);
});

test('abflat/simd brings nothing of threads, also on isolated pages', NEEDS_CHROME, async () => {
  const { root, names } = await built('abflat/simd');
  const modules = names.filter((name) => name.endsWith('.wasm'));
  assert.deepEqual(modules.sort(), [...LATER, 'abflat-simd.wasm']);
  assert.deepEqual(
    names.filter((name) => /threads/.test(name)),
    [],
  );
  for (const headers of [{}, ISOLATED])
    assert.equal(await shown(root, headers), 'simd, valid: true');
});

test('abflat/threads brings nothing of the other build', NEEDS_CHROME, async () => {
  const { root, names } = await built('abflat/threads');
  const modules = names.filter((name) => name.endsWith('.wasm'));
  assert.deepEqual(modules.sort(), [...LATER, 'abflat-threads.wasm']);
  assert.deepEqual(
    names.filter((name) => /simd/.test(name)),
    [],
  );
  assert.equal(await shown(root, ISOLATED), 'threads, valid: true');
  assert.match(await shown(root, {}), /^not valid: InvalidOption .*not cross-origin isolated/);
});

test('in Node each runs its build, and refuses the other', async () => {
  const all = [
    ['simd', withSimd, 'threads'],
    ['threads', withThreads, 'simd'],
  ];
  for (const [build, create, other] of all) {
    for (const options of [{}, { build }, { workers: 2 }, { baseUrl: DIST }]) {
      const abflat = await create(options);
      assert.equal(abflat.build, build);
      const mesh = await abflat.sample('hemisphere');
      assert.equal((await abflat.unwrap(mesh)).report.valid, true);
      abflat.terminate();
    }
    await assert.rejects(create({ build: other }), {
      code: 'InvalidOption',
      message: `build must be one of ${build}, not "${other}".`,
    });
    await assert.rejects(create({ wasmUrl: join(DIST, `abflat-${other}.wasm`) }), {
      code: 'InvalidOption',
      message: new RegExp(`build is ${build}, but .*abflat-${other}\\.wasm is ${other}`),
    });
  }
});
