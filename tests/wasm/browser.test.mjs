// The package in Chromium: on a plain page, in a Vite build, and across origins. The pages are the
// README's examples.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { createStaticServer, ISOLATED, listen } from '../../scripts/serve.mjs';
import { startBrowser } from '../../web/scripts/browser.mjs';
import { EXAMPLE_OBJ, examples } from './support/examples.mjs';
import { DIST, ROOT } from './support/paths.mjs';

const hasChrome = findChrome() !== undefined;
const NEEDS_CHROME = { skip: hasChrome ? false : 'there is no Chromium' };

let browser;
let folder;
const servers = [];

before(async () => {
  if (!hasChrome) return;
  // Inside the repository, so that bundlers find its node_modules.
  mkdirSync(join(ROOT, 'build/tests'), { recursive: true });
  folder = mkdtempSync(join(ROOT, 'build/tests/wasm-browser-'));
  browser = await startBrowser({ webgl: false });
});
after(async () => {
  await browser?.close();
  for (const server of servers) server.close();
  if (folder) rmSync(folder, { recursive: true });
});

async function serve(root, headers = {}) {
  const server = createStaticServer(root);
  server.prependListener('request', (_, response) => {
    for (const [name, value] of Object.entries(headers)) response.setHeader(name, value);
  });
  servers.push(server);
  return `http://127.0.0.1:${await listen(server, '127.0.0.1', 0, false)}`;
}

/** A folder with files, and the package where npm would install it. */
function site(name, files) {
  const root = join(folder, name);
  cpSync(DIST, join(root, 'node_modules/abflat/dist'), { recursive: true });
  for (const [path, text] of Object.entries(files)) writeFileSync(join(root, path), text);
  return root;
}

async function open(address) {
  const page = await browser.newPage();
  const problems = [];
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error' && !message.text().includes('favicon'))
      problems.push(message.text());
  });
  await page.goto(address);
  return { page, problems };
}

async function assertShows(address, pattern) {
  const { page, problems } = await open(address);
  await page.waitForFunction(() => document.body?.textContent.includes('valid'), null, {
    timeout: 30_000,
  });
  assert.match(await page.textContent('body'), pattern);
  assert.deepEqual(problems, []);
  await page.close();
}

const EMPTY = '<!doctype html><link rel="icon" href="data:,"><title>abflat</title>';

test('a plain page with modules', NEEDS_CHROME, async () => {
  const html = examples().page.replace('<!doctype html>', EMPTY);
  const root = site('plain', { 'index.html': html, 'mesh.obj': EXAMPLE_OBJ });
  await assertShows(`${await serve(root)}/`, /^\s*valid: true/);
});

test('a Vite build', NEEDS_CHROME, async (context) => {
  const require = createRequire(join(ROOT, 'web/package.json'));
  let path;
  try {
    path = require.resolve('vite');
  } catch {
    context.skip('vite is not installed');
    return;
  }
  const vite = await import(pathToFileURL(path.replace(/index\.cjs$/, 'dist/node/index.js')));
  const root = join(folder, 'vite');
  mkdirSync(root);
  writeFileSync(
    join(root, 'index.html'),
    `${EMPTY}<script type="module" src="./main.js"></script>`,
  );
  writeFileSync(join(root, 'main.js'), examples().vite);
  await vite.build({ root, logLevel: 'warn', configFile: false });
  for (const headers of [{}, ISOLATED])
    await assertShows(
      `${await serve(join(root, 'dist'), headers)}/`,
      /^\s*valid: true, \d+ texcoords/,
    );
});

/** Runs a function in a page that serves the package; `path` is where its modules are. */
async function inPage(name, action, argument) {
  const address = await serve(site(name, { 'index.html': EMPTY }));
  const { page } = await open(`${address}/`);
  const result = await page.evaluate(action, {
    entry: `${address}/node_modules/abflat/dist/index.js`,
    ...argument,
  });
  await page.close();
  return result;
}

test('a browser without vectors is told so before anything is loaded', NEEDS_CHROME, async () => {
  const found = await inPage('builds', async ({ entry }) => {
    const { createAbflat } = await import(entry);
    const loaded = () =>
      performance
        .getEntriesByType('resource')
        .map(({ name }) => name.split('/').at(-1))
        .filter((name) => name.endsWith('.wasm'));
    const { validate } = WebAssembly;
    WebAssembly.validate = () => false;
    const refused = await createAbflat().catch(({ code, message }) => `${code}: ${message}`);
    const before = loaded();
    WebAssembly.validate = validate;
    const { build } = await createAbflat();
    return { refused, before, build, files: loaded() };
  });
  const { refused, ...others } = found;
  assert.match(refused, /^UnsupportedHost: abflat needs WebAssembly with 128-bit vectors .*91.*89/);
  assert.deepEqual(others, { before: [], build: 'simd', files: ['abflat-simd.wasm'] });
});

test('abort and errors in a page', NEEDS_CHROME, async () => {
  const results = await inPage('abort', async ({ entry }) => {
    const { AbflatError, createAbflat } = await import(entry);
    const abflat = await createAbflat();
    const controller = new AbortController();
    const head = await abflat.sample('head', { detail: 20 });
    const aborted = await abflat
      .flatten(head, { signal: controller.signal, onProgress: () => controller.abort() })
      .catch((error) => error.name);
    const small = await abflat.sample('hemisphere');
    const { report } = await abflat.flatten(small);
    const error = await abflat
      .flatten({ ...small, indices: small.indices.slice(0, 6), positions: new Float64Array(3) })
      .catch((e) => e);
    const missing = await createAbflat({ wasmUrl: '/nowhere.wasm' }).catch((e) => e);
    const noWorker = await createAbflat({ workerUrl: '/nowhere.js' }).catch((e) => e);
    const describe = (e) => [e instanceof AbflatError, e.code, e.message];
    return {
      aborted,
      valid: report.valid,
      kept: small.positions.length > 0,
      error: describe(error),
      missing: describe(missing),
      noWorker: describe(noWorker),
    };
  });
  assert.equal(results.aborted, 'AbortError');
  assert.equal(results.valid, true);
  assert.equal(results.kept, true);
  assert.deepEqual(results.error.slice(0, 2), [true, 'InvalidMesh']);
  assert.deepEqual(results.missing.slice(0, 2), [true, 'UnreadableFile']);
  assert.match(results.missing[2], /nowhere\.wasm.*404/);
  assert.deepEqual(results.noWorker.slice(0, 2), [true, 'UnreadableFile']);
  assert.match(results.noWorker[2], /nowhere\.js/);
});

test('worker and module on another origin', NEEDS_CHROME, async () => {
  const other = await serve(DIST, { 'Access-Control-Allow-Origin': '*' });
  const valid = await inPage(
    'origins',
    async ({ entry, other }) => {
      const { createAbflat } = await import(entry);
      const abflat = await createAbflat({
        workerUrl: `${other}/worker.js`,
        wasmUrl: `${other}/abflat-simd.wasm`,
      });
      return (await abflat.flatten(await abflat.sample('hemisphere'))).report.valid;
    },
    { other },
  );
  assert.equal(valid, true);
});

test('the whole package on another origin', NEEDS_CHROME, async () => {
  const other = await serve(DIST, { 'Access-Control-Allow-Origin': '*' });
  const valid = await inPage(
    'foreign',
    async ({ other }) => {
      const { createAbflat } = await import(`${other}/index.js`);
      const abflat = await createAbflat();
      return (await abflat.flatten(await abflat.sample('hemisphere'))).report.valid;
    },
    { other },
  );
  assert.equal(valid, true);
});

test('memory that does not suffice in a page', NEEDS_CHROME, async () => {
  const [code, valid] = await inPage('memory', async ({ entry }) => {
    const { createAbflat } = await import(entry);
    const abflat = await createAbflat({ maxMemory: 32 * 2 ** 20 });
    const large = await abflat.sample('hemisphere', { detail: 60 }).catch((e) => e.code);
    const code = large.positions ? await abflat.flatten(large).catch((e) => e.code) : large;
    const { report } = await abflat.flatten(await abflat.sample('hemisphere'));
    return [code, report.valid];
  });
  assert.equal(code, 'OutOfMemory');
  assert.equal(valid, true);
});

/** Packs a triangle and bakes it; `names` are those of the files that are loaded for that. */
const LATER = `
  const packAndBake = async (abflat) => {
    const names = () =>
      performance.getEntriesByType('resource').flatMap(({ name }) => name.match(/(pack|bake)\\S*\\.wasm/)?.[1] ?? []);
    const before = names();
    const mesh = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], texcoords: [0, 0, 1, 0, 0, 1] };
    const image = { data: new Uint8ClampedArray(64).fill(77), width: 4, height: 4 };
    const [layout] = await Promise.all([abflat.pack(mesh), abflat.pack(mesh)]);
    const { data, width } = await abflat.bake(mesh, layout, { image });
    const made = new ImageData(data, width);
    document.body.textContent =
      'valid: ' + JSON.stringify([before, names().sort(), layout.uv.length, made.width]);
  };
`;
const PACKED_AND_BAKED = /valid: \[\[\],\["bake","pack"\],6,16\]/;

test(
  'what packs and what bakes is loaded with the first call, and runs in a worker',
  NEEDS_CHROME,
  async () => {
    const code = `
    import { createAbflat } from './node_modules/abflat/dist/index.js';
    ${LATER}
    packAndBake(await createAbflat());
  `;
    const html = `${EMPTY}<script type="module">${code}</script><body></body>`;
    const root = site('later', { 'index.html': html });
    for (const headers of [{}, ISOLATED])
      await assertShows(`${await serve(root, headers)}/`, PACKED_AND_BAKED);
  },
);

test('a Vite build packs and bakes', NEEDS_CHROME, async () => {
  const require = createRequire(join(ROOT, 'web/package.json'));
  const path = require.resolve('vite');
  const vite = await import(pathToFileURL(path.replace(/index\.cjs$/, 'dist/node/index.js')));
  const root = join(folder, 'vite-later');
  mkdirSync(root);
  writeFileSync(
    join(root, 'index.html'),
    `${EMPTY}<script type="module" src="./main.js"></script>`,
  );
  writeFileSync(
    join(root, 'main.js'),
    `import { createAbflat } from 'abflat'; ${LATER} createAbflat().then(packAndBake);`,
  );
  await vite.build({ root, logLevel: 'warn', configFile: false });
  await assertShows(`${await serve(join(root, 'dist'))}/`, PACKED_AND_BAKED);
});

test('pack and bake run in worker.js, and from baseUrl', NEEDS_CHROME, async () => {
  const sides = await inPage('later-places', async ({ entry }) => {
    const { createAbflat } = await import(entry);
    const dist = new URL('.', entry);
    const mesh = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], texcoords: [0, 0, 1, 0, 0, 1] };
    const sides = [];
    for (const settings of [{ workerUrl: new URL('worker.js', dist) }, { baseUrl: dist }]) {
      const abflat = await createAbflat(settings);
      const { width } = await abflat.bake(mesh, await abflat.pack(mesh), { factor: [1, 0, 0, 1] });
      sides.push(width);
      abflat.terminate();
    }
    return sides;
  });
  assert.deepEqual(sides, [1024, 1024]);
});
